// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <CLI/App.hpp>

#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::tools {

/// The group, in --help, of the options below.
inline constexpr const char* kLogisticGroup = "Logistic regression";

/// The trainer's options, shared by `train grasp-points` and `train logistic`.
void AddLogisticOptions(CLI::App& command, logistic::Options& options);

}  // namespace handcraft::tools
