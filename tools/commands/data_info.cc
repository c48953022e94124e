// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <map>
#include <memory>
#include <ostream>
#include <set>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/progress_bar.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

struct DataInfoOptions {
  std::string folder;
  bool json = false;
};

struct SplitFigures {
  std::size_t images = 0;
  std::set<std::string> instances;
  std::set<std::string> classes;
  std::size_t pixels = 0;
  std::size_t good = 0;
  std::size_t bad = 0;
};

double Percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::map<std::string, SplitFigures> CountSplits(const datasets::LabelledImageSet& set,
                                                const Progress& progress) {
  std::map<std::string, SplitFigures> splits;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    Report(progress, "reading masks", i, set.items.size());
    const datasets::LabelledImage& item = set.items[i];
    const Image mask = datasets::ReadLabelledPicture(set, i).mask;
    const auto& values = mask.values();
    SplitFigures& split = splits[item.split];
    ++split.images;
    split.instances.insert(item.instance);
    split.classes.insert(item.object_class);
    split.pixels += values.size();
    split.good +=
        static_cast<std::size_t>(std::count(values.begin(), values.end(), datasets::kMaskGood));
    split.bad +=
        static_cast<std::size_t>(std::count(values.begin(), values.end(), datasets::kMaskBad));
  }
  return splits;
}

nlohmann::ordered_json ToJson(const datasets::LabelledImageSet& set,
                              const std::map<std::string, SplitFigures>& splits) {
  nlohmann::ordered_json json{{"folder", set.root.string()},
                              {"num_images", set.items.size()},
                              {"fingerprint", datasets::Fingerprint(set)},
                              {"licences", datasets::LicencesOf(set)},
                              {"splits", nlohmann::ordered_json::array()}};
  for (const auto& [name, split] : splits) {
    json["splits"].push_back({{"name", name},
                              {"num_images", split.images},
                              {"num_instances", split.instances.size()},
                              {"classes", split.classes},
                              {"num_pixels", split.pixels},
                              {"num_good_pixels", split.good},
                              {"num_bad_pixels", split.bad}});
  }
  return json;
}

void PrintText(const Console& console,
               const datasets::LabelledImageSet& set,
               const std::map<std::string, SplitFigures>& splits) {
  TextTable table({"split", "images", "instances", "classes", "good %", "bad %", "don't care %"});
  for (const auto& [name, split] : splits) {
    table.AddRow(
        {name,
         std::to_string(split.images),
         std::to_string(split.instances.size()),
         std::to_string(split.classes.size()),
         fmt::format("{:.2f}", Percent(split.good, split.pixels)),
         fmt::format("{:.2f}", Percent(split.bad, split.pixels)),
         fmt::format("{:.2f}", Percent(split.pixels - split.good - split.bad, split.pixels))});
  }
  console.out << "Labelled image set " << set.root.string() << "\n\n" << table.ToText() << '\n';
  for (const std::string& licence : datasets::LicencesOf(set))
    console.out << "licence      " << licence << '\n';
  console.out << "fingerprint  " << datasets::Fingerprint(set) << '\n';
}

void RunDataInfo(const DataInfoOptions& options, const Console& console) {
  const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(options.folder);
  ProgressBar bar(console);
  const std::map<std::string, SplitFigures> splits = CountSplits(set, bar.Callback());
  bar.Clear();
  if (options.json) {
    console.Print(ToJson(set, splits));
  } else {
    PrintText(console, set, splits);
  }
}

}  // namespace

void AddDataInfo(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataInfoOptions>();
  CLI::App* command = parent.add_subcommand("info", "Describe a labelled image set");
  command->add_option("DIR", options->folder, "Folder with manifest.csv")->required();
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data info datasets/samples/cornell_mini");
  command->callback([options, &console] { RunDataInfo(*options, console); });
}

}  // namespace handcraft::tools
