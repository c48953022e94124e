// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "lib/features/grasp_library.h"
#include "lib/model_io/model_writer.h"
#include "lib/model_io/provenance.h"

namespace handcraft::model_io {

/// What a grasp library's numbers are called and where they are measured.
struct GraspLibraryNames {
  std::vector<std::string> classes;
  std::string robot = {};                ///< name in the URDF; empty: not told
  std::vector<std::string> joints = {};  ///< of the arm that showed the poses; empty: not told
};

/// The frames of demonstration sets (docs/datasets.md).
inline constexpr const char* kBaseFrame = "base";
inline constexpr const char* kGraspCentreFrame = "grasp_centre";

/// Kind "grasp_library", docs/model_format.md § 11. The self-test is a bent cloud that this library
/// answers for every class. Deterministic. Throws std::logic_error when sizes do not fit,
/// Error(kBadInput) for a name that is empty, has a line break or is not UTF-8.
[[nodiscard]] ModelFile MakeGraspLibraryModel(const features::GraspLibrary& library,
                                              const GraspLibraryNames& names,
                                              const Provenance& provenance);

}  // namespace handcraft::model_io
