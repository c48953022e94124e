// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lib/features/pixel_scorer.h"
#include "lib/runtime/aligned_buffer.h"
#include "lib/runtime/grasp_library_model.h"
#include "lib/runtime/handcraft_runtime.h"
#include "lib/runtime/logistic_model.h"
#include "lib/runtime/object_class_model.h"
#include "lib/runtime/svm_model.h"

/// What stands behind the C interface's pointers.
struct hc_model {
  std::variant<handcraft::features::PixelScorer,
               handcraft::runtime::LogisticModel,
               handcraft::runtime::SvmModel,
               handcraft::runtime::ObjectClassModel,
               handcraft::runtime::GraspLibraryModel>
      predictor;
  std::vector<std::pair<std::string, std::string>> metadata;  ///< by key

  /// The machines of a model of classes; null for other kinds.
  [[nodiscard]] const handcraft::runtime::SvmModel* Svm() const noexcept {
    using handcraft::runtime::ObjectClassModel;
    if (const auto* classes = std::get_if<ObjectClassModel>(&predictor)) return &classes->svm;
    return std::get_if<handcraft::runtime::SvmModel>(&predictor);
  }
};

struct hc_workspace {
  handcraft::runtime::AlignedBuffer buffer;
  std::int32_t max_width;   ///< [px]; 0 for rows and clouds
  std::int32_t max_height;  ///< [px]; 0 for rows and clouds
};
