// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/pixel_scorer.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lib/core/check.h"
#include "lib/features/channel_planes.h"
#include "lib/features/region_pass.h"
#include "lib/features/row_runs.h"
#include "lib/features/scoring_level.h"

namespace handcraft::features {
namespace {

using internal::ChannelPlanes;
using internal::kStripStride;
using internal::kStripWidth;
using internal::RegionBox;
using internal::RegionOutput;
using internal::RegionSums;
using internal::ScaleMap;
using internal::ScoringLevel;

// Takes pieces off a block of memory, each on a 64-byte boundary.
class Arena {
 public:
  explicit Arena(std::byte* memory) noexcept : next_(memory) {}

  template <class T>
  T* Take(std::size_t count) noexcept {
    auto* piece = reinterpret_cast<T*>(next_);
    next_ += RoundedBytes(count * sizeof(T));
    return piece;
  }
  static std::size_t RoundedBytes(std::size_t bytes) noexcept { return (bytes + 63) / 64 * 64; }

 private:
  std::byte* next_;
};

// Rows of decision values in the making: one for each row of the window, used in turn.
struct StripSums {
  alignas(64) std::array<std::array<float, kStripStride>, 5> rows;
};

// Distinct scales are numbers from 2 to 16 (FaultOf).
constexpr std::size_t kMaxScales = 15;

// Row by row down the strip: the energies of row v go into the sums of rows v − r … v + r, after
// which row v − r is complete. Rows above and below the picture repeat its first and last energies.
void ScoreStrip(const ScoringLevel& level,
                const RegionOutput& output,
                int x0,
                int width,
                internal::StripBuffers& buffers,
                StripSums& sums) noexcept {
  const int radius = level.window / 2;
  const int height = level.planes.height();
  const auto row_of = [&](int y) {
    return sums.rows[static_cast<std::size_t>((y + 2 * level.window) % level.window)].data();
  };
  for (int y = -2 * radius; y <= 0; ++y) std::fill_n(row_of(y), kStripStride, 0.0F);

  internal::CorrelateRowJob job{.energies = buffers.energies.data(),
                                .weights = level.weights,
                                .num_filters = level.plan.num_filters,
                                .window = level.window,
                                .count = width};
  for (int v = -radius; v < height + radius; ++v) {
    if (v == -radius || (v > 0 && v < height)) {
      FilterStripRow(level.planes, level.plan, level.kernels, x0, width, std::max(v, 0), buffers);
    }
    if (v + radius < height) StartSums(level, x0, width, v + radius, row_of(v + radius));
    for (int j = 0; j < level.window; ++j) {
      job.sums[static_cast<std::size_t>(j)] = row_of(v + radius - j);
    }
    level.kernels.correlate_row(job);
    const int finished = v - radius;
    if (finished < 0) continue;
    float* row = row_of(finished);
    if (level.as_probability) level.kernels.sigmoid_row(row, width);
    std::copy_n(row, width, output.map + finished * output.stride + x0);
  }
}

void ScoreLevel(const ScoringLevel& level,
                const RegionOutput& output,
                internal::StripBuffers& buffers,
                StripSums& sums) noexcept {
  for (int x0 = 0; x0 < level.planes.width(); x0 += kStripWidth) {
    ScoreStrip(level, output, x0, std::min(kStripWidth, level.planes.width() - x0), buffers, sums);
  }
}

std::size_t NumPixels(int width, int height) noexcept {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

ChannelPlanes MakePlanes(int width, int height, int num_channels, Arena& arena) noexcept {
  const std::size_t num_floats = ChannelPlanes::NumFloats(width, height, num_channels);
  return {width, height, num_channels, arena.Take<float>(num_floats)};
}

RegionBox WholeOf(const RawImage& image) noexcept {
  return {.last_u = image.width, .last_v = image.height};
}

// What the scores in the box depend on; nothing for an empty box.
RegionBox WithMargin(const RegionBox& box, const RawImage& image) noexcept {
  if (box.empty()) return {};
  return {.first_u = std::max(0, box.first_u - internal::kRegionMargin),
          .last_u = std::min(image.width, box.last_u + internal::kRegionMargin),
          .first_v = std::max(0, box.first_v - internal::kRegionMargin),
          .last_v = std::min(image.height, box.last_v + internal::kRegionMargin)};
}

// What the decision values of one scale take.
struct ScaleWeights {
  const internal::FilterPlan& plan;
  const internal::PixelKernels& kernels;
  const float* weights;
};

ScaleMap ScoreScale(const ChannelPlanes& planes,
                    int scale,
                    const ScaleWeights& weights,
                    Arena& arena,
                    internal::StripBuffers& buffers,
                    StripSums& sums) noexcept {
  ChannelPlanes small = MakePlanes(internal::ShrunkSide(planes.width(), scale),
                                   internal::ShrunkSide(planes.height(), scale),
                                   planes.num_channels(),
                                   arena);
  small.ShrinkFrom(planes, scale);
  auto* values = arena.Take<float>(NumPixels(small.width(), small.height()));
  const ScoringLevel level{
      small, weights.plan, weights.kernels, weights.weights, 1, 0.0F, {}, false};
  ScoreLevel(level, {.map = values, .stride = small.width()}, buffers, sums);
  return {scale, small.width(), values};
}

// FeatureSpec order [window row][window column][filter] → [filter][column][row].
void PackWindow(const FeatureSpec& spec,
                std::span<const float> weights,
                std::vector<float>& packed) {
  const int num_filters = spec.NumFilters();
  for (int filter = 0; filter < num_filters; ++filter) {
    for (int column = 0; column < spec.window; ++column) {
      for (int row = 0; row < spec.window; ++row) {
        const int index = num_filters * (spec.window * row + column) + filter;
        packed.push_back(weights[static_cast<std::size_t>(index)]);
      }
    }
  }
}

}  // namespace

PixelScorer::PixelScorer(FeatureSpec spec,
                         std::span<const float> weights,
                         double intercept,
                         InstructionSet instruction_set)
    : spec_(std::move(spec)), instruction_set_(instruction_set), intercept_(intercept) {
  HC_CHECK(FaultOf(spec_).empty(), FaultOf(spec_));
  HC_CHECK(weights.size() == static_cast<std::size_t>(spec_.NumFeatures()), weights.size());
  PackWindow(spec_, weights, packed_weights_);
  // The weights of the scales already are one number a filter.
  packed_weights_.insert(packed_weights_.end(),
                         weights.begin() + static_cast<std::ptrdiff_t>(packed_weights_.size()),
                         weights.end());
}

std::size_t PixelScorer::WorkspaceBytes(int max_width, int max_height) const noexcept {
  const int num_channels = spec_.NeedsColour() ? 3 : 1;
  const auto rounded = [](std::size_t num_floats) {
    return Arena::RoundedBytes(num_floats * sizeof(float));
  };
  std::size_t bytes = rounded(ChannelPlanes::NumFloats(max_width, max_height, num_channels)) +
                      Arena::RoundedBytes(sizeof(internal::StripBuffers)) +
                      Arena::RoundedBytes(sizeof(StripSums)) +
                      rounded(RegionSums::NumFloats(max_width, spec_.window)) +
                      Arena::RoundedBytes(NumPixels(max_width, max_height));
  for (const int scale : spec_.scales) {
    const int width = internal::ShrunkSide(max_width, scale);
    const int height = internal::ShrunkSide(max_height, scale);
    bytes += rounded(ChannelPlanes::NumFloats(width, height, num_channels)) +
             rounded(NumPixels(width, height));
  }
  return bytes;
}

void PixelScorer::Score(const RawImage& image,
                        std::span<std::byte> workspace,
                        float* probabilities,
                        std::ptrdiff_t stride) const noexcept {
  Run(image, workspace, {.map = probabilities, .stride = stride}, nullptr, true);
}

void PixelScorer::ScoreDecisionValues(const RawImage& image,
                                      std::span<std::byte> workspace,
                                      float* decision_values,
                                      std::ptrdiff_t stride) const noexcept {
  Run(image, workspace, {.map = decision_values, .stride = stride}, nullptr, false);
}

ScoringWay PixelScorer::CheaperWay(int width, int height, const PixelMask& mask) const noexcept {
  // In parts of what a filter takes for a column: fitted to region_scoring_benchmark.
  constexpr double kTap = 0.02;          // a column of a filter, for each pixel of the window
  constexpr double kLogarithm = 0.55;    // the same, with logarithmic energies
  constexpr double kDenseColumn = 4.0;   // conversion, intercept, sigmoid
  constexpr double kSparseColumn = 7.0;  // the same, sums outside the first-level cache
  constexpr double kSparseFilter = 0.84;
  constexpr double kRun = 330.0;         // to find a run and set its jobs up
  constexpr double kBoxPixel = 2.8;      // to look at the mask, row by row
  constexpr double kPicturePixel = 1.3;  // to find the box and clear the map
  const double filter =
      1.0 + kTap * spec_.window * spec_.window + (spec_.energy == Energy::kLog ? kLogarithm : 0.0);
  const double filters = spec_.NumFilters() * filter;
  const RegionBox box = internal::BoxOf(mask, width, height);
  const int radius = spec_.window / 2;
  const internal::RegionWork work = internal::SparseWork(mask, box, radius);
  const double box_pixels =
      box.empty()
          ? 0.0
          : static_cast<double>(NumPixels(box.last_u - box.first_u, box.last_v - box.first_v));
  const double sparse =
      (kSparseFilter * filters + kSparseColumn) * static_cast<double>(work.num_columns) +
      kRun * static_cast<double>(work.num_runs) + kBoxPixel * box_pixels +
      kPicturePixel * static_cast<double>(NumPixels(width, height));
  const double dense = (filters + kDenseColumn) *
                       static_cast<double>(internal::NumDenseColumns(width, height, radius));
  return sparse < dense ? ScoringWay::kSparse : ScoringWay::kDense;
}

void PixelScorer::ScoreMask(const RawImage& image,
                            const PixelMask& mask,
                            ScoringWay way,
                            std::span<std::byte> workspace,
                            float* probabilities,
                            std::ptrdiff_t stride) const noexcept {
  if (way == ScoringWay::kSparse) {
    Run(image, workspace, {.map = probabilities, .stride = stride}, &mask, true);
    return;
  }
  Score(image, workspace, probabilities, stride);
  for (int v = 0; v < image.height; ++v) {
    float* const row = probabilities + v * stride;
    const std::uint8_t* const wanted = mask.Row(v);
    for (int u = 0; u < image.width; ++u) row[u] = wanted[u] != 0 ? row[u] : 0.0F;
  }
}

void PixelScorer::ScorePixels(const RawImage& image,
                              std::span<const PixelPosition> pixels,
                              std::span<std::byte> workspace,
                              float* probabilities) const noexcept {
  const std::size_t num_pixels = NumPixels(image.width, image.height);
  auto* const wanted = reinterpret_cast<std::uint8_t*>(workspace.data());
  std::fill_n(wanted, num_pixels, std::uint8_t{0});
  for (const PixelPosition& pixel : pixels) {
    wanted[static_cast<std::ptrdiff_t>(pixel.v) * image.width + pixel.u] = 1;
  }
  const PixelMask mask{wanted, image.width};
  Run(image,
      workspace.subspan(Arena::RoundedBytes(num_pixels)),
      {.pixels = pixels, .values = probabilities},
      &mask,
      true);
}

void PixelScorer::Run(const RawImage& image,
                      std::span<std::byte> workspace,
                      const internal::RegionOutput& output,
                      const PixelMask* mask,
                      bool as_probability) const noexcept {
  const internal::PixelKernels& kernels = internal::KernelsFor(instruction_set_);
  const internal::FilterPlan plan(spec_);
  Arena arena(workspace.data());
  auto& buffers = *arena.Take<internal::StripBuffers>(1);
  auto& sums = *arena.Take<StripSums>(1);
  const RegionSums region_sums{arena.Take<float>(RegionSums::NumFloats(image.width, spec_.window))};
  const RegionBox box =
      mask == nullptr ? RegionBox{} : internal::BoxOf(*mask, image.width, image.height);
  ChannelPlanes planes = MakePlanes(image.width, image.height, spec_.NeedsColour() ? 3 : 1, arena);
  const bool reads_all = mask == nullptr || !spec_.scales.empty();  // scales shrink all of it
  planes.ConvertPart(image, kernels, reads_all ? WholeOf(image) : WithMargin(box, image));
  std::array<ScaleMap, kMaxScales> maps{};
  const float* scale_weights =
      packed_weights_.data() + plan.num_filters * spec_.window * spec_.window;
  for (std::size_t i = 0; i < spec_.scales.size(); ++i) {
    maps[i] =
        ScoreScale(planes, spec_.scales[i], {plan, kernels, scale_weights}, arena, buffers, sums);
    scale_weights += plan.num_filters;
  }
  const ScoringLevel level{planes,
                           plan,
                           kernels,
                           packed_weights_.data(),
                           spec_.window,
                           static_cast<float>(intercept_),
                           std::span(maps).first(spec_.scales.size()),
                           as_probability};
  if (mask != nullptr) {
    internal::ScoreRegion(level, *mask, box, region_sums, buffers, output);
  } else {
    ScoreLevel(level, output, buffers, sums);
  }
}

}  // namespace handcraft::features
