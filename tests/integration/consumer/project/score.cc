// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause
//
// score_cc MODEL: as score.c, from C++11 on.
#include <handcraft/handcraft_runtime.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 2) return 1;
  hc_error error;
  hc_model* loaded = nullptr;
  if (hc_model_load_file(argv[1], &loaded, &error) != HC_OK) {
    std::fprintf(stderr, "%s\n", error.message);
    return 1;
  }
  const std::unique_ptr<hc_model, void (*)(hc_model*)> model(loaded, hc_model_free);

  const int width = 64;
  const int height = 48;
  std::vector<std::uint8_t> pixels(width * height * 3);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i] = static_cast<std::uint8_t>(i * i % 251);
  }
  hc_workspace* created = nullptr;
  if (hc_workspace_create(model.get(), width, height, &created) != HC_OK) return 1;
  const std::unique_ptr<hc_workspace, void (*)(hc_workspace*)> workspace(created,
                                                                         hc_workspace_free);

  const hc_image image = {pixels.data(), width, height, width * 3, HC_BGR8};
  std::vector<float> probabilities(width * height);
  std::vector<hc_point> points(5);
  std::size_t count = points.size();
  if (hc_score_image(model.get(), workspace.get(), &image, probabilities.data(), width) != HC_OK ||
      hc_top_k(probabilities.data(), width, height, width, 0.0F, 4, points.data(), &count) !=
          HC_OK) {
    return 1;
  }
  for (std::size_t i = 0; i < count; ++i) {
    std::printf(
        "%d %d %.6f\n", points[i].u, points[i].v, static_cast<double>(points[i].probability));
  }
  return 0;
}
