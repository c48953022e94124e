// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/pixel_scorer.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lib/core/check.h"
#include "lib/features/channel_planes.h"

namespace handcraft::features {
namespace {

using internal::ChannelPlanes;
using internal::kStripStride;
using internal::kStripWidth;

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

// Decision values of a shrunk picture, added to the pixels they stand for.
struct ScaleMap {
  int reduction = 1;
  int width = 0;
  const float* values = nullptr;
};

// Distinct scales are numbers from 2 to 16 (FaultOf).
constexpr std::size_t kMaxScales = 15;

// One picture (or one shrunk copy) and everything its scores take.
struct Level {
  const ChannelPlanes& planes;
  const internal::FilterPlan& plan;
  const internal::PixelKernels& kernels;
  const float* weights;
  int window;
  float intercept;
  std::span<const ScaleMap> maps;
  bool as_probability;
  float* out;
  std::ptrdiff_t stride;
};

void StartRow(const Level& level, int x0, int width, int y, float* sums) noexcept {
  std::fill_n(sums, kStripStride, level.intercept);
  if (y >= level.planes.height()) return;
  for (const ScaleMap& map : level.maps) {
    const float* row = map.values + static_cast<std::ptrdiff_t>(y / map.reduction) * map.width;
    for (int x = 0; x < width; ++x) sums[x] += row[(x0 + x) / map.reduction];
  }
}

// Row by row down the strip: the energies of row v go into the sums of rows v − r … v + r, after
// which row v − r is complete. Rows above and below the picture repeat its first and last energies.
void ScoreStrip(const Level& level,
                int x0,
                int width,
                internal::StripBuffers& buffers,
                StripSums& sums) noexcept {
  const int radius = level.window / 2;
  const int height = level.planes.height();
  const auto row_of = [&](int y) {
    return sums.rows[static_cast<std::size_t>((y + 2 * level.window) % level.window)].data();
  };
  for (int y = -2 * radius; y < 0; ++y) std::fill_n(row_of(y), kStripStride, 0.0F);

  internal::CorrelateRowJob job{.energies = buffers.energies.data(),
                                .weights = level.weights,
                                .num_filters = level.plan.num_filters,
                                .window = level.window,
                                .count = width};
  for (int v = -radius; v < height + radius; ++v) {
    if (v == -radius || (v > 0 && v < height)) {
      FilterStripRow(level.planes, level.plan, level.kernels, x0, width, std::max(v, 0), buffers);
    }
    StartRow(level, x0, width, v + radius, row_of(v + radius));
    for (int j = 0; j < level.window; ++j) {
      job.sums[static_cast<std::size_t>(j)] = row_of(v + radius - j);
    }
    level.kernels.correlate_row(job);
    const int finished = v - radius;
    if (finished < 0) continue;
    float* row = row_of(finished);
    if (level.as_probability) level.kernels.sigmoid_row(row, width);
    std::copy_n(row, width, level.out + finished * level.stride + x0);
  }
}

void ScoreLevel(const Level& level, internal::StripBuffers& buffers, StripSums& sums) noexcept {
  for (int x0 = 0; x0 < level.planes.width(); x0 += kStripWidth) {
    ScoreStrip(level, x0, std::min(kStripWidth, level.planes.width() - x0), buffers, sums);
  }
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
                      Arena::RoundedBytes(sizeof(StripSums));
  for (const int scale : spec_.scales) {
    const int width = internal::ShrunkSide(max_width, scale);
    const int height = internal::ShrunkSide(max_height, scale);
    bytes += rounded(ChannelPlanes::NumFloats(width, height, num_channels)) +
             rounded(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  }
  return bytes;
}

void PixelScorer::Score(const RawImage& image,
                        std::span<std::byte> workspace,
                        float* probabilities,
                        std::ptrdiff_t stride) const noexcept {
  Run(image, workspace, probabilities, stride, true);
}

void PixelScorer::ScoreDecisionValues(const RawImage& image,
                                      std::span<std::byte> workspace,
                                      float* decision_values,
                                      std::ptrdiff_t stride) const noexcept {
  Run(image, workspace, decision_values, stride, false);
}

void PixelScorer::Run(const RawImage& image,
                      std::span<std::byte> workspace,
                      float* out,
                      std::ptrdiff_t stride,
                      bool as_probability) const noexcept {
  const internal::PixelKernels& kernels = internal::KernelsFor(instruction_set_);
  const internal::FilterPlan plan(spec_);
  const int num_channels = spec_.NeedsColour() ? 3 : 1;
  Arena arena(workspace.data());
  auto& buffers = *arena.Take<internal::StripBuffers>(1);
  auto& sums = *arena.Take<StripSums>(1);
  const auto make_planes = [&](int width, int height) {
    const std::size_t num_floats = ChannelPlanes::NumFloats(width, height, num_channels);
    return ChannelPlanes(width, height, num_channels, arena.Take<float>(num_floats));
  };
  ChannelPlanes planes = make_planes(image.width, image.height);
  planes.Convert(image, kernels);

  const float* scale_weights =
      packed_weights_.data() + plan.num_filters * spec_.window * spec_.window;
  std::array<ScaleMap, kMaxScales> maps{};
  std::size_t num_maps = 0;
  for (const int scale : spec_.scales) {
    ChannelPlanes small = make_planes(internal::ShrunkSide(image.width, scale),
                                      internal::ShrunkSide(image.height, scale));
    small.ShrinkFrom(planes, scale);
    auto* values = arena.Take<float>(static_cast<std::size_t>(small.width()) *
                                     static_cast<std::size_t>(small.height()));
    ScoreLevel({small, plan, kernels, scale_weights, 1, 0.0F, {}, false, values, small.width()},
               buffers,
               sums);
    maps[num_maps++] = {scale, small.width(), values};
    scale_weights += plan.num_filters;
  }
  ScoreLevel({planes,
              plan,
              kernels,
              packed_weights_.data(),
              spec_.window,
              static_cast<float>(intercept_),
              std::span(maps).first(num_maps),
              as_probability,
              out,
              stride},
             buffers,
             sums);
}

}  // namespace handcraft::features
