// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/labelled_image_set.h"
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

void PrintJson(const Console& console,
               const datasets::LabelledImageSet& set,
               const std::vector<datasets::Fault>& faults) {
  nlohmann::ordered_json json{{"folder", set.root.string()},
                              {"num_images", set.items.size()},
                              {"faults", nlohmann::ordered_json::array()}};
  for (const datasets::Fault& fault : faults) {
    json["faults"].push_back({{"path", fault.path}, {"reason", fault.reason}});
  }
  console.Print(json);
}

void RunDataCheck(const DataCheckOptions& options, const Console& console) {
  const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(options.folder);
  ProgressBar bar(console);
  const std::vector<datasets::Fault> faults =
      datasets::FindFaults(set, options.num_threads, bar.Callback());
  bar.Clear();
  if (options.json) {
    PrintJson(console, set, faults);
  } else {
    for (const datasets::Fault& fault : faults) {
      console.out << fault.path << ": " << fault.reason << '\n';
    }
  }
  if (!faults.empty()) {
    throw Error({.path = options.folder,
                 .reason = fmt::format("{} fault{} in {} images",
                                       faults.size(),
                                       faults.size() == 1 ? "" : "s",
                                       set.items.size())});
  }
  if (!options.json) console.out << "OK: " << set.items.size() << " images and masks, no fault\n";
}

}  // namespace

void AddDataCheck(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataCheckOptions>();
  CLI::App* command =
      parent.add_subcommand("check", "Open every file of a labelled image set and name each fault");
  command->add_option("DIR", options->folder, "Folder with manifest.csv")->required();
  AddThreadsOption(*command, options->num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data check datasets/samples/cornell_mini");
  command->callback([options, &console] { RunDataCheck(*options, console); });
}

}  // namespace handcraft::tools
