// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>

#include <CLI/App.hpp>

#include "lib/features/similarity.h"
#include "tools/console.h"
#include "trainers/svm/svm.h"

namespace handcraft::tools {

/// The group, in --help, of the options below.
inline constexpr const char* kSvmGroup = "Support vector machine";

/// What the kernels are called on the command line.
[[nodiscard]] const std::map<std::string, features::SimilarityType>& KernelWords();

/// The trainer's options: --kernel, --degree, --gamma, --coef0, --C, --scheme, --standardize,
/// --tolerance.
void AddSvmOptions(CLI::App& command, svm::Options& options);

/// Throws Error(kNoResult) with the remedy when a machine did not converge.
void RequireUsable(const svm::Summary& summary);

}  // namespace handcraft::tools
