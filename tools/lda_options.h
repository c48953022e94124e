// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "tools/console.h"
#include "trainers/lda/lda.h"

namespace handcraft::tools {

/// The group, in --help, of the options below.
inline constexpr const char* kLdaGroup = "Linear discriminant analysis";

/// The trainer's options, shared by `train grasp-points` and `train lda`.
void AddLdaOptions(CLI::App& command, lda::Options& options);

/// Says what a trainer's result is worth: warns on `console.err` of constant features (named by
/// `feature_names`), and throws Error(kNoResult) with the remedy when there are no weights.
void RequireUsable(const lda::Summary& summary,
                   const std::vector<std::string>& feature_names,
                   const Console& console);

}  // namespace handcraft::tools
