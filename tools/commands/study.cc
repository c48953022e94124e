// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/commands.h"

namespace handcraft::tools {

void AddStudy(CLI::App& parent, const Console& console) {
  CLI::App* study = parent.add_subcommand("study", "Ask your data a question and get a report");
  study->require_subcommand(1);
  AddStudyRun(*study, console);
  AddStudyCompare(*study, console);
  AddStudyRotation(*study, console);
  AddStudyList(*study, console);
}

}  // namespace handcraft::tools
