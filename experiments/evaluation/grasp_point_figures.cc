// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/grasp_point_figures.h"

#include <map>

#include "experiments/metrics/grouped_ranking.h"

namespace handcraft::experiments {
namespace {

constexpr std::size_t kMaxCurvePoints = 201;

// Right out of all, for one image or many.
struct Share {
  std::size_t right = 0;
  std::size_t total = 0;
};

// The share over all images with its interval. Where all images agree on 0 or on 1 the bootstrap
// would claim certainty; the Wilson interval of that many images says what they can tell. One image
// says nothing of how images vary: no interval.
Estimate EstimateShare(const std::vector<Share>& shares, const EvaluationOptions& options) {
  std::vector<Share> counted;
  for (const Share& share : shares) {
    if (share.total > 0) counted.push_back(share);
  }
  const auto share_of_groups = [&](std::span<const std::size_t> groups) {
    std::size_t right = 0;
    std::size_t total = 0;
    for (const std::size_t group : groups) {
      right += counted[group].right;
      total += counted[group].total;
    }
    return static_cast<double>(right) / static_cast<double>(total);
  };
  const Estimate estimate = BootstrapOverGroups(counted.size(),
                                                share_of_groups,
                                                options.bootstrap_resamples,
                                                options.seed,
                                                options.num_threads);
  if (counted.size() < 2) return estimate;
  if (estimate.value == 0.0) return WilsonInterval(0, counted.size());
  if (estimate.value == 1.0) return WilsonInterval(counted.size(), counted.size());
  return estimate;
}

// A mean over the drawn pixels of all images, from its sum over those of each.
Estimate EstimateMean(const std::vector<double>& sums,
                      std::span<const ImageScore* const> images,
                      const EvaluationOptions& options) {
  const auto mean_of_groups = [&](std::span<const std::size_t> groups) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const std::size_t group : groups) {
      sum += sums[group];
      count += images[group]->labels.size();
    }
    return sum / static_cast<double>(count);  // NaN without pixels
  };
  return BootstrapOverGroups(images.size(),
                             mean_of_groups,
                             options.bootstrap_resamples,
                             options.seed,
                             options.num_threads);
}

// Confusion matrix of the drawn pixels and the share of right calls.
Estimate AddConfusion(std::span<const ImageScore* const> images,
                      double threshold,
                      const EvaluationOptions& options,
                      ConfusionMatrix& confusion) {
  std::vector<Share> shares;
  for (const ImageScore* image : images) {
    const ConfusionMatrix matrix = CountConfusion(image->probabilities, image->labels, threshold);
    confusion += matrix;
    shares.push_back({matrix.true_positive + matrix.true_negative, matrix.Total()});
  }
  return EstimateShare(shares, options);
}

// What the order of the scores is worth.
void AddRankingFigures(std::span<const ImageScore* const> images,
                       const EvaluationOptions& options,
                       GroupFigures& figures) {
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
  const GroupedRanking ranking(probabilities, labels, groups, images.size());
  const RankingEstimates estimates =
      ranking.Bootstrap(options.bootstrap_resamples, options.seed, options.num_threads);
  figures.auc = estimates.auc;
  figures.average_precision = estimates.average_precision;
}

// How far the probabilities are from the truth.
void AddProbabilityFigures(std::span<const ImageScore* const> images,
                           const EvaluationOptions& options,
                           GroupFigures& figures) {
  std::vector<double> log_losses;
  std::vector<double> squared_errors;
  for (const ImageScore* image : images) {
    const auto count = static_cast<double>(image->labels.size());
    const bool is_empty = image->labels.empty();
    log_losses.push_back(is_empty ? 0.0 : count * LogLoss(image->probabilities, image->labels));
    squared_errors.push_back(is_empty ? 0.0
                                      : count * BrierScore(image->probabilities, image->labels));
  }
  figures.log_loss = EstimateMean(log_losses, images, options);
  figures.brier = EstimateMean(squared_errors, images, options);
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
  std::vector<Share> best_shares;
  for (const ImageScore* image : images) {
    const BestPixelCounts counts = CountBestPixels(*image);
    figures.num_images_without_best += image->best.empty() ? 1 : 0;
    figures.best_good += counts.good;
    figures.best_total += counts.good + counts.bad;
    figures.best_dont_care += counts.dont_care;
    best_shares.push_back({counts.good, counts.good + counts.bad});
  }
  figures.best_pixel_accuracy = EstimateShare(best_shares, options);
  figures.accuracy = AddConfusion(images, options.threshold, options, figures.confusion);
  figures.strict_accuracy =
      AddConfusion(images, options.best_min_probability, options, figures.strict_confusion);
  AddRankingFigures(images, options, figures);
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
  const PooledPixels pooled = PoolPixels(evaluation.images);
  evaluation.roc = RocCurve(pooled.probabilities, pooled.labels, kMaxCurvePoints);
  evaluation.precision_recall =
      PrecisionRecallCurve(pooled.probabilities, pooled.labels, kMaxCurvePoints);
}

}  // namespace handcraft::experiments
