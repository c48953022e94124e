// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "lib/perception/cloud_view.h"
#include "lib/perception/plane_fit.h"

namespace handcraft::perception {

/// How the support is looked for. min_share = 0 and refinements = 0 is the dissertation's rule.
struct TableRemovalOptions {
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();  ///< in the cloud's frame, of any length but 0
  float max_angle_rad = 0.175F;                   ///< between a plane's normal and up, in (0, π/2]
  float epsilon_m = 0.01F;        ///< ε_T: points nearer to the plane go; in (0, 1]
  int neighbourhood_px = 7;       ///< neighbours lie at most so many rows and columns away; 1…100
  float neighbourhood_m = 0.05F;  ///< and so far away [m], in (0, 10]
  int min_neighbours = 20;        ///< fewer make no plane; 3…40000
  int max_tries = 50;             ///< neighbourhoods drawn at most; 1…100000
  float enough_removed = 0.95F;   ///< share of the measured points at which it ends, in (0, 1]
  float min_share = 0.15F;        ///< a plane with a smaller share is not the support; in [0, 1]
  int refinements = 2;            ///< times a plane is fitted again to all points near it; 0…10
  int max_samples = 5000;  ///< points of the regular sample planes are looked for in; ≥ 100
  std::uint64_t seed = 1;

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("up_x", up.x());
    visit("up_y", up.y());
    visit("up_z", up.z());
    visit("max_angle_rad", max_angle_rad);
    visit("epsilon_m", epsilon_m);
    visit("neighbourhood_px", neighbourhood_px);
    visit("neighbourhood_m", neighbourhood_m);
    visit("min_neighbours", min_neighbours);
    visit("max_tries", max_tries);
    visit("enough_removed", enough_removed);
    visit("min_share", min_share);
    visit("refinements", refinements);
    visit("max_samples", max_samples);
    visit("seed", seed);
  }
};

/// What the search for the support came to.
enum class TableState {
  kNoPoints,  ///< nothing was measured
  kNoPlane,   ///< no plane stayed: nothing is removed
  kFound,
};

struct TablePlanes {
  TableState state = TableState::kNoPoints;
  std::vector<Plane> planes;  ///< as found, normals on the side of up
  int num_tries = 0;          ///< neighbourhoods drawn
};

/// Looks for the planes an object may stand on: draws a point that is left, fits a plane to its
/// neighbours in the picture by orthogonal distance regression, and keeps it when its normal is
/// within max_angle_rad of up (either way), it holds a share of the points and still does when
/// fitted again to those; points within ε_T of it are no longer drawn. Ends when max_tries
/// neighbourhoods were drawn or enough_removed of the points are gone. Draws from stream
/// ("table_removal"). Shares are counted on a regular sample of the pixels; the neighbours are all
/// of the picture's. The options must be valid.
/// Source: dissertation section 3.2.2, after R. Rusu et al., "Towards 3D point cloud based object
/// maps for household environments", 2008.
[[nodiscard]] TablePlanes FindTable(const CloudView& cloud, const TableRemovalOptions& options);

/// Puts the measured points that lie at least epsilon_m from every plane and on the normal's side
/// of one of them into `rest`, in the order of their pixels, and returns how many were measured:
/// what is below every support, as a floor beyond the table's edge, stands on none. All stay where
/// there are no planes. One pass; allocates only where `rest` is too small.
std::size_t TakePointsOffPlanes(const CloudView& cloud,
                                const std::vector<Plane>& planes,
                                float epsilon_m,
                                PixelPoints& rest);

}  // namespace handcraft::perception
