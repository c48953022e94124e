// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/paired.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace handcraft::experiments {
namespace {

// A figure is a sum over pictures divided by another.
struct Ratio {
  double sum = 0.0;
  double count = 0.0;
  Ratio& operator+=(const Ratio& other) {
    sum += other.sum;
    count += other.count;
    return *this;
  }
  [[nodiscard]] double Value() const { return sum / count; }  // NaN when both are 0
};

// The four figures of a picture.
struct Sums {
  Ratio best;
  Ratio right;
  Ratio log_loss;
  Ratio squared_error;
};

void Add(const ImageFigures& image, Sums& sums) {
  const auto pixels = static_cast<double>(image.num_pixels);
  sums.best +=
      {static_cast<double>(image.best.good), static_cast<double>(image.best.good + image.best.bad)};
  sums.right += {static_cast<double>(image.num_right), pixels};
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

// The pictures that both cells of a repetition have, added to those of other repetitions.
void AddRepetition(const CellResult& ours,
                   const CellResult& baseline,
                   const std::string& object_class,
                   std::map<std::string, Pair>& pairs) {
  std::map<std::string, const ImageFigures*> of_baseline;
  for (const ImageFigures& image : baseline.images) of_baseline[image.image] = &image;
  for (const ImageFigures& image : ours.images) {
    const auto other = of_baseline.find(image.image);
    if (other == of_baseline.end() || !IsOf(object_class, image)) continue;
    Pair& pair = pairs[image.image];
    Add(image, pair.ours);
    Add(*other->second, pair.baseline);
  }
}

std::vector<Pair> PairUp(Repetitions cells, Repetitions baseline, const std::string& object_class) {
  std::map<std::string, Pair> by_image;
  for (std::size_t i = 0; i < std::min(cells.size(), baseline.size()); ++i) {
    AddRepetition(*cells[i], *baseline[i], object_class, by_image);
  }
  std::vector<Pair> pairs;
  pairs.reserve(by_image.size());
  for (auto& [name, pair] : by_image) pairs.push_back(pair);
  return pairs;
}

template <class Statistic>
Estimate EstimateOf(const std::vector<Pair>& pairs,
                    Ratio Sums::*figure,
                    const BootstrapOptions& options,
                    const Statistic& statistic) {
  return BootstrapOverGroups(
      pairs.size(),
      [&](std::span<const std::size_t> drawn) {
        Ratio ours;
        Ratio baseline;
        for (const std::size_t i : drawn) {
          ours += pairs[i].ours.*figure;
          baseline += pairs[i].baseline.*figure;
        }
        return statistic(ours, baseline);
      },
      options.resamples,
      options.seed,
      options.num_threads);
}

template <class Statistic>
PooledFigures Bootstrap(const std::vector<Pair>& pairs,
                        const BootstrapOptions& options,
                        const Statistic& statistic) {
  const auto estimate = [&](Ratio Sums::*figure) {
    return EstimateOf(pairs, figure, options, statistic);
  };
  return {.num_images = pairs.size(),
          .best_pixel_accuracy = estimate(&Sums::best),
          .accuracy = estimate(&Sums::right),
          .log_loss = estimate(&Sums::log_loss),
          .brier = estimate(&Sums::squared_error)};
}

// A share of 0 or 1 leaves the bootstrap nothing to vary: the interval is then Wilson's, with as
// many trials as pictures that count.
void WidenCertainty(const std::vector<Pair>& pairs, Ratio Sums::*figure, Estimate& share) {
  const auto counted = static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [figure](const Pair& pair) {
        return (pair.ours.*figure).count > 0.0;
      }));
  if (counted < 2) return;
  if (share.value == 0.0) share = WilsonInterval(0, counted);
  if (share.value == 1.0) share = WilsonInterval(counted, counted);
}

}  // namespace

PooledFigures PoolFigures(Repetitions cells,
                          const std::string& object_class,
                          const BootstrapOptions& options) {
  const std::vector<Pair> pairs = PairUp(cells, cells, object_class);
  PooledFigures figures =
      Bootstrap(pairs, options, [](const Ratio& ours, const Ratio&) { return ours.Value(); });
  WidenCertainty(pairs, &Sums::best, figures.best_pixel_accuracy);
  WidenCertainty(pairs, &Sums::right, figures.accuracy);
  return figures;
}

Difference CompareFigures(Repetitions cells,
                          Repetitions baseline,
                          const std::string& object_class,
                          const BootstrapOptions& options) {
  const auto subtract = [](const Ratio& ours, const Ratio& other) {
    return ours.Value() - other.Value();
  };
  std::vector<Pair> pairs = PairUp(cells, baseline, object_class);
  Difference difference{Bootstrap(pairs, options, subtract)};
  std::erase_if(pairs, [](const Pair& pair) {
    return !(pair.ours.best.count > 0.0 && pair.baseline.best.count > 0.0);
  });
  difference.num_images_with_both = pairs.size();
  difference.best_pixel_accuracy_with_both = EstimateOf(pairs, &Sums::best, options, subtract);
  return difference;
}

}  // namespace handcraft::experiments
