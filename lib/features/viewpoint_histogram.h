// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>

#include "lib/features/cell_normals.h"
#include "lib/features/vector3.h"

namespace handcraft::features {

/// Bins of each of the four histograms about the centroid, and of that of the viewpoint.
inline constexpr std::size_t kPairBins = 45;
inline constexpr std::size_t kViewpointBins = 128;
inline constexpr std::size_t kViewpointHistogramSize = 4 * kPairBins + kViewpointBins;

/// Viewpoint feature histogram of the points that have a normal: n points p with normals q, their
/// centroid c and the mean q̄ of their normals, which is not made of length 1. With d = p − c, the
/// pair is (s, t) = (q̄, q); where |q · d| is the larger of the two, it is (q, q̄) and d = c − p.
/// With the frame u = s, v = d × u / |d × u|, w = u × v, histograms are taken of
///   α = atan2(w · t, u · t),   β = v · t,   φ = u · d / |d|      45 bins each over [−π, π]
///   δ = |p − c| / max |p − c|                                    45 bins over [0, 1]
///   γ = q · (viewpoint − c) / |viewpoint − c|                    128 bins over [−1, 1]
/// in this order, each point adding 100 / n. A point at the centroid, or with s along d, adds to
/// the last histogram alone. `viewpoint_m` is from where the points are from. No point: zeros.
///
/// Sums in double; does not allocate; thread-safe. Source: R. B. Rusu, G. Bradski, R. Thibaux,
/// J. Hsu, "Fast 3D recognition and pose using the viewpoint feature histogram", IROS 2010, section
/// III, in the form of the Point Cloud Library: its ranges of β and φ are as wide as that of α, so
/// that 15 of their bins are used; its first four histograms have 100 / (n − 1).
void DescribeByViewpointHistogram(std::span<const SurfacePoint> surface,
                                  const Vector3& viewpoint_m,
                                  std::span<float, kViewpointHistogramSize> histogram) noexcept;

}  // namespace handcraft::features
