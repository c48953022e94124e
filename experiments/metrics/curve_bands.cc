// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/curve_bands.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "lib/core/check.h"
#include "lib/core/parallel.h"

namespace handcraft::experiments {
namespace {

constexpr std::size_t kMaxPieces = 500;
constexpr std::size_t kNumSteps = 100;  // of the axis on which a curve is asked for

// Good or bad samples of one group, or above one cut.
struct Counts {
  double good = 0.0;
  double bad = 0.0;
};

// What each group has in each piece of the ranking.
class PieceCounts {
 public:
  explicit PieceCounts(const GroupedRanking& ranking) {
    const std::span<const RankedSample> samples = ranking.Descending();
    HC_CHECK(samples.size() <= std::numeric_limits<std::uint32_t>::max(), samples.size());
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const bool is_due = (i + 1) * kMaxPieces >= (ends.size() + 1) * samples.size();
      if (samples[i].ends_tie && is_due) ends.push_back(i + 1);
    }
    num_pieces_ = ends.size();
    counts_.resize(ranking.num_groups() * RowSize());
    std::size_t piece = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (i == ends[piece]) ++piece;
      const std::size_t column = samples[i].is_good ? piece : num_pieces_ + piece;
      ++counts_[samples[i].group * RowSize() + column];
    }
  }

  // What lies above each cut in the drawn groups, from nothing to everything.
  [[nodiscard]] std::vector<Counts> AboveCuts(std::span<const std::size_t> drawn) const {
    std::vector<std::uint32_t> sums(RowSize());
    for (const std::size_t group : drawn) {
      const std::uint32_t* const row = counts_.data() + group * RowSize();
      for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += row[k];
    }
    std::vector<Counts> above = {{}};
    above.reserve(num_pieces_ + 1);
    for (std::size_t piece = 0; piece < num_pieces_; ++piece) {
      above.push_back(
          {above.back().good + sums[piece], above.back().bad + sums[num_pieces_ + piece]});
    }
    return above;
  }

 private:
  [[nodiscard]] std::size_t RowSize() const noexcept { return 2 * num_pieces_; }

  std::size_t num_pieces_ = 0;
  std::vector<std::uint32_t> counts_;  // [group][good in each piece, bad in each piece]
};

// `share` of the way from a to b in x, which has passed `wanted` at b.
Counts Between(const Counts& a, const Counts& b, double wanted, double Counts::*x) {
  const double step = b.*x - a.*x;
  const double share = step > 0.0 ? (wanted - a.*x) / step : 1.0;
  return {a.good + share * (b.good - a.good), a.bad + share * (b.bad - a.bad)};
}

// True positive rate at each step of the false positive rate: the most that is reached there.
void AddTruePositiveRates(const std::vector<Counts>& above, std::span<double> rates) {
  const Counts& all = above.back();
  std::size_t k = 0;
  for (std::size_t step = 0; step <= kNumSteps; ++step) {
    const double wanted = all.bad * static_cast<double>(step) / kNumSteps;
    while (k + 1 < above.size() && above[k + 1].bad <= wanted) ++k;
    const Counts at =
        k + 1 == above.size() ? above[k] : Between(above[k], above[k + 1], wanted, &Counts::bad);
    rates[step] = at.good / all.good;
  }
}

// Precision at each step of the recall but 0: the first that is reached there.
void AddPrecisions(const std::vector<Counts>& above, std::span<double> precisions) {
  std::size_t k = 0;
  for (std::size_t step = 1; step <= kNumSteps; ++step) {
    const double wanted = above.back().good * static_cast<double>(step) / kNumSteps;
    while (above[k + 1].good < wanted) ++k;
    const Counts at = Between(above[k], above[k + 1], wanted, &Counts::good);
    precisions[step - 1] = at.good / (at.good + at.bad);
  }
}

// From values[resample · width + k] to the band at first_step + k.
std::vector<BandPoint> BandOf(std::span<const double> values,
                              std::size_t width,
                              std::size_t first_step) {
  std::vector<BandPoint> band;
  band.reserve(width);
  for (std::size_t k = 0; k < width; ++k) {
    std::vector<double> column;
    column.reserve(values.size() / width);
    for (std::size_t at = k; at < values.size(); at += width) column.push_back(values[at]);
    const Estimate estimate = PercentileEstimate(0.0, std::move(column));
    band.push_back({static_cast<double>(first_step + k) / kNumSteps, estimate.low, estimate.high});
  }
  return band;
}

bool HasBothKinds(std::span<const RankedSample> samples) {
  const auto is_good = [](const RankedSample& sample) { return sample.is_good; };
  return std::any_of(samples.begin(), samples.end(), is_good) &&
         !std::all_of(samples.begin(), samples.end(), is_good);
}

}  // namespace

CurveBands BootstrapCurveBands(const GroupedRanking& ranking,
                               std::size_t num_resamples,
                               std::uint64_t seed,
                               int num_threads) {
  if (ranking.num_groups() < 2 || !HasBothKinds(ranking.Descending())) return {};
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const PieceCounts pieces(ranking);
  std::vector<double> rates(num_resamples * (kNumSteps + 1), kNaN);
  std::vector<double> precisions(num_resamples * kNumSteps, kNaN);
  ParallelFor(num_resamples, num_threads, [&](std::size_t resample) {
    const std::vector<Counts> above =
        pieces.AboveCuts(DrawGroups(ranking.num_groups(), seed, resample));
    if (above.back().good == 0.0 || above.back().bad == 0.0) return;  // as NaN areas: left out
    AddTruePositiveRates(above,
                         std::span(rates).subspan(resample * (kNumSteps + 1), kNumSteps + 1));
    AddPrecisions(above, std::span(precisions).subspan(resample * kNumSteps, kNumSteps));
  });
  return {.roc = BandOf(rates, kNumSteps + 1, 0),
          .precision_recall = BandOf(precisions, kNumSteps, 1)};
}

}  // namespace handcraft::experiments
