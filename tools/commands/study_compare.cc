// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <memory>
#include <ostream>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "experiments/runner/run_comparison.h"
#include "lib/core/error.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

// A table of more rows tells no more.
constexpr std::size_t kMaxShown = 30;

struct StudyCompareOptions {
  std::string first;
  std::string second;
  bool json = false;
};

void PrintJson(const experiments::RunComparison& comparison, const Console& console) {
  auto differences = nlohmann::ordered_json::array();
  for (const experiments::RunDifference& difference : comparison.differences) {
    differences.push_back({{"cell", difference.cell},
                           {"class", difference.object_class},
                           {"column", difference.column},
                           {"first", difference.first},
                           {"second", difference.second}});
  }
  console.Print({{"same", comparison.IsSame()},
                 {"num_rows", comparison.num_rows},
                 {"inputs", comparison.inputs},
                 {"differences", differences}});
}

void PrintText(const experiments::RunComparison& comparison, const Console& console) {
  if (!comparison.inputs.empty()) {
    console.out << fmt::format("Inputs that differ: {}\n", fmt::join(comparison.inputs, ", "));
  }
  if (comparison.differences.empty()) {
    console.out << fmt::format("The results are the same: {} rows.\n", comparison.num_rows);
    return;
  }
  TextTable table({"cell", "class", "column", "first", "second"});
  for (std::size_t i = 0; i < std::min(kMaxShown, comparison.differences.size()); ++i) {
    const experiments::RunDifference& difference = comparison.differences[i];
    table.AddRow({difference.cell,
                  difference.object_class,
                  difference.column.empty() ? "the row" : difference.column,
                  difference.first,
                  difference.second});
  }
  console.out << table.ToText()
              << fmt::format("{} differences in {} common rows.\n",
                             comparison.differences.size(),
                             comparison.num_rows);
}

void RunStudyCompare(const StudyCompareOptions& options, const Console& console) {
  const experiments::RunComparison comparison =
      experiments::CompareRuns(options.first, options.second);
  options.json ? PrintJson(comparison, console) : PrintText(comparison, console);
  if (comparison.IsSame()) return;
  throw Error({.kind = Error::Kind::kNoResult, .reason = "the two runs differ"});
}

}  // namespace

void AddStudyCompare(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<StudyCompareOptions>();
  CLI::App* command = parent.add_subcommand(
      "compare", "Tell whether two runs of studies differ, and where; exit code 4 if they do");
  command->add_option("FIRST", options->first, "Folder of results")->required();
  command->add_option("SECOND", options->second, "Folder of results")->required();
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft study compare out/study out/study");
  command->callback([options, &console] { RunStudyCompare(*options, console); });
}

}  // namespace handcraft::tools
