// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>

#include "lib/features/cloud_grid.h"
#include "lib/features/vector3.h"

namespace handcraft::features {

/// A cell of the grid that holds points.
struct SurfacePoint {
  Vector3 point_m = {};  ///< their mean, from the mean of all
  Vector3 normal = {};   ///< of length 1, towards the viewpoint; 0: none
};

/// Cells on each side of one that its normal is fitted to.
inline constexpr int kNormalRadius = 2;

/// Takes the mean points of a grid's cells, from `mean_m`, and the normals of the surface they lie
/// on. To the window of (2 · kNormalRadius + 1)² cells about a cell, r rows and c columns from it,
/// p(r, c) = p₀ + a c + b r is fitted with least squares over the cells with points; the normal is
/// ± a × b / |a × b|, on the side of the viewpoint (from `mean_m` too). A cell has none where the
/// window's cells lie in one line, in the picture or in space. Points that move together, grow
/// about the viewpoint or turn about its axis (with their cells) keep, or turn, their normals.
///
/// `surface` has side² entries and gets one for each cell that is not empty, in the order of cells;
/// their number is returned. `sums` is left with the means, each as if of one point. Does not
/// allocate; thread-safe. Source: the average gradient of S. Holzer et al., "Adaptive neighborhood
/// selection for real-time surface normal estimation from organized point cloud data", IROS 2012,
/// section III-B, with the plane's least squares in place of central differences: cells may be
/// empty.
std::size_t FindCellNormals(std::span<CellSum> sums,
                            int side,
                            const Vector3& mean_m,
                            const Vector3& viewpoint_m,
                            std::span<SurfacePoint> surface) noexcept;

}  // namespace handcraft::features
