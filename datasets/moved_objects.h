// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "datasets/formats/view_set.h"
#include "datasets/object_clouds.h"

namespace handcraft::datasets {

/// Copies of a view as if the object stood elsewhere on the table and were larger or smaller, so
/// that a few views from one place teach what many places look like.
struct MovedCopyOptions {
  int num_copies = 0;            ///< of each view; 0: none
  double forward_m = 0.1;        ///< moved by up to so much along x, either way; 0 to 10
  double sideways_m = 0.22;      ///< and along y
  double least_scale = 0.8;      ///< 0.1 to 1
  double greatest_scale = 1.25;  ///< 1 to 10
  std::uint64_t seed = 1;

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("num_copies", num_copies);
    visit("forward_m", forward_m);
    visit("sideways_m", sideways_m);
    visit("least_scale", least_scale);
    visit("greatest_scale", greatest_scale);
    visit("seed", seed);
  }
};

/// Where an object is moved to.
struct Movement {
  Eigen::Vector3f shift_m = Eigen::Vector3f::Zero();
  float scale = 1.0F;  ///< about its foot: the middle of its points, at their lowest
};

/// The object's points (in the base frame, z up) moved, seen by the same camera: each goes to the
/// pixel that it is projected to, of several the nearest stays. The camera's intrinsics are taken
/// from the cloud itself, u = f x / z + c fitted to its pixels. What the object hid stays unseen,
/// and what it would hide is seen. The cloud has the size of the object's new box. Throws
/// Error(kBadInput) when the pixels are not those of a camera at the cloud's VIEWPOINT, within 2
/// px, or the object would come behind it.
[[nodiscard]] MaskedCloud MoveObject(const MaskedCloud& object, const Movement& movement);

/// Describes num_copies moved copies of every view: row k · num_views + i is copy k of view i,
/// whose movement depends on seed, i and k alone. Throws Error as DescribeViews and MoveObject do.
[[nodiscard]] CloudFeatures DescribeMovedCopies(const ViewSet& set,
                                                const features::CloudDescriptor& descriptor,
                                                const ObjectCloudOptions& options,
                                                const MovedCopyOptions& copies,
                                                int num_threads = 1,
                                                const Progress& progress = {});

}  // namespace handcraft::datasets
