// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string_view>

#include "datasets/importers/labelled_shapes.h"

namespace handcraft::datasets {

/// The runs that a compressed COCO text stands for. A number is written in groups of five bits, the
/// lowest first, each a letter of the code 48 + group + (32 if more follow); the highest bit of the
/// last group is its sign. From the fourth number on, the difference from the number two before is
/// written. Nothing when a number is not finished, negative or above 2³² − 1, or a letter is not of
/// the code. Source: the COCO API's maskApi (rleToString, rleFrString).
[[nodiscard]] std::optional<PixelRuns> DecodeCocoRuns(std::string_view text);

}  // namespace handcraft::datasets
