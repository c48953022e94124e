// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <utility>

#include "experiments/evaluation/grasp_point_evaluation.h"
#include "experiments/evaluation/grasp_point_page.h"
#include "experiments/evaluation/report_pictures.h"
#include "experiments/evaluation/runtime_scoring.h"
#include "lib/core/file.h"
#include "lib/core/parallel.h"
#include "lib/perception/overlay.h"

namespace handcraft::experiments {
namespace {

// A page of sixty pictures stays below some 6 MB.
constexpr std::size_t kMaxPictures = 60;
constexpr int kOverlayWidthPx = 560;
constexpr int kSmallWidthPx = 280;

// Metadata keys of docs/model_format.md, in the order they are shown; those a model lacks are not.
constexpr std::array<std::pair<const char*, const char*>, 14> kShownMetadata = {{
    {"hc.name", "Name"},
    {"hc.version", "Version"},
    {"hc.task", "Task"},
    {"hc.features", "Features"},
    {"hc.training.algorithm", "Trained by"},
    {"hc.training.irls.ridge", "Ridge"},
    {"hc.training.class_counts", "Samples"},
    {"hc.training.split", "Split"},
    {"hc.training.sampling.seed", "Training seed"},
    {"hc.training.data_fingerprint", "Training data"},
    {"hc.intended_use", "Intended use"},
    {"hc.limits", "Limits"},
    {"hc.licence", "Licence"},
    {"hc.tool", "Made by"},
}};

ReportPicture MakePicture(const ImageScore& score,
                          const datasets::LabelledImageSet& set,
                          const hc_model* model) {
  const datasets::LabelledImage& item = set.items.at(score.item);
  const datasets::LabelledPicture picture = datasets::ReadLabelledPicture(set, score.item);
  const RuntimeScores scores =
      ScoreWithRuntime(model, picture.image, (set.root / item.image).string());
  std::vector<perception::MarkedPoint> points;
  for (const BestPixel& pixel : score.best) {
    points.push_back({pixel.u_px, pixel.v_px, pixel.probability});
  }
  const Image close_up = DrawCloseUp(picture.image, score.best);
  return {.name = item.image,
          .object_class = item.object_class,
          .best = CountBestPixels(score),
          .overlay_jpeg =
              EncodeJpeg(perception::DrawGraspPoints(picture.image, scores.probabilities, points),
                         kOverlayWidthPx),
          .mask_jpeg =
              EncodeJpeg(perception::DrawLabelMask(picture.image, picture.mask), kSmallWidthPx),
          .close_up_jpeg =
              close_up.empty() ? std::vector<std::uint8_t>() : EncodeJpeg(close_up, kSmallWidthPx)};
}

std::vector<ReportPicture> MakePictures(const GraspPointEvaluation& evaluation,
                                        const datasets::LabelledImageSet& set,
                                        const hc_model* model) {
  const std::size_t num_images = evaluation.images.size();
  std::vector<ReportPicture> pictures(std::min(num_images, kMaxPictures));
  ParallelFor(pictures.size(), evaluation.options.num_threads, [&](std::size_t k) {
    const std::size_t index = k * num_images / pictures.size();
    pictures[k] = MakePicture(evaluation.images[index], set, model);
  });
  return pictures;
}

std::vector<ModelFact> ListModelFacts(const hc_model* model) {
  std::vector<ModelFact> facts;
  for (const auto& [key, name] : kShownMetadata) {
    const char* value = hc_model_metadata(model, key);
    if (value != nullptr && *value != '\0') facts.push_back({name, value});
  }
  facts.push_back({"Numbers a pixel", std::to_string(hc_model_num_features(model))});
  return facts;
}

}  // namespace

void WriteHtmlReport(const std::filesystem::path& path,
                     const GraspPointEvaluation& evaluation,
                     const datasets::LabelledImageSet& set,
                     const hc_model* model) {
  const char* name = hc_model_metadata(model, "hc.name");
  const ReportContents contents = {
      .model_name = name == nullptr || *name == '\0' ? "unnamed model" : name,
      .data_name = std::filesystem::absolute(set.root).lexically_normal().filename().string(),
      .model_facts = ListModelFacts(model),
      .pictures = MakePictures(evaluation, set, model)};
  WriteFileAtomically(path, MakeGraspPointPage(evaluation, contents));
}

}  // namespace handcraft::experiments
