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

void ChannelPlanes::PadRow(Channel channel, int v) noexcept {
  float* row = Row(channel, v);
  std::fill_n(row - kPad, kPad, row[0]);
  std::fill_n(row + width_, stride_ - kPad - width_, row[width_ - 1]);
}

void ChannelPlanes::Convert(const RawImage& image, const PixelKernels& kernels) noexcept {
  for (int v = 0; v < height_; ++v) {
    kernels.convert_row(image.data + v * image.stride_bytes,
                        image.format,
                        width_,
                        Row(kY, v),
                        num_channels_ == 3 ? Row(kCb, v) : nullptr,
                        num_channels_ == 3 ? Row(kCr, v) : nullptr);
    for (int channel = 0; channel < num_channels_; ++channel) {
      PadRow(static_cast<Channel>(channel), v);
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
      PadRow(channel, v);
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

  const int num_outside_right = x0 + width + kMaxRadius - planes.width();
  for (int filter = 0; filter < plan.num_filters; ++filter) {
    float* row = job.energies + filter * kStripStride;
    if (x0 == 0) std::fill_n(row, kMaxRadius, row[kMaxRadius]);
    if (num_outside_right > 0) {
      float* end = row + job.count - num_outside_right;
      std::fill_n(end, num_outside_right, end[-1]);
    }
  }
}

}  // namespace handcraft::features::internal
