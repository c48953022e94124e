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
#include "lib/runtime/svm_model.h"

/// What stands behind the C interface's pointers.
struct hc_model {
  std::variant<handcraft::features::PixelScorer,
               handcraft::runtime::LogisticModel,
               handcraft::runtime::SvmModel,
               handcraft::runtime::GraspLibraryModel>
      predictor;
  std::vector<std::pair<std::string, std::string>> metadata;  ///< by key
};

struct hc_workspace {
  handcraft::runtime::AlignedBuffer buffer;
  std::int32_t max_width;   ///< [px]; 0 for rows
  std::int32_t max_height;  ///< [px]; 0 for rows
};
