// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "lib/features/pixel_scorer.h"
#include "lib/runtime/model_header.h"

namespace handcraft::runtime {

/// Largest side of a self-test picture [px].
inline constexpr std::uint64_t kMaxSelfTestSide = 256;
/// A self-test allows at most this difference of probability.
inline constexpr float kMaxSelfTestTolerance = 0.1F;

/// Builds the scorer of a model of kind "grasp_point", version 1 (docs/model_format.md § 5), checks
/// that the model's filters are those of this library, and runs the stored self-test. Errors:
/// HC_ERROR_CONTENT, HC_ERROR_SELF_TEST. Allocates (std::bad_alloc).
[[nodiscard]] Result<features::PixelScorer> LoadGraspPointScorer(const ParsedModel& model);

}  // namespace handcraft::runtime
