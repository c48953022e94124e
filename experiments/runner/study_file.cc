// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_file.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "lib/core/file.h"
#include "lib/structured_text/toml_file.h"
#include "lib/structured_text/toml_table.h"

namespace handcraft::experiments {
namespace {

void CheckCellSetting(const Setting& setting) {
  CellSettings scratch;
  ApplySetting(setting, scratch);
}

SettingRules Rules() { return {.keys = SettingKeys(), .check = &CheckCellSetting}; }

DataSource ParseSource(const TomlTable& table, StudySize size) {
  table.AllowOnly(std::array<std::string_view, 4>{"folder", "made", "images", "seed"});
  DataSource source;
  if (table.Has("folder") == table.Has("made")) {
    table.Fail(table.table(), "data has either a folder or made pictures");
  }
  if (table.Has("folder")) {
    table.AllowOnly(std::array<std::string_view, 1>{"folder"});
    source.folder = table.Text("folder");
    return source;
  }
  source.family = table.Text("made");
  const std::array<std::string_view, 5> families = {
      "trained", "novel", "taught", "untaught", "regrasp"};
  if (std::find(families.begin(), families.end(), source.family) == families.end()) {
    table.Fail(table.Node("made"),
               fmt::format("made is \"{}\"", source.family),
               "give one of trained, novel, taught, untaught, regrasp");
  }
  source.num_images = static_cast<int>(ParseWhole(table, "images", size, 1));
  if (table.Has("seed"))
    source.seed = static_cast<std::uint64_t>(ParseWhole(table, "seed", size, 0));
  return source;
}

void ParseData(const TomlTable& top, StudySize size, Study& study) {
  const TomlTable data = top.Table("data");
  data.AllowOnly(std::array<std::string_view, 2>{"train", "test"});
  study.train = ParseSource(data.Table("train"), size);
  if (data.Has("test")) study.test = ParseSource(data.Table("test"), size);
}

StudySplit ParseSplit(const TomlTable& top) {
  if (!top.Has("split")) return StudySplit::kInstance;
  const std::string name = top.Text("split");
  if (name == "instance") return StudySplit::kInstance;
  if (name == "class") return StudySplit::kClass;
  if (name == "picture") return StudySplit::kPicture;
  if (name == "manifest") return StudySplit::kManifest;
  top.Fail(top.Node("split"),
           "split is \"" + name + "\"",
           "give one of instance, class, picture, manifest");
}

void ParseEvaluation(const TomlTable& top, StudySize size, Study& study) {
  if (!top.Has("evaluation")) return;
  const TomlTable table = top.Table("evaluation");
  table.AllowOnly(std::array<std::string_view, 2>{"pixels_per_image", "resamples"});
  if (table.Has("pixels_per_image")) {
    study.pixels_per_image =
        static_cast<std::size_t>(ParseWhole(table, "pixels_per_image", size, 2));
  }
  if (table.Has("resamples")) {
    study.bootstrap_resamples = static_cast<std::size_t>(ParseWhole(table, "resamples", size, 1));
  }
}

std::string ParseBaseline(const TomlTable& top, const Study& study) {
  if (!top.Has("baseline")) return study.methods.front().name;
  std::string baseline = top.Text("baseline");
  for (const Method& method : study.methods) {
    if (method.name == baseline) return baseline;
  }
  top.Fail(top.Node("baseline"), "no method is named \"" + baseline + "\"");
}

std::optional<Claim> ParseClaim(const TomlTable& top) {
  if (!top.Has("claim")) return std::nullopt;
  const TomlTable table = top.Table("claim");
  table.AllowOnly(std::array<std::string_view, 2>{"source", "worst_loss_points"});
  return Claim{table.Text("source"), table.Number("worst_loss_points", 0.0, 100.0)};
}

// A setting of a method or of the grid that a method's classifier does not read would pass for one
// that changes nothing, and multiply equal cells.
void RequireSettingsAreRead(const TomlTable& top, const Study& study) {
  const auto varies = [](const Factor& factor) { return factor.key == "classifier"; };
  if (std::any_of(study.factors.begin(), study.factors.end(), varies)) return;
  for (const Method& method : study.methods) {
    CellSettings settings;
    for (const auto* list : {&study.settings, &method.settings}) {
      for (const Setting& setting : *list) ApplySetting(setting, settings);
    }
    const auto require = [&](const std::string& key, std::string_view table) {
      const std::optional<Classifier> reader = OnlyReader(key);
      if (!reader || *reader == settings.classifier) return;
      top.Fail(top.Node(table),
               fmt::format("{} is not read by the classifier of method \"{}\"", key, method.name),
               "give it to the methods that read it");
    };
    for (const Setting& setting : method.settings) require(setting.key, "method");
    for (const Factor& factor : study.factors) require(factor.key, "grid");
  }
}

}  // namespace

Study ReadStudy(const std::filesystem::path& file, StudySize size) {
  return ParseStudy(ReadTextFile(file), file.string(), size);
}

Study ParseStudy(std::string_view text, const std::string& source, StudySize size) {
  const toml::table parsed = ParseToml(text, source);
  const TomlTable top(source, parsed, "");
  constexpr std::array<std::string_view, 12> kKeys = {"name",
                                                      "title",
                                                      "question",
                                                      "baseline",
                                                      "split",
                                                      "seed",
                                                      "repetitions",
                                                      "data",
                                                      "evaluation",
                                                      "settings",
                                                      "method",
                                                      "grid"};
  std::vector<std::string_view> keys(kKeys.begin(), kKeys.end());
  keys.push_back("claim");
  top.AllowOnly(keys);
  Study study;
  study.name = ParseName(top);
  study.title = top.Text("title");
  if (top.Has("question")) study.question = top.Text("question");
  ParseData(top, size, study);
  study.split = ParseSplit(top);
  if (top.Has("seed")) study.seed = static_cast<std::uint64_t>(ParseWhole(top, "seed", size, 0));
  if (top.Has("repetitions"))
    study.repetitions = static_cast<int>(ParseWhole(top, "repetitions", size, 1));
  ParseEvaluation(top, size, study);
  study.settings = ParseStudySettings(top, size, Rules());
  study.methods = ParseMethods(top, size, Rules());
  study.factors = ParseGrid(top, size, Rules(), study.methods);
  RequireSettingsAreRead(top, study);
  study.baseline = ParseBaseline(top, study);
  study.claim = ParseClaim(top);
  return study;
}

}  // namespace handcraft::experiments
