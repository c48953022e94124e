// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/commands.h"

namespace handcraft::tools {

void AddPlan(CLI::App& parent, const Console& console) {
  CLI::App* plan = parent.add_subcommand("plan", "Plan what the robot does with what it sees");
  plan->require_subcommand(1);
  AddPlanGrasp(*plan, console);
}

}  // namespace handcraft::tools
