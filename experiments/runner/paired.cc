// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/paired.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "experiments/metrics/grouped_ratio.h"

namespace handcraft::experiments {
namespace {

// The figures of a picture.
struct Sums {
  GroupRatio best;
  GroupRatio right;
  GroupRatio good_found;
  GroupRatio bad_refused;
  GroupRatio good_found_strictly;
  GroupRatio bad_refused_strictly;
  GroupRatio log_loss;
  GroupRatio squared_error;
};

GroupRatio RatioOf(std::size_t part, std::size_t whole) {
  return {static_cast<double>(part), static_cast<double>(whole)};
}

void Add(const ImageFigures& image, Sums& sums) {
  const ConfusionMatrix& confusion = image.confusion;
  const ConfusionMatrix& strict = image.strict_confusion;
  sums.best += RatioOf(image.best.good, image.best.good + image.best.bad);
  sums.right += RatioOf(confusion.true_positive + confusion.true_negative, image.num_pixels);
  sums.good_found += RatioOf(confusion.true_positive, confusion.NumGood());
  sums.bad_refused += RatioOf(confusion.true_negative, confusion.NumBad());
  sums.good_found_strictly += RatioOf(strict.true_positive, strict.NumGood());
  sums.bad_refused_strictly += RatioOf(strict.true_negative, strict.NumBad());
  const auto pixels = static_cast<double>(image.num_pixels);
  sums.log_loss += {image.log_loss_sum, pixels};
  sums.squared_error += {image.squared_error_sum, pixels};
}

// What both sides gave on a picture.
struct Pair {
  Sums ours;
  Sums baseline;
};

bool IsOf(const std::string& object_class, const ImageFigures& image) {
  return object_class.empty() || image.object_class == object_class;
}

// What both sides gave on each picture, in the order in which pictures come first: that of the one
// cell, if there is one, so that its figures have the intervals that it has by itself.
std::vector<Pair> PairUp(Repetitions cells, Repetitions baseline, const std::string& object_class) {
  std::vector<Pair> pairs;
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < std::min(cells.size(), baseline.size()); ++i) {
    std::map<std::string, const ImageFigures*> of_baseline;
    for (const ImageFigures& image : baseline[i]->images) of_baseline[image.image] = &image;
    for (const ImageFigures& image : cells[i]->images) {
      const auto other = of_baseline.find(image.image);
      if (other == of_baseline.end() || !IsOf(object_class, image)) continue;
      const auto place = places.emplace(image.image, pairs.size());
      if (place.second) pairs.emplace_back();
      Pair& pair = pairs[place.first->second];
      Add(image, pair.ours);
      Add(*other->second, pair.baseline);
    }
  }
  return pairs;
}

// Of the figures of both sides.
Estimate EstimateDifference(const std::vector<Pair>& pairs,
                            GroupRatio Sums::*figure,
                            const BootstrapOptions& options) {
  return BootstrapOverGroups(
      pairs.size(),
      [&](std::span<const std::size_t> drawn) {
        GroupRatio ours;
        GroupRatio baseline;
        for (const std::size_t i : drawn) {
          ours += pairs[i].ours.*figure;
          baseline += pairs[i].baseline.*figure;
        }
        return ours.Value() - baseline.Value();
      },
      options.resamples,
      options.seed,
      options.num_threads);
}

// estimate(figure) for each of them.
template <class MakeEstimate>
PooledFigures MakeFigures(std::size_t num_images, const MakeEstimate& estimate) {
  return {
      .num_images = num_images,
      .best_pixel_accuracy = estimate(&Sums::best),
      .accuracy = estimate(&Sums::right),
      .rates = {estimate(&Sums::good_found), estimate(&Sums::bad_refused)},
      .strict_rates = {estimate(&Sums::good_found_strictly), estimate(&Sums::bad_refused_strictly)},
      .log_loss = estimate(&Sums::log_loss),
      .brier = estimate(&Sums::squared_error)};
}

}  // namespace

PooledFigures PoolFigures(Repetitions cells,
                          const std::string& object_class,
                          const BootstrapOptions& options) {
  const std::vector<Pair> pairs = PairUp(cells, cells, object_class);
  return MakeFigures(pairs.size(), [&](GroupRatio Sums::*figure) {
    std::vector<GroupRatio> images;
    images.reserve(pairs.size());
    for (const Pair& pair : pairs) images.push_back(pair.ours.*figure);
    const bool is_share = figure != &Sums::log_loss && figure != &Sums::squared_error;
    const auto estimate = is_share ? EstimateShare : EstimateRatio;
    return estimate(images, options.resamples, options.seed, options.num_threads);
  });
}

Difference CompareFigures(Repetitions cells,
                          Repetitions baseline,
                          const std::string& object_class,
                          const BootstrapOptions& options) {
  std::vector<Pair> pairs = PairUp(cells, baseline, object_class);
  Difference difference{MakeFigures(pairs.size(), [&](GroupRatio Sums::*figure) {
    return EstimateDifference(pairs, figure, options);
  })};
  std::erase_if(pairs, [](const Pair& pair) {
    return !(pair.ours.best.count > 0.0 && pair.baseline.best.count > 0.0);
  });
  difference.num_images_with_both = pairs.size();
  difference.best_pixel_accuracy_with_both = EstimateDifference(pairs, &Sums::best, options);
  return difference;
}

}  // namespace handcraft::experiments
