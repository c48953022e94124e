// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "lib/features/cloud_grid.h"
#include "lib/features/object_cloud.h"

namespace handcraft::features {

/// What an object's cloud is summed up by. The numbers stand in model files.
enum class CloudDescriptorType : std::uint8_t {
  kGrid = 0,                ///< the mean point of each cell of a grid over the object's pixels
  kDepthGrid = 1,           ///< of the same cells how far the mean is from the robot, alone
  kPolar = 2,               ///< the mean point of each cell of rings and sectors
  kViewpointHistogram = 3,  ///< of the grid's mean points and their normals (VFH)
  kShapeFunctions = 4,      ///< of triangles of the grid's mean points (ESF)
};
inline constexpr std::size_t kNumCloudDescriptors = 5;
[[nodiscard]] std::string_view NameOf(CloudDescriptorType type) noexcept;

/// What the coordinates are divided by. The numbers stand in model files.
enum class CloudScaling : std::uint8_t {
  kMetric = 0,  ///< nothing: metres
  kUnit = 1,    ///< the spread of the cells' means about the object's
};
[[nodiscard]] std::string_view NameOf(CloudScaling scaling) noexcept;

/// In which frame the points are given. The numbers stand in model files.
enum class CloudFrame : std::uint8_t {
  kBase = 0,    ///< x away from the robot, z up
  kCamera = 1,  ///< optical: z away from the camera, x right, y down
};
[[nodiscard]] std::string_view NameOf(CloudFrame frame) noexcept;

/// "fitted" or "square".
[[nodiscard]] std::string_view NameOf(GridBox box) noexcept;

/// Turns the cloud of an object into a feature vector of constant length. With M the mean of the
/// object's points and m_c, n_c the mean and number of those in cell c (SumCells, SumPolarCells)
/// the first three are
///   F_c = (m_c − M) / s,   F_c = 0 where n_c = 0,
/// s = 1 (metric) or s² = Σ n_c |m_c − M|² / Σ n_c (unit).
///
/// Laws. Moving all points by one vector changes nothing but rounding. The cells follow the
/// object's pixels: the same object seen with other pixel sizes falls into the same cells. Its
/// coordinates are metres all the same: points k times as far apart give k times the metric
/// features, and the same ones with kUnit.
///
/// The histograms (viewpoint_histogram.h, shape_functions.h) are those of the points m_c − M of the
/// cells with n_c > 0; a fine or a coarse picture gives as many. The first has the normals of
/// cell_normals.h and the camera at the frame's origin. Points k times as far apart, or moved by
/// one vector, give the same kShapeFunctions; points k times as far away the same
/// kViewpointHistogram.
/// Source: dissertation, section 4.2.2, Algorithm 1 and docs/methods/object_class.md.
struct CloudDescriptor {
  CloudDescriptorType type = CloudDescriptorType::kGrid;
  int grid_size = 50;  ///< cells along each side (rings, sectors); 1 to kMaxGridSize
  CloudScaling scaling = CloudScaling::kMetric;
  CloudFrame frame = CloudFrame::kBase;  ///< says which axis is depth
  GridBox box = GridBox::kFitted;        ///< of grid and depth-grid

  /// Whether the camera is where the descriptor takes it to be: kViewpointHistogram needs kCamera.
  [[nodiscard]] bool FrameFits() const noexcept {
    return type != CloudDescriptorType::kViewpointHistogram || frame == CloudFrame::kCamera;
  }
  /// Grid and polar: 3 · grid_size² numbers, cell after cell (row by row), x, y, z of each; depth:
  /// one a cell; viewpoint histogram: 308; shape functions: 640.
  [[nodiscard]] std::size_t NumFeatures() const noexcept;
  /// Bytes of scratch memory, aligned to 8, that Compute works in.
  [[nodiscard]] std::size_t WorkspaceBytes() const noexcept;
  /// Writes NumFeatures() finite numbers; false, and zeros, when fewer than kMinObjectPoints points
  /// of the object were measured. Sums in double, rounds once to float. Does not allocate;
  /// thread-safe, each thread with a workspace of its own.
  [[nodiscard]] bool Compute(const ObjectCloud& cloud,
                             std::span<std::byte> workspace,
                             std::span<float> features) const noexcept;
};

}  // namespace handcraft::features
