// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/importers/image_set_import.h"

namespace handcraft::datasets {

struct BopOptions {
  double min_visible = 0.1;  ///< least share of an object that is seen (visib_fract), [0, 1]
  int margin_px = 10;        ///< of the cut-out around what is seen, 0 … 65535

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Lists the views of BOP scenes (LINEMOD and others): scene_gt.json, scene_camera.json, rgb/ or
/// gray/, mask_visib/ and, if there are any, depth/ and scene_gt_info.json, at any depth. A view is
/// one object in one picture, cut out of it with its mask and cloud; objects of which less than
/// `min_visible` is seen are left out, as far as scene_gt_info.json tells. obj_NNNNNN is instance
/// and class.
///
/// The base frame has its origin and z axis where the model has its own, and x away from the
/// camera, so that the angle is that of the model's x axis. Where the camera looks along z (within
/// 5°) the base frame is the model's and the angle unknown.
///
/// What is left out for want of a picture or a mask, and views without a cloud, stand in the notes.
/// Throws Error with the place in the file when it is not as specified, a pose is none, or pictures
/// do not fit each other.
/// Source: "Format of BOP datasets", github.com/thodan/bop_toolkit, docs/bop_datasets_format.md.
[[nodiscard]] SourceSet ListBop(const std::filesystem::path& source, const BopOptions& options);

}  // namespace handcraft::datasets
