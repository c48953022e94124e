// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/stored_set.h"
#include "lib/core/error.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/findings.h"
#include "tools/progress_bar.h"

namespace handcraft::tools {
namespace {

struct DataCheckOptions {
  std::string folder;
  int num_threads = 1;
  bool json = false;
};

void PrintJson(const Console& console,
               const std::string& folder,
               const datasets::CheckedSet& checked) {
  nlohmann::ordered_json json{{"folder", folder}, {"num_images", checked.num_images}};
  if (checked.num_demonstrations) json["num_demonstrations"] = *checked.num_demonstrations;
  if (checked.num_holds) json["num_holds"] = *checked.num_holds;
  json["faults"] = ToJson(checked.faults);
  json["notes"] = ToJson(checked.notes);
  console.Print(json);
}

void PrintFindings(const Console& console,
                   const std::string& kind,
                   const std::vector<datasets::Fault>& findings) {
  for (const datasets::Fault& finding : findings) console.out << ToText(finding, kind) << '\n';
}

// ", 480 demonstrations, 240 holds"
std::string RowsText(const datasets::CheckedSet& checked) {
  std::string text;
  if (checked.num_demonstrations) {
    text += fmt::format(", {} demonstrations", *checked.num_demonstrations);
  }
  if (checked.num_holds) text += fmt::format(", {} holds", *checked.num_holds);
  return text;
}

// ", 2 notes"
std::string NotesText(const datasets::CheckedSet& checked) {
  const std::size_t count = checked.notes.size();
  return count == 0 ? "" : fmt::format(", {} note{}", count, count == 1 ? "" : "s");
}

void RunDataCheck(const DataCheckOptions& options, const Console& console) {
  const datasets::StoredSet set = datasets::OpenSet(options.folder);
  ProgressBar bar(console);
  const datasets::CheckedSet checked = datasets::CheckSet(set, options.num_threads, bar.Callback());
  bar.Clear();
  if (options.json) {
    PrintJson(console, options.folder, checked);
  } else {
    PrintFindings(console, "", checked.faults);
    PrintFindings(console, "note: ", checked.notes);
  }
  if (!checked.faults.empty()) {
    throw Error({.path = options.folder,
                 .reason = fmt::format("{} fault{} in {} images{}",
                                       checked.faults.size(),
                                       checked.faults.size() == 1 ? "" : "s",
                                       checked.num_images,
                                       RowsText(checked))});
  }
  if (!options.json) {
    console.out << "OK: " << checked.num_images << " images and masks" << RowsText(checked)
                << ", no fault" << NotesText(checked) << '\n';
  }
}

}  // namespace

void AddDataCheck(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataCheckOptions>();
  CLI::App* command = parent.add_subcommand(
      "check", "Open every file of a data set and name each fault, by file and line");
  command
      ->add_option("DIR",
                   options->folder,
                   "Folder with manifest.csv, or with views.csv and what stands beside it")
      ->required();
  AddThreadsOption(*command, options->num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data check datasets/samples/cornell_mini");
  command->callback([options, &console] { RunDataCheck(*options, console); });
}

}  // namespace handcraft::tools
