// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/cloud_descriptor.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handcraft::features {
namespace {

std::size_t NumCells(const CloudDescriptor& descriptor) noexcept {
  const auto side = static_cast<std::size_t>(descriptor.grid_size);
  return side * side;
}

using Vector = std::array<double, 3>;

Vector Mean(std::span<const CellSum> sums) noexcept {
  CellSum all;
  for (const CellSum& sum : sums) {
    all.x += sum.x;
    all.y += sum.y;
    all.z += sum.z;
    all.count += sum.count;
  }
  return {all.x / all.count, all.y / all.count, all.z / all.count};
}

// m_c − M of a cell that is not empty.
Vector Offset(const CellSum& sum, const Vector& mean) noexcept {
  return {sum.x / sum.count - mean[0], sum.y / sum.count - mean[1], sum.z / sum.count - mean[2]};
}

// 1 / s; 0 when all means are the same point.
double InverseSpread(std::span<const CellSum> sums, const Vector& mean) noexcept {
  double squares = 0.0;
  double count = 0.0;
  for (const CellSum& sum : sums) {
    if (sum.count == 0.0) continue;
    const Vector offset = Offset(sum, mean);
    squares += sum.count * (offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]);
    count += sum.count;
  }
  return squares > 0.0 ? std::sqrt(count / squares) : 0.0;
}

}  // namespace

std::string_view NameOf(CloudDescriptorType type) noexcept {
  switch (type) {
    case CloudDescriptorType::kGrid:
      return "grid";
    case CloudDescriptorType::kDepthGrid:
      return "depth-grid";
    case CloudDescriptorType::kPolar:
      return "polar";
  }
  return "unknown";
}

std::string_view NameOf(CloudScaling scaling) noexcept {
  return scaling == CloudScaling::kMetric ? "metric" : "unit";
}

std::string_view NameOf(CloudFrame frame) noexcept {
  return frame == CloudFrame::kBase ? "base" : "camera";
}

std::string_view NameOf(GridBox box) noexcept {
  return box == GridBox::kFitted ? "fitted" : "square";
}

std::size_t CloudDescriptor::NumFeatures() const noexcept {
  return NumCells(*this) * (type == CloudDescriptorType::kDepthGrid ? 1 : 3);
}

std::size_t CloudDescriptor::WorkspaceBytes() const noexcept {
  return NumCells(*this) * sizeof(CellSum);
}

bool CloudDescriptor::Compute(const ObjectCloud& cloud,
                              std::span<std::byte> workspace,
                              std::span<float> features) const noexcept {
  const std::span sums(reinterpret_cast<CellSum*>(workspace.data()), NumCells(*this));
  std::fill(features.begin(), features.end(), 0.0F);
  const std::size_t num_points = type == CloudDescriptorType::kPolar
                                     ? SumPolarCells(cloud, grid_size, sums)
                                     : SumCells(cloud, grid_size, box, sums);
  if (num_points < kMinObjectPoints) return false;
  const Vector mean = Mean(sums);
  const double scale = scaling == CloudScaling::kMetric ? 1.0 : InverseSpread(sums, mean);
  const std::size_t depth_axis = frame == CloudFrame::kBase ? 0 : 2;
  for (std::size_t c = 0; c < sums.size(); ++c) {
    if (sums[c].count == 0.0) continue;
    const Vector offset = Offset(sums[c], mean);
    if (type == CloudDescriptorType::kDepthGrid) {
      features[c] = static_cast<float>(offset[depth_axis] * scale);
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      features[3 * c + axis] = static_cast<float>(offset[axis] * scale);
    }
  }
  return true;
}

}  // namespace handcraft::features
