// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/commands.h"

namespace handcraft::tools {

void AddDataSynth(CLI::App& parent, const Console& console) {
  CLI::App* synth = parent.add_subcommand("synth", "Make a data set of rendered pictures");
  synth->require_subcommand(1);
  AddDataSynthGraspPoints(*synth, console);
  AddDataSynthTurntable(*synth, console);
  AddDataSynthMoved(*synth, console);
  AddDataSynthDemonstrations(*synth, console);
  AddDataSynthRegrasp(*synth, console);
}

}  // namespace handcraft::tools
