// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/cloud_descriptor.h"

#include <algorithm>
#include <cmath>

#include "lib/features/cell_normals.h"
#include "lib/features/shape_functions.h"
#include "lib/features/vector3.h"
#include "lib/features/viewpoint_histogram.h"

namespace handcraft::features {
namespace {

std::size_t NumCells(const CloudDescriptor& descriptor) noexcept {
  const auto side = static_cast<std::size_t>(descriptor.grid_size);
  return side * side;
}

Vector3 Mean(std::span<const CellSum> sums) noexcept {
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
Vector3 Offset(const CellSum& sum, const Vector3& mean) noexcept {
  return {sum.x / sum.count - mean[0], sum.y / sum.count - mean[1], sum.z / sum.count - mean[2]};
}

// 1 / s; 0 when all means are the same point.
double InverseSpread(std::span<const CellSum> sums, const Vector3& mean) noexcept {
  double squares = 0.0;
  double count = 0.0;
  for (const CellSum& sum : sums) {
    if (sum.count == 0.0) continue;
    const Vector3 offset = Offset(sum, mean);
    squares += sum.count * (offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]);
    count += sum.count;
  }
  return squares > 0.0 ? std::sqrt(count / squares) : 0.0;
}

// What the cells of a grid are worked up in, behind their sums.
template <class T>
std::span<T> Behind(std::span<CellSum> sums) noexcept {
  return {reinterpret_cast<T*>(sums.data() + sums.size()), sums.size()};
}

void DescribeView(std::span<CellSum> sums, int side, std::span<float> features) noexcept {
  const std::span surface = Behind<SurfacePoint>(sums);
  const Vector3 mean = Mean(sums);
  const Vector3 viewpoint = Subtract({}, mean);
  const std::size_t size = FindCellNormals(sums, side, mean, viewpoint, surface);
  DescribeByViewpointHistogram(
      surface.first(size), viewpoint, features.first<kViewpointHistogramSize>());
}

void DescribeShape(std::span<CellSum> sums,
                   std::span<std::byte> workspace,
                   std::span<float> features) noexcept {
  const std::span points = Behind<Vector3>(sums);
  const Vector3 mean = Mean(sums);
  std::size_t size = 0;
  for (const CellSum& sum : sums) {
    if (sum.count != 0.0) points[size++] = Offset(sum, mean);
  }
  DescribeByShapeFunctions(points.first(size),
                           workspace.subspan(sums.size_bytes() + points.size_bytes()),
                           features.first<kShapeFunctionsSize>());
}

void DescribeCells(const CloudDescriptor& descriptor,
                   std::span<const CellSum> sums,
                   std::span<float> features) noexcept {
  const Vector3 mean = Mean(sums);
  const double scale =
      descriptor.scaling == CloudScaling::kMetric ? 1.0 : InverseSpread(sums, mean);
  const std::size_t depth_axis = descriptor.frame == CloudFrame::kBase ? 0 : 2;
  for (std::size_t c = 0; c < sums.size(); ++c) {
    if (sums[c].count == 0.0) continue;
    const Vector3 offset = Offset(sums[c], mean);
    if (descriptor.type == CloudDescriptorType::kDepthGrid) {
      features[c] = static_cast<float>(offset[depth_axis] * scale);
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      features[3 * c + axis] = static_cast<float>(offset[axis] * scale);
    }
  }
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
    case CloudDescriptorType::kViewpointHistogram:
      return "vfh";
    case CloudDescriptorType::kShapeFunctions:
      return "esf";
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
  switch (type) {
    case CloudDescriptorType::kDepthGrid:
      return NumCells(*this);
    case CloudDescriptorType::kViewpointHistogram:
      return kViewpointHistogramSize;
    case CloudDescriptorType::kShapeFunctions:
      return kShapeFunctionsSize;
    default:
      return 3 * NumCells(*this);
  }
}

std::size_t CloudDescriptor::WorkspaceBytes() const noexcept {
  const std::size_t num_cells = NumCells(*this);
  const std::size_t sums = num_cells * sizeof(CellSum);
  switch (type) {
    case CloudDescriptorType::kViewpointHistogram:
      return sums + num_cells * sizeof(SurfacePoint);
    case CloudDescriptorType::kShapeFunctions:
      return sums + num_cells * sizeof(Vector3) + ShapeFunctionsWorkspace(num_cells);
    default:
      return sums;
  }
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
  switch (type) {
    case CloudDescriptorType::kViewpointHistogram:
      DescribeView(sums, grid_size, features);
      break;
    case CloudDescriptorType::kShapeFunctions:
      DescribeShape(sums, workspace, features);
      break;
    default:
      DescribeCells(*this, sums, features);
  }
  return true;
}

}  // namespace handcraft::features
