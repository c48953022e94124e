// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "lib/runtime/model_header.h"
#include "lib/runtime/svm_model.h"

namespace handcraft::runtime {

/// Builds a model of kind "svm", version 1 (docs/model_format.md § 9), and runs the stored
/// self-test. Errors: HC_ERROR_CONTENT, HC_ERROR_SELF_TEST. Allocates (std::bad_alloc).
[[nodiscard]] Result<SvmModel> LoadSvmModel(const ParsedModel& parsed);

}  // namespace handcraft::runtime
