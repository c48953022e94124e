// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "lib/perception/table_removal.h"

namespace handcraft::experiments {

/// The peer of table removal: the Point Cloud Library's SACSegmentation, put together as its
/// tutorials do it. Only in builds configured with -DHANDCRAFT_PCL_PEER=ON (docs/decisions).
class PclTablePeer {
 public:
  /// Whether this build has the library.
  [[nodiscard]] static bool IsAvailable() noexcept;

  /// Copies the cloud into the library's own type, as a driver would deliver it. Throws
  /// std::logic_error without the library.
  explicit PclTablePeer(const perception::CloudView& cloud);
  ~PclTablePeer();
  PclTablePeer(const PclTablePeer&) = delete;
  PclTablePeer& operator=(const PclTablePeer&) = delete;

  /// Drops unmeasured points; finds one plane by RANSAC whose normal is within the angle of up,
  /// with ε_T as threshold, the library's 50 iterations, and coefficients fitted again to the
  /// inliers; returns the pixels of all other points, ascending.
  [[nodiscard]] std::vector<std::int32_t> PixelsOffTable(
      const perception::TableRemovalOptions& options) const;

 private:
  struct Cloud;
  std::unique_ptr<Cloud> cloud_;
};

}  // namespace handcraft::experiments
