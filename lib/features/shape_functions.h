// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>

#include "lib/features/vector3.h"

namespace handcraft::features {

inline constexpr std::size_t kShapeBins = 64;  ///< of each of the ten histograms
inline constexpr std::size_t kShapeFunctionsSize = 10 * kShapeBins;
inline constexpr int kNumTriangles = 20000;  ///< drawn, unless every other draw is a sliver

/// Bytes of scratch memory, aligned to 8, that DescribeByShapeFunctions works in.
[[nodiscard]] std::size_t ShapeFunctionsWorkspace(std::size_t num_points) noexcept;

/// Ensemble of shape functions. Points are taken from their mean and scaled into a ball of radius
/// 32, in a grid of 64³ voxels of which those of the points and their 26 neighbours are full. Of
/// triangles of three points drawn at random, with sides a, b, c and area A, are counted, in this
/// order, with the weights 0.5, 0.5, 0.5 (A3), 0.5, 0.5, 1 (D3), 0.5, 2, 2 (D2), 1 (ratio):
///   A3     acute angle between the lines of two sides, over [0, π/2], times voxels of the third
///          side / 32
///   D3     √A / max √A
///   D2     length of each side / max length
///   ratio  full voxels / voxels of each mixed side
/// each but the last in a histogram for `in`, one for `out` and one for `mixed`. A side's voxels
/// are those of the line from its first point's to, but not with, its last point's; it is in when
/// at most one of them is empty, else out when at most 7 are full. A triangle is out when its
/// sides have at most 21 full ones together, else in when fewer than 4 are empty. Value x in
/// [0, 1] goes to bin round(63 x); all numbers together add up to 1. Slivers of
/// A² ≤ 0.001 are drawn again, 2 · kNumTriangles draws at most; without a triangle all is 0.
///
/// Draws depend on the number of points alone (stream "shape functions" of seed 1). `workspace` is
/// of ShapeFunctionsWorkspace bytes. Does not allocate; thread-safe. Source: W. Wohlkinger,
/// M. Vincze, "Ensemble of shape functions for 3D object classification", ROBIO 2011, section III;
/// numbers that the paper does not give are those of the Point Cloud Library.
void DescribeByShapeFunctions(std::span<const Vector3> points_m,
                              std::span<std::byte> workspace,
                              std::span<float, kShapeFunctionsSize> histogram) noexcept;

}  // namespace handcraft::features
