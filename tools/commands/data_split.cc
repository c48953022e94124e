// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <map>
#include <memory>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/split_assignment.h"
#include "datasets/stored_set.h"
#include "lib/core/error.h"
#include "lib/core/utf8.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

struct DataSplitOptions {
  std::string folder;
  std::vector<std::string> shares;
  std::string by = "instance";
  datasets::SplitOptions split;
  bool dry_run = false;
  bool json = false;
};

// "train=0.7"
datasets::SplitShare ReadShare(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  datasets::SplitShare share;
  const std::string_view expected = "; NAME=SHARE is due, as in train=0.7";
  if (equals == std::string::npos || equals == 0) {
    throw Error(
        {.kind = Error::Kind::kUsage, .reason = fmt::format("--share {}{}", text, expected)});
  }
  share.name = text.substr(0, equals);
  if (!ReadNumber(text.substr(equals + 1), share.share).empty()) {
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = fmt::format(
             "--share {}: '{}' is not a number{}", text, text.substr(equals + 1), expected)});
  }
  return share;
}

struct Counts {
  std::size_t images = 0;
  std::set<std::string> instances;
  std::set<std::string> classes;
};

std::map<std::string, Counts> CountSplits(const datasets::StoredSet& stored) {
  std::map<std::string, Counts> splits;
  std::visit(
      [&](const auto& set) {
        for (const auto& item : set.items) {
          Counts& counts = splits[item.split];
          ++counts.images;
          counts.instances.insert(item.instance);
          counts.classes.insert(item.object_class);
        }
      },
      stored.pictures);
  return splits;
}

void PrintText(const Console& console,
               const DataSplitOptions& options,
               const datasets::StoredSet& set) {
  const std::map<std::string, Counts> splits = CountSplits(set);
  std::size_t num_images = 0;
  for (const auto& [name, counts] : splits) num_images += counts.images;
  TextTable table({"split", "images", "share %", "instances", "classes"});
  for (const auto& [name, counts] : splits) {
    table.AddRow(
        {name,
         std::to_string(counts.images),
         fmt::format("{:.1f}",
                     100.0 * static_cast<double>(counts.images) / static_cast<double>(num_images)),
         std::to_string(counts.instances.size()),
         std::to_string(counts.classes.size())});
  }
  console.out << table.ToText() << '\n'
              << (options.dry_run ? "Not written (--dry-run): " : "Wrote ")
              << OnOneLine(set.list().string()) << '\n';
}

void PrintJson(const Console& console,
               const DataSplitOptions& options,
               const datasets::StoredSet& set) {
  nlohmann::ordered_json json{{"folder", set.root().string()},
                              {"written", !options.dry_run},
                              {"splits", nlohmann::ordered_json::array()}};
  for (const auto& [name, counts] : CountSplits(set)) {
    json["splits"].push_back({{"name", name},
                              {"num_images", counts.images},
                              {"num_instances", counts.instances.size()},
                              {"num_classes", counts.classes.size()}});
  }
  console.Print(json);
}

void RunDataSplit(const DataSplitOptions& options, const Console& console) {
  datasets::SplitOptions split = options.split;
  if (!options.shares.empty()) split.shares.clear();
  for (const std::string& text : options.shares) split.shares.push_back(ReadShare(text));
  if (options.by == "class") split.group = datasets::SplitGroup::kClass;
  datasets::StoredSet set = datasets::OpenSet(options.folder);
  std::visit([&](auto& pictures) { datasets::AssignSplits(pictures, split); }, set.pictures);
  if (!options.dry_run) datasets::RewriteSplits(set);
  options.json ? PrintJson(console, options, set) : PrintText(console, options, set);
}

}  // namespace

void AddDataSplit(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataSplitOptions>();
  CLI::App* command = parent.add_subcommand(
      "split", "Divide a set anew; rewrites the column of its manifest.csv or views.csv");
  command->add_option("DIR", options->folder, "Folder with manifest.csv or views.csv")->required();
  command
      ->add_option("--share",
                   options->shares,
                   "A split and its share of the pictures; once for each split, together 1")
      ->type_name("NAME=SHARE")
      ->default_str("train=0.7 --share test=0.3")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--by",
                   options->by,
                   "What stays on one side: instance (an object), or class (all objects of a kind)")
      ->check(CLI::IsMember({"instance", "class"}))
      ->capture_default_str();
  AddSeedOption(*command, options->split.seed);
  command->add_flag("--dry-run", options->dry_run, "Show the counts, write nothing");
  AddJsonFlag(*command, options->json);
  SetExample(*command,
             "handcraft data split datasets/samples/cornell_mini --share train=0.5 "
             "--share test=0.5 --dry-run");
  command->callback([options, &console] { RunDataSplit(*options, console); });
}

}  // namespace handcraft::tools
