// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <CLI/App.hpp>

#include "experiments/object_classes/object_class_training.h"

namespace handcraft::tools {

/// What an object is described by and how the machines are trained: --descriptor, --grid-size,
/// --box, --scaling, --frame, --outlier-step, --moved-copies, --folds, and those of AddSvmOptions.
void AddObjectClassOptions(CLI::App& command, experiments::ObjectClassOptions& options);

}  // namespace handcraft::tools
