// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "datasets/formats/labelled_image_set.h"
#include "experiments/metrics/binary_metrics.h"
#include "experiments/metrics/confusion_rates.h"
#include "experiments/metrics/curve_bands.h"
#include "experiments/metrics/precision_recall.h"
#include "experiments/metrics/probability_bins.h"
#include "lib/core/image.h"
#include "lib/core/progress.h"
#include "lib/perception/search_region.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::experiments {

struct EvaluationOptions {
  double threshold = 0.5;               ///< of the confusion matrix, (0, 1)
  int best_pixels = 15;                 ///< "up to 15 pixels with highest probabilities" (3.3.1)
  double best_min_probability = 0.9;    ///< "greater than 90 %"
  int suppression_radius_px = 0;        ///< 0 as in the dissertation; both to 10000
  std::size_t pixels_per_image = 4000;  ///< labelled pixels scored an image, half good half bad
  std::size_t bootstrap_resamples = 1000;
  std::uint64_t seed = 1;
  int num_threads = 1;
  Progress progress = {};
  std::string data_fingerprint = {};  ///< of the set, where it is known; empty: worked out
  /// Region R that best pixels are looked for in; empty: everywhere. `item` is the index into the
  /// set. Called from several threads at once. Labelled pixels are scored everywhere all the same.
  std::function<perception::SearchRegion(std::size_t item, const Image& picture)> region = {};
  void Validate() const;
};

struct BestPixel {
  int u_px = 0;
  int v_px = 0;
  float probability = 0.0F;
  std::uint8_t mask_value = 0;
};

/// What search-space reduction came to on an image.
struct SearchOutcome {
  bool has_region = false;
  std::vector<perception::SearchStage> stages;  ///< SearchRegion.stages, then "scored"
};

/// One image, scored by the runtime.
struct ImageScore {
  std::size_t item = 0;              ///< index into the set
  std::vector<BestPixel> best;       ///< up to best_pixels, best first
  std::vector<float> probabilities;  ///< of the drawn labelled pixels
  std::vector<std::uint8_t> labels;
  double score_ms = 0.0;                     ///< of all pixels; or to find and score the region
  std::optional<SearchOutcome> search = {};  ///< with EvaluationOptions.region
};

/// Figures over a group of images (a class, or all).
struct GroupFigures {
  std::string name = {};
  std::size_t num_images = 0;
  std::size_t num_images_without_best = 0;  ///< no pixel above best_min_probability
  std::size_t best_total = 0;               ///< best pixels on good or bad ground
  std::size_t best_good = 0;
  std::size_t best_dont_care = 0;     ///< shown, not counted
  Estimate best_pixel_accuracy = {};  ///< the dissertation's measure; bootstrap over images
  ConfusionMatrix confusion = {};
  ConfusionRates rates = {};  ///< this and what follows: bootstrap over images
  Estimate accuracy = {};
  Estimate auc = {};
  ConfusionMatrix strict_confusion = {};  ///< at best_min_probability
  ConfusionRates strict_rates = {};
  Estimate strict_accuracy = {};
  Estimate average_precision = {};
  Estimate log_loss = {};
  Estimate brier = {};
};

/// Over all images, for figures.
struct PixelCurves {
  std::vector<RocPoint> roc = {};
  std::vector<PrecisionRecallPoint> precision_recall = {};
  CurveBands bands = {};                         ///< around both
  std::vector<ReliabilityBin> reliability = {};  ///< kNumReliabilityBins
};

struct GraspPointEvaluation {
  EvaluationOptions options;
  std::string data_fingerprint;
  std::vector<ImageScore> images;
  GroupFigures all;
  std::vector<GroupFigures> classes;  ///< by name
  PixelCurves curves;
};

/// Scores every image of the set with the runtime and forms the figures. Figures that need good and
/// bad pixels are NaN when one kind is missing. Throws Error: kBadInput on a set without images,
/// kNoResult when no pixel is labelled good or bad.
[[nodiscard]] GraspPointEvaluation EvaluateGraspPoints(const hc_model* model,
                                                       const datasets::LabelledImageSet& set,
                                                       const EvaluationOptions& options);

/// JSON text, keys stable; times left out so that two runs give the same bytes.
[[nodiscard]] std::string ToJson(const GraspPointEvaluation& evaluation,
                                 const datasets::LabelledImageSet& set);

/// Writes one self-contained page (figures as inline SVG, overlays as embedded PNG): opens offline.
void WriteHtmlReport(const std::filesystem::path& path,
                     const GraspPointEvaluation& evaluation,
                     const datasets::LabelledImageSet& set,
                     const hc_model* model);

}  // namespace handcraft::experiments
