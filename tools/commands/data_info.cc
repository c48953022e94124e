// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cctype>
#include <cstddef>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/hold_set.h"
#include "datasets/set_figures.h"
#include "datasets/stored_set.h"
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

std::string PercentText(std::size_t part, std::size_t whole) {
  if (whole == 0) return "-";
  return fmt::format("{:.2f}", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string_view KindOf(const datasets::LabelledImageSet&) { return "labelled image set"; }
std::string_view KindOf(const datasets::ViewSet&) { return "view set"; }

nlohmann::ordered_json ToJson(const datasets::LabelFigures& figures) {
  return {{"num_images", figures.images},
          {"num_instances", figures.instances.size()},
          {"num_pixels", figures.pixels},
          {"num_good_pixels", figures.good},
          {"num_bad_pixels", figures.bad}};
}

nlohmann::ordered_json ToJson(const datasets::ViewFigures& figures) {
  return {{"num_images", figures.views},
          {"num_instances", figures.instances.size()},
          {"num_angles", figures.angles_deg.size()},
          {"num_images_without_angle", figures.views_without_angle},
          {"num_pixels", figures.pixels},
          {"num_object_pixels", figures.object_pixels},
          {"num_clouds", figures.clouds},
          {"num_object_pixels_with_cloud", figures.cloud_object_pixels},
          {"num_measured_object_pixels", figures.measured}};
}

nlohmann::ordered_json ToJson(const datasets::PoseFigures& figures) {
  return {{"num_poses", figures.poses},
          {"num_instances", figures.instances.size()},
          {"num_views", figures.views},
          {"least_per_view", figures.least_per_view},
          {"most_per_view", figures.most_per_view}};
}

std::vector<std::string> Head(const datasets::LabelledImageSet&) {
  return {"split", "class", "images", "instances", "good %", "bad %", "don't care %"};
}

std::vector<std::string> Head(const datasets::ViewSet&) {
  return {"split", "class", "views", "instances", "angles", "object %", "clouds", "measured %"};
}

std::vector<std::string> Cells(const datasets::LabelFigures& figures) {
  return {std::to_string(figures.images),
          std::to_string(figures.instances.size()),
          PercentText(figures.good, figures.pixels),
          PercentText(figures.bad, figures.pixels),
          PercentText(figures.pixels - figures.good - figures.bad, figures.pixels)};
}

std::vector<std::string> Cells(const datasets::ViewFigures& figures) {
  return {std::to_string(figures.views),
          std::to_string(figures.instances.size()),
          std::to_string(figures.angles_deg.size()),
          PercentText(figures.object_pixels, figures.pixels),
          std::to_string(figures.clouds),
          PercentText(figures.measured, figures.cloud_object_pixels)};
}

template <class Figures>
void AddRow(const std::string& split,
            const std::string& object_class,
            const Figures& figures,
            TextTable& table) {
  std::vector<std::string> row = Cells(figures);
  row.insert(row.begin(), {split, object_class});
  table.AddRow(row);
}

// The poses of a list beside the views, by class; what its rows are called.
struct PoseList {
  std::string name;
  std::string fingerprint;
  std::map<std::string, datasets::PoseFigures> by_class;
};

std::vector<PoseList> CountPoseLists(const datasets::StoredSet& stored) {
  std::vector<PoseList> lists;
  const auto add = [&](const std::string& name, const auto& set) {
    lists.push_back({name, datasets::Fingerprint(set), datasets::CountPoses(set)});
  };
  if (stored.has_demonstrations) {
    add("demonstrations", datasets::ReadDemonstrationSet(stored.root()));
  }
  if (stored.has_holds) add("holds", datasets::ReadHoldSet(stored.root()));
  return lists;
}

datasets::PoseFigures All(const PoseList& list) {
  datasets::PoseFigures all;
  for (const auto& [object_class, figures] : list.by_class) all += figures;
  return all;
}

nlohmann::ordered_json ToJson(const PoseList& list) {
  nlohmann::ordered_json json{{"frame", datasets::kBaseFrame},
                              {"end_effector", datasets::kGraspCentre},
                              {"fingerprint", list.fingerprint}};
  json.update(ToJson(All(list)));
  for (const auto& [object_class, figures] : list.by_class) {
    json["classes"][object_class] = ToJson(figures);
  }
  return json;
}

template <class Set, class Figures>
void PrintJson(const Console& console,
               const Set& set,
               const datasets::SetFigures<Figures>& figures,
               const std::vector<PoseList>& pose_lists) {
  nlohmann::ordered_json json{{"folder", set.root.string()},
                              {"kind", KindOf(set)},
                              {"num_images", set.items.size()},
                              {"fingerprint", datasets::Fingerprint(set)},
                              {"licences", figures.licences},
                              {"sizes", figures.sizes},
                              {"splits", nlohmann::ordered_json::array()}};
  for (const auto& [name, split] : figures.splits) {
    nlohmann::ordered_json of_split{{"name", name}};
    of_split.update(ToJson(split.all));
    for (const auto& [object_class, of_class] : split.by_class)
      of_split["classes"][object_class] = ToJson(of_class);
    json["splits"].push_back(of_split);
  }
  for (const PoseList& list : pose_lists) json[list.name] = ToJson(list);
  console.Print(json);
}

void PrintPoses(const Console& console, const PoseList& list) {
  TextTable table({"class", list.name, "instances", "views", "least a view", "most a view"});
  const auto add = [&](const std::string& object_class, const datasets::PoseFigures& figures) {
    table.AddRow({object_class,
                  std::to_string(figures.poses),
                  std::to_string(figures.instances.size()),
                  std::to_string(figures.views),
                  std::to_string(figures.least_per_view),
                  std::to_string(figures.most_per_view)});
  };
  for (const auto& [object_class, figures] : list.by_class) add(object_class, figures);
  if (list.by_class.size() > 1) add("(all)", All(list));
  console.out << '\n' << table.ToText() << '\n';
  console.out << "frame        " << datasets::kBaseFrame << ", of the " << datasets::kGraspCentre
              << '\n';
  console.out << "fingerprint  " << list.fingerprint << '\n';
}

template <class Set, class Figures>
void PrintText(const Console& console,
               const Set& set,
               const datasets::SetFigures<Figures>& figures,
               const std::vector<PoseList>& pose_lists) {
  TextTable table(Head(set));
  for (const auto& [name, split] : figures.splits) {
    for (const auto& [object_class, of_class] : split.by_class)
      AddRow(name, object_class, of_class, table);
    if (split.by_class.size() > 1) AddRow(name, "(all)", split.all, table);
  }
  std::string kind(KindOf(set));
  kind.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(kind.front())));
  console.out << kind << ' ' << set.root.string() << "\n\n" << table.ToText() << '\n';
  console.out << "sizes [px]  ";
  for (const auto& [size, count] : figures.sizes)
    console.out << ' ' << size << " (" << count << ')';
  console.out << '\n';
  for (const std::string& licence : figures.licences)
    console.out << "licence      " << licence << '\n';
  console.out << "fingerprint  " << datasets::Fingerprint(set) << '\n';
  for (const PoseList& list : pose_lists) PrintPoses(console, list);
}

void RunDataInfo(const DataInfoOptions& options, const Console& console) {
  const datasets::StoredSet stored = datasets::OpenSet(options.folder);
  const std::vector<PoseList> pose_lists = CountPoseLists(stored);
  std::visit(
      [&](const auto& set) {
        ProgressBar bar(console);
        const auto figures = datasets::CountFigures(set, options.num_threads, bar.Callback());
        bar.Clear();
        if (options.json) {
          PrintJson(console, set, figures, pose_lists);
        } else {
          PrintText(console, set, figures, pose_lists);
        }
      },
      stored.pictures);
}

}  // namespace

void AddDataInfo(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataInfoOptions>();
  CLI::App* command =
      parent.add_subcommand("info", "Describe a data set: counts, shares, sizes, licences");
  command
      ->add_option("DIR",
                   options->folder,
                   "Folder with manifest.csv, or with views.csv and what stands beside it")
      ->required();
  AddThreadsOption(*command, options->num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data info datasets/samples/cornell_mini");
  command->callback([options, &console] { RunDataInfo(*options, console); });
}

}  // namespace handcraft::tools
