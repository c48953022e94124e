// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/channel_planes.h"

#include <algorithm>

namespace handcraft::features::internal {
namespace {

std::ptrdiff_t StrideFor(int width) noexcept { return (kPad + width + kSlack + 15) / 16 * 16; }

}  // namespace

std::size_t ChannelPlanes::NumFloats(int width, int height, int num_channels) noexcept {
  return static_cast<std::size_t>(StrideFor(width)) * static_cast<std::size_t>(height) *
         static_cast<std::size_t>(num_channels);
}

ChannelPlanes::ChannelPlanes(int width, int height, int num_channels, float* memory) noexcept
    : width_(width),
      height_(height),
      num_channels_(num_channels),
      stride_(StrideFor(width)),
      memory_(memory) {}

float* ChannelPlanes::Row(Channel channel, int v) const noexcept {
  const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(channel) * height_ + v;
  return memory_ + row * stride_ + kPad;
}

const float* ChannelPlanes::At(Channel channel, int column, int v) const noexcept {
  return Row(channel, std::clamp(v, 0, height_ - 1)) + column;
}

void ChannelPlanes::PadLeft(Channel channel, int v) noexcept {
  float* row = Row(channel, v);
  std::fill_n(row - kPad, kPad, row[0]);
}

void ChannelPlanes::PadRight(Channel channel, int v) noexcept {
  float* row = Row(channel, v);
  std::fill_n(row + width_, stride_ - kPad - width_, row[width_ - 1]);
}

void ChannelPlanes::Convert(const RawImage& image, const PixelKernels& kernels) noexcept {
  ConvertPart(image, kernels, {.last_u = width_, .last_v = height_});
}

void ChannelPlanes::ConvertPart(const RawImage& image,
                                const PixelKernels& kernels,
                                const RegionBox& part) noexcept {
  const std::ptrdiff_t first_byte = std::ptrdiff_t{NumChannels(image.format)} * part.first_u;
  for (int v = part.first_v; v < part.last_v; ++v) {
    kernels.convert_row(image.data + v * image.stride_bytes + first_byte,
                        image.format,
                        part.last_u - part.first_u,
                        Row(kY, v) + part.first_u,
                        num_channels_ == 3 ? Row(kCb, v) + part.first_u : nullptr,
                        num_channels_ == 3 ? Row(kCr, v) + part.first_u : nullptr);
    for (int i = 0; i < num_channels_; ++i) {
      const auto channel = static_cast<Channel>(i);
      if (part.first_u == 0) PadLeft(channel, v);
      if (part.last_u == width_) PadRight(channel, v);
    }
  }
}

void ChannelPlanes::ShrinkFrom(const ChannelPlanes& source, int reduction) noexcept {
  for (int i = 0; i < num_channels_; ++i) {
    const auto channel = static_cast<Channel>(i);
    for (int v = 0; v < height_; ++v) {
      const int first_row = v * reduction;
      const int last_row = std::min(first_row + reduction, source.height_);
      for (int u = 0; u < width_; ++u) {
        const int first_column = u * reduction;
        const int last_column = std::min(first_column + reduction, source.width_);
        float sum = 0.0F;
        for (int y = first_row; y < last_row; ++y) {
          const float* row = source.Row(channel, y);
          for (int x = first_column; x < last_column; ++x) sum += row[x];
        }
        const int count = (last_row - first_row) * (last_column - first_column);
        Row(channel, v)[u] = sum / static_cast<float>(count);
      }
      PadLeft(channel, v);
      PadRight(channel, v);
    }
  }
}

void FilterStripRow(const ChannelPlanes& planes,
                    const FilterPlan& plan,
                    const PixelKernels& kernels,
                    int x0,
                    int width,
                    int v,
                    StripBuffers& buffers) noexcept {
  const int first_column = x0 - kMaxRadius;
  FilterRowJob job;
  job.count = width + 2 * kMaxRadius;
  job.scratch = buffers.scratch.data();
  job.energies = buffers.energies.data();
  for (int i = 0; i < kKernelSize; ++i) {
    job.y_rows[static_cast<std::size_t>(i)] =
        planes.At(ChannelPlanes::kY, first_column, v + i - kKernelSize / 2);
  }
  if (plan.chroma) {
    for (int i = 0; i < 3; ++i) {
      job.cb_rows[static_cast<std::size_t>(i)] =
          planes.At(ChannelPlanes::kCb, first_column, v + i - 1);
      job.cr_rows[static_cast<std::size_t>(i)] =
          planes.At(ChannelPlanes::kCr, first_column, v + i - 1);
    }
  }
  kernels.filter_row(plan, job);

  const int num_outside_left = kMaxRadius - x0;
  const int num_outside_right = x0 + width + kMaxRadius - planes.width();
  for (int filter = 0; filter < plan.num_filters; ++filter) {
    float* row = job.energies + filter * kStripStride;
    if (num_outside_left > 0) std::fill_n(row, num_outside_left, row[num_outside_left]);
    if (num_outside_right > 0) {
      float* end = row + job.count - num_outside_right;
      std::fill_n(end, num_outside_right, end[-1]);
    }
  }
}

}  // namespace handcraft::features::internal
