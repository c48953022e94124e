/* SPDX-FileCopyrightText: 2026 the Handcraft authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * score_c MODEL: loads a grasp-point model, scores a picture and prints the best pixels. */
#include <handcraft/handcraft_runtime.h>
#include <stdio.h>

#define WIDTH 64
#define HEIGHT 48

static int Fail(const char* message) {
  fprintf(stderr, "%s\n", message);
  return 1;
}

int main(int argc, char** argv) {
  static uint8_t pixels[HEIGHT][WIDTH][3];
  static float probabilities[HEIGHT][WIDTH];
  const hc_image image = {&pixels[0][0][0], WIDTH, HEIGHT, WIDTH * 3, HC_BGR8};
  hc_model* model = NULL;
  hc_workspace* workspace = NULL;
  hc_error error;
  hc_point points[5];
  size_t count = 5;
  hc_status status;
  size_t i;

  if (argc != 2) return Fail("usage: score_c MODEL");
  if (hc_model_load_file(argv[1], &model, &error) != HC_OK) return Fail(error.message);
  for (i = 0; i < sizeof pixels; ++i) (&pixels[0][0][0])[i] = (uint8_t)(i * i % 251);
  status = hc_workspace_create(model, WIDTH, HEIGHT, &workspace);
  if (status == HC_OK) {
    status = hc_score_image(model, workspace, &image, &probabilities[0][0], WIDTH);
  }
  if (status == HC_OK) {
    status = hc_top_k(&probabilities[0][0], WIDTH, HEIGHT, WIDTH, 0.0F, 4, points, &count);
  }
  hc_workspace_free(workspace);
  hc_model_free(model);
  if (status != HC_OK) return Fail(hc_status_message(status));
  for (i = 0; i < count; ++i) {
    printf("%d %d %.6f\n", (int)points[i].u, (int)points[i].v, (double)points[i].probability);
  }
  return 0;
}
