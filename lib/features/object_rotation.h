// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "lib/features/mask_moments.h"
#include "lib/features/object_plane.h"

namespace handcraft::features {

/// What layer 2 knows of a view of an object.
struct ViewDescription {
  Vector3 normal = {};         ///< of the best-fit plane; a line: n and −n are the same
  Vector3 mean_m = {};         ///< p_m, mean of the points that count
  HalvesMoments moments = {};  ///< of the mask
};

/// Plane and moments of a view. `scratch` holds ObjectPlaneScratch floats. The description is
/// whole only without fault. Does not allocate; thread-safe.
[[nodiscard]] CloudFault DescribeView(const ObjectCloud& cloud,
                                      std::span<float> scratch,
                                      ViewDescription& description) noexcept;

/// Which moments are compared. The numbers stand in model files.
enum class ComparedMoments : std::uint8_t {
  kPrinted = 0,    ///< Eq. 4.5 as it stands: μ00 and μ11 of both halves, in pixels
  kScaleFree = 1,  ///< the same without units: μ00 over the whole area, η11
  kAll = 2,        ///< area share and the η of order 2 and 3 of both halves, each over its
                   ///< standard deviation among the class's views; mean square of the differences
};
[[nodiscard]] std::string_view NameOf(ComparedMoments moments) noexcept;

inline constexpr std::size_t kMaxCandidates = 64;

/// How the nearest view is found.
struct RotationRule {
  ComparedMoments moments = ComparedMoments::kAll;
  /// Views nearest by the angle between plane normals that are looked at, at most kMaxCandidates;
  /// the dissertation's are 6. 0: all.
  std::size_t num_candidates = 0;
  /// The cost is that of the moments plus (angle_weight · angle between the normals [rad])².
  double angle_weight = 1.0;
};

/// Views of one class, in somebody else's memory.
struct KnownViews {
  std::span<const double> normals;  ///< num_views × 3
  std::span<const double> moments;  ///< num_views × kNumMoments
  std::span<const double> scales;   ///< kNumMoments, > 0: read by kAll alone

  [[nodiscard]] std::size_t size() const noexcept { return normals.size() / 3; }
};

/// The scales of kAll: the standard deviation of each compared moment over the views, 1 where they
/// do not differ.
[[nodiscard]] HalvesMoments MomentScales(std::span<const double> moments) noexcept;

/// Angle between two lines through the origin, in [0, π/2] [rad]: Eq. 4.3 with |n · m|, since a
/// plane has two normals. Exact to rounding near 0.
[[nodiscard]] double AngleBetweenLines(const Vector3& a, const Vector3& b) noexcept;

/// The known view most like another: of the candidates by Eq. 4.3, the one that minimises Eq. 4.5.
/// Of equal ones the first. At least one view. Does not allocate; thread-safe.
/// Source: dissertation section 4.2.3.
[[nodiscard]] std::size_t NearestView(const ViewDescription& view,
                                      const KnownViews& known,
                                      const RotationRule& rule) noexcept;

}  // namespace handcraft::features
