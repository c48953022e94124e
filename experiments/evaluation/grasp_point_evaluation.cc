// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/grasp_point_evaluation.h"

#include <atomic>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "experiments/evaluation/evaluation_pixels.h"
#include "experiments/evaluation/grasp_point_figures.h"
#include "experiments/evaluation/runtime_scoring.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/core/parallel.h"

namespace handcraft::experiments {
namespace {

// Scores region R alone, the others get 0, and keeps what the search came to.
FloatImage ScoreRegion(const hc_model* model,
                       const Image& picture,
                       const std::string& path,
                       const perception::SearchRegion& region,
                       ImageScore& score) {
  SearchOutcome& search = score.search.emplace(
      SearchOutcome{.has_region = region.HasRegion(), .stages = region.stages});
  score.score_ms = 0.0;
  for (const perception::SearchStage& stage : region.stages) score.score_ms += stage.time_ms;
  if (!search.has_region) return {picture.width(), picture.height()};
  RuntimeScores scores = ScoreWithRuntime(model, picture, path, &region.mask);
  score.score_ms += scores.score_ms;
  search.stages.push_back({"scored", search.stages.back().num_pixels, scores.score_ms});
  return std::move(scores.probabilities);
}

ImageScore ScoreItem(const hc_model* model,
                     const datasets::LabelledImageSet& set,
                     std::size_t item,
                     const EvaluationOptions& options) {
  const datasets::LabelledPicture picture = datasets::ReadLabelledPicture(set, item);
  const std::string& name = set.items[item].image;
  const std::string path = (set.root / name).string();
  const RuntimeScores scores = ScoreWithRuntime(model, picture.image, path);
  ImageScore score;
  score.item = item;
  score.score_ms = scores.score_ms;
  FloatImage in_region;
  if (options.region) {
    in_region = ScoreRegion(model, picture.image, path, options.region(item, picture.image), score);
  }
  for (const hc_point& point : FindBestPixels(options.region ? in_region : scores.probabilities,
                                              options.best_pixels,
                                              options.best_min_probability,
                                              options.suppression_radius_px)) {
    score.best.push_back({point.u, point.v, point.probability, picture.mask.At(point.u, point.v)});
  }
  for (const EvaluationPixel& pixel :
       DrawEvaluationPixels(picture.mask, options.pixels_per_image, options.seed, name)) {
    score.probabilities.push_back(scores.probabilities.values()[pixel.index]);
    score.labels.push_back(pixel.label);
  }
  return score;
}

// Every figure stands on pixels that are labelled good or bad.
void RequireMeasurable(const datasets::LabelledImageSet& set,
                       const GraspPointEvaluation& evaluation) {
  if (evaluation.all.confusion.Total() > 0) return;
  throw Error({.kind = Error::Kind::kNoResult,
               .path = set.root.string(),
               .reason = fmt::format("nothing to measure: no pixel of the {} images is labelled "
                                     "good or bad, all are don't care",
                                     set.items.size()),
               .remedy = "label pixels in the masks, or evaluate on other images"});
}

}  // namespace

void EvaluationOptions::Validate() const {
  RequireOption(
      threshold > 0.0 && threshold < 1.0, "EvaluationOptions.threshold", threshold, "in (0, 1)");
  RequireOption(best_pixels >= 1 && best_pixels <= 10000,
                "EvaluationOptions.best_pixels",
                best_pixels,
                "from 1 to 10000");
  RequireOption(best_min_probability >= 0.0 && best_min_probability < 1.0,
                "EvaluationOptions.best_min_probability",
                best_min_probability,
                "in [0, 1)");
  RequireOption(suppression_radius_px >= 0 && suppression_radius_px <= 10000,
                "EvaluationOptions.suppression_radius_px",
                suppression_radius_px,
                "from 0 to 10000");
  RequireOption(
      pixels_per_image >= 2, "EvaluationOptions.pixels_per_image", pixels_per_image, "at least 2");
  RequireOption(bootstrap_resamples >= 1,
                "EvaluationOptions.bootstrap_resamples",
                bootstrap_resamples,
                "at least 1");
  RequireOption(num_threads >= 1, "EvaluationOptions.num_threads", num_threads, "at least 1");
}

GraspPointEvaluation EvaluateGraspPoints(const hc_model* model,
                                         const datasets::LabelledImageSet& set,
                                         const EvaluationOptions& options) {
  options.Validate();
  HC_CHECK(model != nullptr);
  if (hc_model_kind(model) != HC_KIND_GRASP_POINT) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "the model does not score images: it is no grasp-point model",
                 .remedy = "evaluate it on a table (.csv or .npy)"});
  }
  if (set.items.empty()) {
    throw Error({.kind = Error::Kind::kBadInput,
                 .path = set.root.string(),
                 .reason = "the data set has no images to evaluate"});
  }
  GraspPointEvaluation evaluation;
  evaluation.options = options;
  evaluation.data_fingerprint =
      options.data_fingerprint.empty() ? datasets::Fingerprint(set) : options.data_fingerprint;
  evaluation.images.resize(set.items.size());
  std::atomic<std::size_t> num_done{0};
  const std::thread::id caller = std::this_thread::get_id();
  ParallelFor(set.items.size(), options.num_threads, [&](std::size_t item) {
    evaluation.images[item] = ScoreItem(model, set, item, options);
    const std::size_t done = ++num_done;
    // Progress is promised to come from the caller's thread, which is one of the workers.
    if (std::this_thread::get_id() == caller) {
      Report(options.progress, "evaluate", done, set.items.size());
    }
  });
  Report(options.progress, "evaluate", set.items.size(), set.items.size());
  FormFigures(set, evaluation);
  RequireMeasurable(set, evaluation);
  return evaluation;
}

}  // namespace handcraft::experiments
