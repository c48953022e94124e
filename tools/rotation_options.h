// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <CLI/App.hpp>

#include "trainers/grasp_library/grasp_library.h"

namespace handcraft::tools {

/// How views are compared, as options say it.
struct RotationArguments {
  std::string moments = "all";
  int num_candidates = grasp_library::Options{}.num_candidates;
  double angle_weight = grasp_library::Options{}.angle_weight;
};

/// --moments, --candidates, --angle-weight.
void AddRotationOptions(CLI::App& command, RotationArguments& arguments);

/// What the command line said.
[[nodiscard]] features::RotationRule RuleOf(const RotationArguments& arguments);

}  // namespace handcraft::tools
