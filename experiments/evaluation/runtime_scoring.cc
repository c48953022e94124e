// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/runtime_scoring.h"

#include <chrono>
#include <memory>

#include "lib/core/check.h"
#include "lib/core/error.h"

namespace handcraft::experiments {
namespace {

struct FreeWorkspace {
  void operator()(hc_workspace* workspace) const noexcept { hc_workspace_free(workspace); }
};

void ThrowUnlessOk(hc_status status, const std::string& path) {
  if (status == HC_OK) return;
  throw Error(
      {.kind = Error::Kind::kBadInput,
       .path = path,
       .reason = std::string("the model cannot score this image: ") + hc_status_message(status)});
}

}  // namespace

RuntimeScores ScoreWithRuntime(const hc_model* model,
                               const Image& image,
                               const std::string& path,
                               const Image* mask) {
  HC_CHECK(mask == nullptr || (mask->width() == image.width() && mask->height() == image.height() &&
                               mask->channels() == 1),
           path);
  hc_workspace* workspace = nullptr;
  ThrowUnlessOk(hc_workspace_create(model, image.width(), image.height(), &workspace), path);
  const std::unique_ptr<hc_workspace, FreeWorkspace> owner(workspace);
  const hc_image view = {image.values().data(),
                         image.width(),
                         image.height(),
                         std::int64_t{image.width()} * image.channels(),
                         image.channels() == 1 ? HC_GRAY8 : HC_BGR8};
  RuntimeScores scores;
  scores.probabilities = FloatImage(image.width(), image.height());
  const auto start = std::chrono::steady_clock::now();
  float* const map = scores.probabilities.Row(0);
  const std::int64_t width = image.width();
  const hc_status status =
      mask == nullptr
          ? hc_score_image(model, workspace, &view, map, width)
          : hc_score_mask(model, workspace, &view, mask->values().data(), width, map, width);
  const auto end = std::chrono::steady_clock::now();
  ThrowUnlessOk(status, path);
  scores.score_ms = std::chrono::duration<double, std::milli>(end - start).count();
  return scores;
}

std::vector<hc_point> FindBestPixels(const FloatImage& probabilities,
                                     int max_count,
                                     double min_probability,
                                     int suppression_radius_px) {
  HC_CHECK(max_count >= 1, max_count);
  std::vector<hc_point> points(static_cast<std::size_t>(max_count));
  std::size_t count = points.size();
  const hc_status status = hc_top_k(probabilities.Row(0),
                                    probabilities.width(),
                                    probabilities.height(),
                                    probabilities.width(),
                                    static_cast<float>(min_probability),
                                    suppression_radius_px,
                                    points.data(),
                                    &count);
  HC_CHECK(status == HC_OK, hc_status_message(status));
  points.resize(count);
  return points;
}

}  // namespace handcraft::experiments
