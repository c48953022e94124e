// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "lib/features/object_cloud.h"
#include "lib/features/vector3.h"

namespace handcraft::features {

/// Why a cloud has no best-fit plane, or its picture no moments.
enum class CloudFault : std::uint8_t {
  kNone,
  kTooFewPoints,   ///< fewer than three were measured
  kOnALine,        ///< variance across below 1e-8 of that along
  kNoSinglePlane,  ///< as thick as it is wide (to 1e-6 of its length): a ball, a pencil
  kEmptyHalf,      ///< no pixel left, or right, of the mask's centroid
};
/// A sentence's end: "has fewer than three measured points".
[[nodiscard]] std::string_view NameOf(CloudFault fault) noexcept;

/// Plane of an object's cloud.
struct ObjectPlane {
  CloudFault fault = CloudFault::kTooFewPoints;
  Vector3 normal = {};         ///< of length 1; which of its two directions means nothing
  Vector3 mean_m = {};         ///< of the points that count
  std::size_t num_points = 0;  ///< that count
};

/// Floats of scratch memory that FitObjectPlane works in.
[[nodiscard]] constexpr std::size_t ObjectPlaneScratch(int width, int height) noexcept {
  return 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// Orthogonal distance regression: the plane that minimises Σ (n · p_i − d)², |n| = 1, goes through
/// the mean and has for normal the eigenvector of the least eigenvalue of the points' covariance.
/// Three times, points farther from the mean than 3 standard deviations along an axis of the base
/// are left out and the plane is fitted again: a stereo matcher smears silhouettes. Sums are formed
/// in double about the first point. Does not allocate; thread-safe; the same bits with any
/// instructions. The cloud has a mask. Source: dissertation section 4.2.3.
[[nodiscard]] ObjectPlane FitObjectPlane(const ObjectCloud& cloud,
                                         std::span<float> scratch) noexcept;

}  // namespace handcraft::features
