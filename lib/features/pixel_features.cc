// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/pixel_features.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "lib/core/check.h"
#include "lib/features/channel_planes.h"

namespace handcraft::features {
namespace {

using internal::ChannelPlanes;

// All energies of a picture, [filter][row][column].
std::vector<float> FilterPicture(const ChannelPlanes& planes,
                                 const internal::FilterPlan& plan,
                                 const internal::PixelKernels& kernels) {
  const auto width = static_cast<std::ptrdiff_t>(planes.width());
  const std::ptrdiff_t plane_size = width * planes.height();
  std::vector<float> energies(static_cast<std::size_t>(plane_size * plan.num_filters));
  const auto buffers = std::make_unique<internal::StripBuffers>();
  for (int x0 = 0; x0 < planes.width(); x0 += internal::kStripWidth) {
    const int strip_width = std::min(internal::kStripWidth, planes.width() - x0);
    for (int v = 0; v < planes.height(); ++v) {
      FilterStripRow(planes, plan, kernels, x0, strip_width, v, *buffers);
      for (int filter = 0; filter < plan.num_filters; ++filter) {
        const float* row =
            buffers->energies.data() + filter * internal::kStripStride + internal::kMaxRadius;
        std::copy_n(row, strip_width, energies.data() + filter * plane_size + v * width + x0);
      }
    }
  }
  return energies;
}

}  // namespace

PixelFeatures::PixelFeatures(const RawImage& image,
                             FeatureSpec spec,
                             InstructionSet instruction_set)
    : spec_(std::move(spec)), width_(image.width), height_(image.height) {
  HC_CHECK(FaultOf(spec_).empty(), FaultOf(spec_));
  HC_CHECK(width_ > 0 && height_ > 0, width_, height_);
  HC_CHECK(!spec_.NeedsColour() || image.format != PixelFormat::kGray8);
  const internal::PixelKernels& kernels = internal::KernelsFor(instruction_set);
  const internal::FilterPlan plan(spec_);
  const int num_channels = spec_.NeedsColour() ? 3 : 1;

  std::vector<float> memory(ChannelPlanes::NumFloats(width_, height_, num_channels));
  ChannelPlanes planes(width_, height_, num_channels, memory.data());
  planes.Convert(image, kernels);
  levels_.push_back({1, width_, height_, FilterPicture(planes, plan, kernels)});
  for (const int scale : spec_.scales) {
    const int width = internal::ShrunkSide(width_, scale);
    const int height = internal::ShrunkSide(height_, scale);
    std::vector<float> small_memory(ChannelPlanes::NumFloats(width, height, num_channels));
    ChannelPlanes small(width, height, num_channels, small_memory.data());
    small.ShrinkFrom(planes, scale);
    levels_.push_back({scale, width, height, FilterPicture(small, plan, kernels)});
  }
}

ImageView<float> PixelFeatures::EnergyPlane(int filter_index) const noexcept {
  const std::ptrdiff_t plane_size = static_cast<std::ptrdiff_t>(width_) * height_;
  return {levels_.front().energies.data() + filter_index * plane_size, width_, height_, 1, width_};
}

void PixelFeatures::Gather(int u, int v, std::span<float> features) const {
  HC_CHECK(u >= 0 && u < width_ && v >= 0 && v < height_, u, v, width_, height_);
  HC_CHECK(features.size() == static_cast<std::size_t>(spec_.NumFeatures()), features.size());
  float* out = features.data();
  const auto take = [&](const Level& level, int x, int y) {
    const std::ptrdiff_t plane_size = static_cast<std::ptrdiff_t>(level.width) * level.height;
    const float* energy = level.energies.data() + static_cast<std::ptrdiff_t>(y) * level.width + x;
    for (int filter = 0; filter < spec_.NumFilters(); ++filter, energy += plane_size)
      *out++ = *energy;
  };
  const int radius = spec_.window / 2;
  for (int dv = -radius; dv <= radius; ++dv) {
    for (int du = -radius; du <= radius; ++du) {
      take(levels_.front(), std::clamp(u + du, 0, width_ - 1), std::clamp(v + dv, 0, height_ - 1));
    }
  }
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    take(levels_[i], u / levels_[i].reduction, v / levels_[i].reduction);
  }
}

}  // namespace handcraft::features
