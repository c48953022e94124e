// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "lib/features/grasp_library.h"
#include "lib/runtime/model_header.h"
#include "lib/runtime/result.h"

namespace handcraft::runtime {

/// How to hold objects of known classes (docs/model_format.md § 11). Immutable: any number of
/// threads may use one, each with scratch memory of its own.
struct GraspLibraryModel {
  features::GraspLibrary library;
  std::vector<std::string> class_names;

  struct Answer {
    features::CloudFault fault = features::CloudFault::kNone;
    features::FoundGrasp grasp;  ///< only without fault
    bool is_rejected = false;    ///< the nearest pose is farther than the model allows
  };

  /// Layers 2 and 3 of the dissertation for an object of class `number`. `scratch` holds
  /// ObjectPlaneScratch floats. Does not allocate.
  [[nodiscard]] Answer Find(std::size_t number,
                            const features::ObjectCloud& cloud,
                            const features::GraspRequest& request,
                            std::span<float> scratch) const noexcept;
};

/// Takes a grasp library out of a parsed file, checks every rule of § 11 and runs its self-test.
[[nodiscard]] Result<GraspLibraryModel> LoadGraspLibrary(const ParsedModel& parsed);

}  // namespace handcraft::runtime
