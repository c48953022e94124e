// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/view_set.h"
#include "datasets/labelled_image_faults.h"
#include "lib/core/error.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/progress_bar.h"

namespace handcraft::tools {
namespace {

struct DataCheckOptions {
  std::string folder;
  int num_threads = 1;
  bool json = false;
};

// What was looked at, and what was found.
struct Checked {
  std::size_t num_images = 0;
  std::vector<datasets::Fault> faults;
};

Checked Check(const DataCheckOptions& options, const Progress& progress) {
  const std::filesystem::path root(options.folder);
  if (datasets::IsViewSet(root) && !std::filesystem::exists(root / "manifest.csv")) {
    const datasets::ViewSet set = datasets::ReadViewSet(root);
    return {set.items.size(), datasets::FindFaults(set)};
  }
  const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(root);
  return {set.items.size(), datasets::FindFaults(set, options.num_threads, progress)};
}

void PrintJson(const Console& console, const std::string& folder, const Checked& checked) {
  nlohmann::ordered_json json{{"folder", folder},
                              {"num_images", checked.num_images},
                              {"faults", nlohmann::ordered_json::array()}};
  for (const datasets::Fault& fault : checked.faults) {
    json["faults"].push_back({{"path", fault.path}, {"reason", fault.reason}});
  }
  console.Print(json);
}

void RunDataCheck(const DataCheckOptions& options, const Console& console) {
  ProgressBar bar(console);
  const Checked checked = Check(options, bar.Callback());
  bar.Clear();
  if (options.json) {
    PrintJson(console, options.folder, checked);
  } else {
    for (const datasets::Fault& fault : checked.faults) {
      console.out << fault.path << ": " << fault.reason << '\n';
    }
  }
  if (!checked.faults.empty()) {
    throw Error({.path = options.folder,
                 .reason = fmt::format("{} fault{} in {} images",
                                       checked.faults.size(),
                                       checked.faults.size() == 1 ? "" : "s",
                                       checked.num_images)});
  }
  if (!options.json) console.out << "OK: " << checked.num_images << " images and masks, no fault\n";
}

}  // namespace

void AddDataCheck(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataCheckOptions>();
  CLI::App* command = parent.add_subcommand(
      "check", "Open every file of a set of images or views and name each fault");
  command->add_option("DIR", options->folder, "Folder with manifest.csv or views.csv")->required();
  AddThreadsOption(*command, options->num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data check datasets/samples/cornell_mini");
  command->callback([options, &console] { RunDataCheck(*options, console); });
}

}  // namespace handcraft::tools
