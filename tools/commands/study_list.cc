// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "experiments/runner/grid.h"
#include "experiments/runner/shipped_studies.h"
#include "experiments/runner/study_file.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using experiments::ShippedStudies;
using experiments::ShippedStudy;

experiments::Study Parse(const ShippedStudy& shipped) {
  return experiments::ParseStudy(
      shipped.text, std::string(shipped.name), experiments::StudySize::kSmall);
}

void PrintStudies(bool json, const Console& console) {
  TextTable table({"study", "cells", "title"});
  auto list = nlohmann::ordered_json::array();
  for (const ShippedStudy& shipped : ShippedStudies()) {
    const experiments::Study study = Parse(shipped);
    const std::size_t num_cells = experiments::MakeCells(study).size();
    table.AddRow({study.name, std::to_string(num_cells), study.title});
    list.push_back({{"name", study.name},
                    {"title", study.title},
                    {"question", study.question},
                    {"num_cells_small", num_cells}});
  }
  // It has a command of its own, and no cells.
  table.AddRow(
      {"feature-analysis", "-", "Which filters and window pixels matter (Figures 3.2, 3.3)"});
  if (json) {
    console.Print(list);
  } else {
    console.out << table.ToText();
  }
}

}  // namespace

void AddStudyList(CLI::App& parent, const Console& console) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command = parent.add_subcommand("list", "The studies that come with the program");
  AddJsonFlag(*command, *json);
  SetExample(*command, "handcraft study list");
  command->callback([json, &console] { PrintStudies(*json, console); });
}

}  // namespace handcraft::tools
