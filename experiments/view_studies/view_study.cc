// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_study.h"

#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lib/core/error.h"
#include "lib/structured_text/toml_file.h"
#include "lib/structured_text/toml_table.h"

namespace handcraft::experiments {
namespace {

using synthetic::CloudSensor;
using synthetic::ViewSetKind;

void CheckViewSetting(const Setting& setting) {
  ViewSettings scratch;
  ApplyViewSetting(setting, scratch);
}

SettingRules Rules() { return {.keys = ViewSettingKeys(), .check = &CheckViewSetting}; }

// Texts in a list, or one alone.
std::vector<std::string> ParseTexts(const TomlTable& table, std::string_view key) {
  const toml::node& node = table.Node(key);
  const toml::array* const list = node.as_array();
  if (list == nullptr) return {table.Text(key)};
  std::vector<std::string> texts;
  for (const toml::node& entry : *list) {
    const auto text = entry.value_exact<std::string>();
    if (!text) table.Fail(entry, fmt::format("{} holds something else than texts", key));
    texts.push_back(*text);
  }
  if (texts.empty()) table.Fail(node, fmt::format("{} is an empty list", key));
  return texts;
}

std::vector<synthetic::Family> ParseFamilies(const TomlTable& table) {
  std::vector<synthetic::Family> families;
  for (const std::string& name : ParseTexts(table, "made")) {
    if (name != "taught" && name != "untaught" && name != "regrasp") {
      table.Fail(table.Node("made"),
                 fmt::format("made is \"{}\"", name),
                 "give taught, untaught or regrasp, whose objects stand alone");
    }
    families.push_back(synthetic::FamilyNamed(name));
  }
  return families;
}

ViewSetKind ParseKind(const TomlTable& table) {
  const std::string name = table.Text("kind");
  for (const ViewSetKind kind : {ViewSetKind::kTurntable, ViewSetKind::kMoved}) {
    if (name == synthetic::NameOf(kind)) return kind;
  }
  table.Fail(table.Node("kind"), "kind is \"" + name + "\"", "give turntable or moved");
}

CloudSensor ParseSensor(const TomlTable& table) {
  const std::string name = table.Text("sensor");
  for (const CloudSensor sensor : {CloudSensor::kStereo,
                                   CloudSensor::kStereoBlockMatching,
                                   CloudSensor::kStereoActive,
                                   CloudSensor::kDepthCamera,
                                   CloudSensor::kPerfect}) {
    if (name == synthetic::NameOf(sensor)) return sensor;
  }
  table.Fail(table.Node("sensor"),
             "sensor is \"" + name + "\"",
             "give stereo, stereo-bm, stereo-active, depth-camera or perfect");
}

ViewSource ParseSource(const TomlTable& table, StudySize size) {
  table.AllowOnly(std::array<std::string_view, 9>{
      "folder", "split", "made", "kind", "sensor", "views", "poses", "sets", "seed"});
  if (table.Has("folder") == table.Has("made")) {
    table.Fail(table.table(), "data has either a folder or made views");
  }
  if (table.Has("folder")) {
    table.AllowOnly(std::array<std::string_view, 2>{"folder", "split"});
    return {.folder = table.Text("folder"),
            .split = table.Has("split") ? table.Text("split") : std::string()};
  }
  if (table.Has("split")) table.Fail(table.Node("split"), "split is of the views of a folder");
  ViewSource source{.families = ParseFamilies(table)};
  if (table.Has("kind")) source.kind = ParseKind(table);
  if (table.Has("sensor")) source.sensor = ParseSensor(table);
  source.num_views = static_cast<int>(ParseWhole(table, "views", size, 2));
  if (table.Has("poses")) {
    source.num_poses = static_cast<int>(ParseWhole(table, "poses", size, 1));
    if (source.families.size() != 1 || table.Has("kind") || table.Has("sets")) {
      table.Fail(table.Node("poses"),
                 "poses are shown on the turntable of one family",
                 "leave kind and sets out, and name one family");
    }
  }
  if (table.Has("sets")) source.num_sets = static_cast<int>(ParseWhole(table, "sets", size, 1));
  if (table.Has("seed")) {
    source.seed = static_cast<std::uint64_t>(ParseWhole(table, "seed", size, 0));
  }
  return source;
}

void ParseData(const TomlTable& data, StudySize size, ViewStudy& study) {
  data.AllowOnly(std::array<std::string_view, 3>{"train", "test", "demonstrations"});
  study.train = ParseSource(data.Table("train"), size);
  const bool is_plan = IsOfPlans(study.task);
  const bool may_have_test = study.task != ViewTask::kNearestDemonstration;
  if (data.Has("test") && !may_have_test) {
    data.Fail(data.Node("test"),
              fmt::format("{} asks about [data.train]", NameOf(study.task)),
              "leave it out");
  }
  if (data.Has("test")) study.test = ParseSource(data.Table("test"), size);
  if (!study.train.split.empty() && !may_have_test) {
    data.Fail(data.Node("train"),
              fmt::format("{} asks about all of a folder", NameOf(study.task)),
              "leave split out");
  }
  if (data.Has("demonstrations") != is_plan) {
    data.Fail(
        data.table(),
        "[data.demonstrations] goes with the tasks grasp-plan and grasp-success, which need it");
  }
  if (!data.Has("demonstrations")) return;
  const TomlTable table = data.Table("demonstrations");
  study.demonstrations = ParseSource(table, size);
  if (table.Has("split")) table.Fail(table.Node("split"), "demonstrations are taken whole");
  if (study.demonstrations->folder.empty() && study.demonstrations->num_poses == 0) {
    table.Fail(table.table(), "made demonstrations need poses", "give poses, how many a view");
  }
}

ViewTask ParseTask(const TomlTable& top) {
  const std::string name = top.Text("task");
  std::string names;
  for (const ViewTask task : {ViewTask::kObjectClass,
                              ViewTask::kObjectRotation,
                              ViewTask::kNearestDemonstration,
                              ViewTask::kGraspPlan,
                              ViewTask::kGraspSuccess}) {
    if (name == NameOf(task)) return task;
    names.append(names.empty() ? "" : ", ").append(NameOf(task));
  }
  top.Fail(top.Node("task"), "task is \"" + name + "\"", "give one of: " + names);
}

// Lists of texts by name.
std::map<std::string, std::vector<std::string>> ParseLists(const TomlTable& top,
                                                           std::string_view key) {
  std::map<std::string, std::vector<std::string>> lists;
  if (!top.Has(key)) return lists;
  const TomlTable table = top.Table(key);
  for (const auto& [name, value] : table.table()) {
    lists[std::string(name.str())] = ParseTexts(table, name.str());
  }
  return lists;
}

void ParseClaims(const TomlTable& top, ViewStudy& study) {
  if (!top.Has("claim")) return;
  const TomlTable table = top.Table("claim");
  for (const auto& [key, value] : table.table()) {
    const std::string name(key.str());
    if (name == "source") {
      study.claim_source = table.Text(name);
    } else if (name == "times") {
      const TomlTable times = table.Table(name);
      for (const auto& [what, time] : times.table()) {
        const std::string figure(what.str());
        study.claimed_ms[figure] = times.Number(figure, 0.0, 1e9);
      }
    } else {
      study.claims[name] = table.Number(name, 0.0, 100.0);
    }
  }
}

std::string TextOf(const ViewSource& source) {
  if (!source.folder.empty()) {
    return source.split.empty() ? source.folder
                                : fmt::format("{}, split {}", source.folder, source.split);
  }
  std::vector<std::string_view> families;
  for (const synthetic::Family family : source.families) {
    families.push_back(synthetic::NameOf(family));
  }
  return fmt::format("{} of {}, sensor {}, {} views, {}{} sets, seed {}",
                     synthetic::NameOf(source.kind),
                     fmt::join(families, " and "),
                     synthetic::NameOf(source.sensor),
                     source.num_views,
                     source.num_poses > 0 ? fmt::format("{} poses each, ", source.num_poses) : "",
                     source.num_sets,
                     source.seed);
}

}  // namespace

bool IsOfPlans(ViewTask task) noexcept {
  return task == ViewTask::kGraspPlan || task == ViewTask::kGraspSuccess;
}

std::string_view NameOf(ViewTask task) noexcept {
  switch (task) {
    case ViewTask::kObjectClass:
      return "object-class";
    case ViewTask::kObjectRotation:
      return "object-rotation";
    case ViewTask::kNearestDemonstration:
      return "nearest-demonstration";
    case ViewTask::kGraspPlan:
      return "grasp-plan";
    case ViewTask::kGraspSuccess:
      return "grasp-success";
  }
  return "";
}

std::vector<std::string> RightClasses(const ViewStudy& study, const std::string& object_class) {
  const auto entry = study.associations.find(object_class);
  return entry == study.associations.end() ? std::vector{object_class} : entry->second;
}

bool IsViewStudy(std::string_view text, const std::string& source) {
  return ParseToml(text, source).contains("task");
}

ViewStudy ParseViewStudy(std::string_view text, const std::string& source, StudySize size) {
  const toml::table parsed = ParseToml(text, source);
  const TomlTable top(source, parsed, "");
  top.AllowOnly(std::array<std::string_view, 11>{"name",
                                                 "title",
                                                 "question",
                                                 "task",
                                                 "data",
                                                 "association",
                                                 "groups",
                                                 "settings",
                                                 "method",
                                                 "grid",
                                                 "claim"});
  ViewStudy study;
  study.name = ParseName(top);
  study.title = top.Text("title");
  if (top.Has("question")) study.question = top.Text("question");
  study.task = ParseTask(top);
  const TomlTable data = top.Table("data");
  ParseData(data, size, study);
  study.associations = ParseLists(top, "association");
  study.groups = ParseLists(top, "groups");
  study.settings = ParseStudySettings(top, size, Rules());
  study.methods = ParseMethods(top, size, Rules());
  study.factors = ParseGrid(top, size, Rules(), study.methods);
  ParseClaims(top, study);
  return study;
}

std::vector<ViewCell> MakeViewCells(const ViewStudy& study) {
  std::vector<ViewCell> cells;
  for (const Method& method : study.methods) {
    for (const std::vector<Setting>& factors : Combine(study.factors)) {
      ViewCell cell{.id = CombinationId(method.name, factors),
                    .method = method.name,
                    .factors = factors,
                    .settings = {}};
      for (const auto* list : {&study.settings, &method.settings, &factors}) {
        for (const Setting& setting : *list) ApplyViewSetting(setting, cell.settings);
      }
      cells.push_back(std::move(cell));
    }
  }
  return cells;
}

std::vector<std::string> CanonicalLines(const ViewStudy& study) {
  std::vector<std::string> lines = {fmt::format("name = {}", study.name),
                                    fmt::format("task = {}", NameOf(study.task)),
                                    fmt::format("data.train = {}", TextOf(study.train))};
  if (study.test) lines.push_back(fmt::format("data.test = {}", TextOf(*study.test)));
  if (study.demonstrations) {
    lines.push_back(fmt::format("data.demonstrations = {}", TextOf(*study.demonstrations)));
  }
  for (const auto& [name, right] : study.associations) {
    lines.push_back(fmt::format("association.{} = {}", name, fmt::join(right, ", ")));
  }
  for (const auto& [name, classes] : study.groups) {
    lines.push_back(fmt::format("groups.{} = {}", name, fmt::join(classes, ", ")));
  }
  const auto add = [&](const std::string& owner, const std::vector<Setting>& settings) {
    for (const Setting& setting : settings) {
      lines.push_back(fmt::format("{}.{} = {}", owner, setting.key, setting.value));
    }
  };
  add("settings", study.settings);
  for (const Method& method : study.methods) {
    lines.push_back(fmt::format("method.{} = given", method.name));
    add("method." + method.name, method.settings);
  }
  for (const Factor& factor : study.factors) {
    lines.push_back(fmt::format("grid.{} = {}", factor.key, fmt::join(factor.values, ", ")));
  }
  return lines;
}

}  // namespace handcraft::experiments
