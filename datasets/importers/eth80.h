// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/importers/image_set_import.h"

namespace handcraft::datasets {

struct Eth80Options {
  /// Views are kept that were taken at this angle from the vertical [deg]; 90 is level, 0 from
  /// above.
  int polar_deg = 90;
  bool flat_clouds = false;  ///< views get clouds of their silhouettes (FlatCloudOf)

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Lists the views of an ETH-80 tree: OBJECT-PPP-AAA.png with the silhouette
/// maps/OBJECT-PPP-AAA-map.png, at any depth; PPP is the angle from the vertical, AAA the turn. The
/// turns are multiples of 22.5° whose names are rounded; the angle is the multiple. OBJECT is the
/// instance, without its number the class: cup3. No clouds were measured. A picture or a silhouette
/// without the other is left out and stands in the notes. Throws Error when there is no such view,
/// or a silhouette holds colours. Source: B. Leibe, B. Schiele,
/// "Analyzing appearance and contour based methods for object categorization", CVPR 2003, and its
/// data.
[[nodiscard]] SourceSet ListEth80(const std::filesystem::path& source, const Eth80Options& options);

}  // namespace handcraft::datasets
