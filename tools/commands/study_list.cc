// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "experiments/runner/grid.h"
#include "experiments/runner/shipped_studies.h"
#include "experiments/runner/study_file.h"
#include "experiments/view_studies/view_study.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using experiments::ShippedStudies;
using experiments::ShippedStudy;

// What the list tells of a study.
struct Entry {
  std::string name;
  std::string title;
  std::string question;
  std::size_t num_cells = 0;
};

Entry Describe(const ShippedStudy& shipped) {
  const std::string name(shipped.name);
  constexpr auto kSize = experiments::StudySize::kSmall;
  if (experiments::IsViewStudy(shipped.text, name)) {
    const experiments::ViewStudy study = experiments::ParseViewStudy(shipped.text, name, kSize);
    return {study.name, study.title, study.question, experiments::MakeViewCells(study).size()};
  }
  const experiments::Study study = experiments::ParseStudy(shipped.text, name, kSize);
  return {study.name, study.title, study.question, experiments::MakeCells(study).size()};
}

void PrintStudies(bool json, const Console& console) {
  TextTable table({"study", "cells", "title"});
  auto list = nlohmann::ordered_json::array();
  for (const ShippedStudy& shipped : ShippedStudies()) {
    const Entry study = Describe(shipped);
    table.AddRow({study.name, std::to_string(study.num_cells), study.title});
    list.push_back({{"name", study.name},
                    {"title", study.title},
                    {"question", study.question},
                    {"num_cells_small", study.num_cells}});
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
