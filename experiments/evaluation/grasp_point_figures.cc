// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/grasp_point_figures.h"

#include <map>

#include "experiments/metrics/grouped_ranking.h"
#include "experiments/metrics/grouped_ratio.h"

namespace handcraft::experiments {
namespace {

constexpr std::size_t kMaxCurvePoints = 201;

Estimate ShareOf(const std::vector<GroupRatio>& images, const EvaluationOptions& options) {
  return EstimateShare(images, options.bootstrap_resamples, options.seed, options.num_threads);
}

Estimate MeanOf(const std::vector<GroupRatio>& images, const EvaluationOptions& options) {
  return EstimateRatio(images, options.bootstrap_resamples, options.seed, options.num_threads);
}

GroupRatio RatioOf(std::size_t part, std::size_t whole) {
  return {static_cast<double>(part), static_cast<double>(whole)};
}

// What calling the drawn pixels by a threshold comes to.
struct Calls {
  ConfusionMatrix confusion = {};
  ConfusionRates rates = {};
  Estimate accuracy = {};
};
Calls CallsAt(double threshold,
              std::span<const ImageScore* const> images,
              const EvaluationOptions& options) {
  Calls calls;
  std::vector<ConfusionMatrix> matrices;
  std::vector<GroupRatio> shares;
  for (const ImageScore* image : images) {
    const ConfusionMatrix matrix = CountConfusion(image->probabilities, image->labels, threshold);
    calls.confusion += matrix;
    matrices.push_back(matrix);
    shares.push_back(RatioOf(matrix.true_positive + matrix.true_negative, matrix.Total()));
  }
  calls.rates =
      EstimateRates(matrices, options.bootstrap_resamples, options.seed, options.num_threads);
  calls.accuracy = ShareOf(shares, options);
  return calls;
}

GroupedRanking RankingOf(std::span<const ImageScore* const> images) {
  std::vector<double> probabilities;
  std::vector<std::uint8_t> labels;
  std::vector<std::size_t> groups;
  for (std::size_t k = 0; k < images.size(); ++k) {
    const ImageScore& image = *images[k];
    probabilities.insert(
        probabilities.end(), image.probabilities.begin(), image.probabilities.end());
    labels.insert(labels.end(), image.labels.begin(), image.labels.end());
    groups.insert(groups.end(), image.labels.size(), k);
  }
  return {probabilities, labels, groups, images.size()};
}

// How far the probabilities are from the truth.
void AddProbabilityFigures(std::span<const ImageScore* const> images,
                           const EvaluationOptions& options,
                           GroupFigures& figures) {
  std::vector<GroupRatio> log_losses;
  std::vector<GroupRatio> squared_errors;
  for (const ImageScore* image : images) {
    const auto count = static_cast<double>(image->labels.size());
    const bool is_empty = image->labels.empty();
    log_losses.push_back(
        {is_empty ? 0.0 : count * LogLoss(image->probabilities, image->labels), count});
    squared_errors.push_back(
        {is_empty ? 0.0 : count * BrierScore(image->probabilities, image->labels), count});
  }
  figures.log_loss = MeanOf(log_losses, options);
  figures.brier = MeanOf(squared_errors, options);
}

PixelCurves CurvesOf(const GraspPointEvaluation& evaluation,
                     std::span<const ImageScore* const> images) {
  const EvaluationOptions& options = evaluation.options;
  const PooledPixels pooled = PoolPixels(evaluation.images);
  std::vector<std::vector<ProbabilityBin>> bins;
  bins.reserve(images.size());
  for (const ImageScore* image : images) {
    bins.push_back(BinProbabilities(image->probabilities, image->labels, kNumReliabilityBins));
  }
  return {
      .roc = RocCurve(pooled.probabilities, pooled.labels, kMaxCurvePoints),
      .precision_recall =
          PrecisionRecallCurve(pooled.probabilities, pooled.labels, kMaxCurvePoints),
      .bands = BootstrapCurveBands(
          RankingOf(images), options.bootstrap_resamples, options.seed, options.num_threads),
      .reliability =
          EstimateReliability(bins, options.bootstrap_resamples, options.seed, options.num_threads),
  };
}

}  // namespace

BestPixelCounts CountBestPixels(const ImageScore& image) {
  BestPixelCounts counts;
  for (const BestPixel& pixel : image.best) {
    if (pixel.mask_value == datasets::kMaskGood) {
      ++counts.good;
    } else if (pixel.mask_value == datasets::kMaskBad) {
      ++counts.bad;
    } else {
      ++counts.dont_care;
    }
  }
  return counts;
}

GroupFigures ComputeGroupFigures(const std::string& name,
                                 std::span<const ImageScore* const> images,
                                 const EvaluationOptions& options) {
  GroupFigures figures;
  figures.name = name;
  figures.num_images = images.size();
  std::vector<GroupRatio> best_shares;
  for (const ImageScore* image : images) {
    const BestPixelCounts counts = CountBestPixels(*image);
    figures.num_images_without_best += image->best.empty() ? 1 : 0;
    figures.best_good += counts.good;
    figures.best_total += counts.good + counts.bad;
    figures.best_dont_care += counts.dont_care;
    best_shares.push_back(RatioOf(counts.good, counts.good + counts.bad));
  }
  figures.best_pixel_accuracy = ShareOf(best_shares, options);
  const Calls calls = CallsAt(options.threshold, images, options);
  figures.confusion = calls.confusion;
  figures.rates = calls.rates;
  figures.accuracy = calls.accuracy;
  const Calls strict = CallsAt(options.best_min_probability, images, options);
  figures.strict_confusion = strict.confusion;
  figures.strict_rates = strict.rates;
  figures.strict_accuracy = strict.accuracy;
  const RankingEstimates order =
      RankingOf(images).Bootstrap(options.bootstrap_resamples, options.seed, options.num_threads);
  figures.auc = order.auc;
  figures.average_precision = order.average_precision;
  AddProbabilityFigures(images, options, figures);
  return figures;
}

PooledPixels PoolPixels(std::span<const ImageScore> images) {
  PooledPixels pooled;
  for (const ImageScore& image : images) {
    pooled.probabilities.insert(
        pooled.probabilities.end(), image.probabilities.begin(), image.probabilities.end());
    pooled.labels.insert(pooled.labels.end(), image.labels.begin(), image.labels.end());
  }
  return pooled;
}

void FormFigures(const datasets::LabelledImageSet& set, GraspPointEvaluation& evaluation) {
  std::vector<const ImageScore*> all;
  std::map<std::string, std::vector<const ImageScore*>> by_class;
  for (const ImageScore& image : evaluation.images) {
    all.push_back(&image);
    by_class[set.items.at(image.item).object_class].push_back(&image);
  }
  evaluation.all = ComputeGroupFigures("all", all, evaluation.options);
  evaluation.classes.clear();
  for (const auto& [name, images] : by_class) {
    evaluation.classes.push_back(ComputeGroupFigures(name, images, evaluation.options));
  }
  evaluation.curves = CurvesOf(evaluation, all);
}

}  // namespace handcraft::experiments
