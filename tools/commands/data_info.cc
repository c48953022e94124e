// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <map>
#include <memory>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/parallel_reporting.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/progress_bar.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

struct DataInfoOptions {
  std::string folder;
  int num_threads = 1;
  bool json = false;
};

// What is counted, over a split or over a class of it.
struct Figures {
  std::size_t images = 0;
  std::set<std::string> instances;
  std::size_t pixels = 0;
  std::size_t good = 0;
  std::size_t bad = 0;

  Figures& operator+=(const Figures& other) {
    images += other.images;
    instances.insert(other.instances.begin(), other.instances.end());
    pixels += other.pixels;
    good += other.good;
    bad += other.bad;
    return *this;
  }
};

struct SplitFigures {
  Figures all;
  std::map<std::string, Figures> by_class;
};

struct SetFigures {
  std::map<std::string, SplitFigures> splits;
  std::map<std::string, std::size_t> sizes;  ///< pictures of each size
};

double Percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

SetFigures CountPixels(const datasets::LabelledImageSet& set,
                       int num_threads,
                       const Progress& progress) {
  std::vector<Figures> of_item(set.items.size());
  std::vector<std::string> sizes(set.items.size());
  datasets::ParallelForReporting(
      set.items.size(), num_threads, progress, "reading masks", [&](std::size_t i) {
        const Image mask = datasets::ReadLabelledPicture(set, i).mask;
        const auto& values = mask.values();
        const auto count = [&](std::uint8_t value) {
          return static_cast<std::size_t>(std::count(values.begin(), values.end(), value));
        };
        of_item[i] = {.images = 1,
                      .instances = {set.items[i].instance},
                      .pixels = values.size(),
                      .good = count(datasets::kMaskGood),
                      .bad = count(datasets::kMaskBad)};
        sizes[i] = fmt::format("{}x{}", mask.width(), mask.height());
      });
  SetFigures figures;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    SplitFigures& split = figures.splits[set.items[i].split];
    split.all += of_item[i];
    split.by_class[set.items[i].object_class] += of_item[i];
    ++figures.sizes[sizes[i]];
  }
  return figures;
}

nlohmann::ordered_json ToJson(const Figures& figures) {
  return {{"num_images", figures.images},
          {"num_instances", figures.instances.size()},
          {"num_pixels", figures.pixels},
          {"num_good_pixels", figures.good},
          {"num_bad_pixels", figures.bad}};
}

nlohmann::ordered_json ToJson(const datasets::LabelledImageSet& set, const SetFigures& figures) {
  nlohmann::ordered_json json{{"folder", set.root.string()},
                              {"num_images", set.items.size()},
                              {"fingerprint", datasets::Fingerprint(set)},
                              {"licences", datasets::LicencesOf(set)},
                              {"sizes", figures.sizes},
                              {"splits", nlohmann::ordered_json::array()}};
  for (const auto& [name, split] : figures.splits) {
    nlohmann::ordered_json of_split{{"name", name}};
    of_split.update(ToJson(split.all));
    for (const auto& [object_class, of_class] : split.by_class)
      of_split["classes"][object_class] = ToJson(of_class);
    json["splits"].push_back(of_split);
  }
  return json;
}

std::vector<std::string> TableRow(const std::string& split,
                                  const std::string& object_class,
                                  const Figures& figures) {
  const auto percent = [&](std::size_t part) {
    return fmt::format("{:.2f}", Percent(part, figures.pixels));
  };
  return {split,
          object_class,
          std::to_string(figures.images),
          std::to_string(figures.instances.size()),
          percent(figures.good),
          percent(figures.bad),
          percent(figures.pixels - figures.good - figures.bad)};
}

void PrintText(const Console& console,
               const datasets::LabelledImageSet& set,
               const SetFigures& figures) {
  TextTable table({"split", "class", "images", "instances", "good %", "bad %", "don't care %"});
  for (const auto& [name, split] : figures.splits) {
    for (const auto& [object_class, of_class] : split.by_class)
      table.AddRow(TableRow(name, object_class, of_class));
    if (split.by_class.size() > 1) table.AddRow(TableRow(name, "(all)", split.all));
  }
  console.out << "Labelled image set " << set.root.string() << "\n\n" << table.ToText() << '\n';
  console.out << "sizes [px]  ";
  for (const auto& [size, count] : figures.sizes)
    console.out << ' ' << size << " (" << count << ')';
  console.out << '\n';
  for (const std::string& licence : datasets::LicencesOf(set))
    console.out << "licence      " << licence << '\n';
  console.out << "fingerprint  " << datasets::Fingerprint(set) << '\n';
}

void RunDataInfo(const DataInfoOptions& options, const Console& console) {
  const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(options.folder);
  ProgressBar bar(console);
  const SetFigures figures = CountPixels(set, options.num_threads, bar.Callback());
  bar.Clear();
  if (options.json) {
    console.Print(ToJson(set, figures));
  } else {
    PrintText(console, set, figures);
  }
}

}  // namespace

void AddDataInfo(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataInfoOptions>();
  CLI::App* command = parent.add_subcommand("info", "Describe a labelled image set");
  command->add_option("DIR", options->folder, "Folder with manifest.csv")->required();
  AddThreadsOption(*command, options->num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data info datasets/samples/cornell_mini");
  command->callback([options, &console] { RunDataInfo(*options, console); });
}

}  // namespace handcraft::tools
