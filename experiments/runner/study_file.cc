// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_file.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/structured_text/toml_file.h"
#include "lib/structured_text/toml_table.h"

namespace handcraft::experiments {
namespace {

constexpr double kMost = 1e9;
constexpr std::size_t kMostNameLength = 60;

// The names of studies and methods become part of names of files.
bool IsPlainName(const std::string& name) {
  return !name.empty() && name.size() <= kMostNameLength && name.front() != '-' &&
         std::all_of(name.begin(), name.end(), [](char letter) {
           return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                  (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
         });
}

std::string ParseName(const TomlTable& table) {
  std::string name = table.Text("name");
  if (!IsPlainName(name)) {
    table.Fail(table.Node("name"),
               fmt::format("name is \"{}\"", name),
               "use letters, digits, _ and -, up to 60");
  }
  return name;
}

// The node itself, or what { small = …, full = … } has for the size.
const toml::node& OfSize(const TomlTable& table, const toml::node& node, StudySize size) {
  const toml::table* const by_size = node.as_table();
  if (by_size == nullptr) return node;
  const toml::node* const chosen = by_size->get(NameOf(size));
  if (chosen == nullptr || by_size->size() != 2 || !by_size->contains("small") ||
      !by_size->contains("full")) {
    table.Fail(node, "a value by size has two entries", "write { small = 216, full = 13247 }");
  }
  return *chosen;
}

template <class Integer>
Integer WholeOf(const TomlTable& table, std::string_view key, StudySize size, double lowest) {
  const toml::node& node = OfSize(table, table.Node(key), size);
  const auto number = node.value_exact<std::int64_t>();
  if (!number || static_cast<double>(*number) < lowest || static_cast<double>(*number) > kMost) {
    table.Fail(node, fmt::format("{} must be a whole number from {} to {}", key, lowest, kMost));
  }
  return static_cast<Integer>(*number);
}

// A setting's value as the command line would have it: text, or a number.
std::string ValueText(const TomlTable& table, const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (const auto whole = node.value_exact<std::int64_t>()) return NumberToText(*whole);
  if (const auto number = node.value_exact<double>()) return NumberToText(*number);
  table.Fail(node, "a setting is a text or a number");
}

// Tries the setting, so that what is wrong is told with its line.
void CheckSetting(const TomlTable& table, const toml::node& node, const Setting& setting) {
  try {
    CellSettings scratch;
    ApplySetting(setting, scratch);
  } catch (const Error& error) {
    table.Fail(node, error.details().reason, error.details().remedy);
  }
}

// The settings of a table, in the order of SettingKeys; other keys are left to the caller.
std::vector<Setting> ParseSettings(const TomlTable& table, StudySize size) {
  std::vector<Setting> settings;
  for (const std::string_view key : SettingKeys()) {
    if (!table.Has(key)) continue;
    const toml::node& node = OfSize(table, table.Node(key), size);
    Setting setting{std::string(key), ValueText(table, node)};
    CheckSetting(table, node, setting);
    settings.push_back(std::move(setting));
  }
  return settings;
}

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
  source.num_images = WholeOf<int>(table, "images", size, 1);
  if (table.Has("seed")) source.seed = WholeOf<std::uint64_t>(table, "seed", size, 0);
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
    study.pixels_per_image = WholeOf<std::size_t>(table, "pixels_per_image", size, 2);
  }
  if (table.Has("resamples")) {
    study.bootstrap_resamples = WholeOf<std::size_t>(table, "resamples", size, 1);
  }
}

void ParseMethods(const TomlTable& top, StudySize size, Study& study) {
  std::vector<std::string_view> keys(SettingKeys().begin(), SettingKeys().end());
  keys.push_back("name");
  std::set<std::string> names;
  for (const TomlTable& table : top.Tables("method")) {
    table.AllowOnly(keys);
    study.methods.push_back({ParseName(table), ParseSettings(table, size)});
    const std::string& name = study.methods.back().name;
    if (!names.insert(name).second) {
      table.Fail(table.Node("name"), "two methods are named \"" + name + "\"");
    }
  }
  if (study.methods.empty()) top.Fail(top.table(), "a study has at least one [[method]]");
}

Factor ParseFactor(const TomlTable& table, std::string_view key, StudySize size) {
  const toml::node& list = OfSize(table, table.Node(key), size);
  const toml::array* const values = list.as_array();
  if (values == nullptr || values->empty()) {
    table.Fail(list, fmt::format("[grid] {} is no list of values", key));
  }
  Factor factor{.key = std::string(key), .values = {}};
  for (const toml::node& node : *values) {
    Setting setting{factor.key, ValueText(table, node)};
    CheckSetting(table, node, setting);
    if (std::find(factor.values.begin(), factor.values.end(), setting.value) !=
        factor.values.end()) {
      table.Fail(node, fmt::format("[grid] {} has {} twice", key, setting.value));
    }
    factor.values.push_back(std::move(setting.value));
  }
  return factor;
}

void ParseGrid(const TomlTable& top, StudySize size, Study& study) {
  if (!top.Has("grid")) return;
  const TomlTable table = top.Table("grid");
  table.AllowOnly(SettingKeys());
  for (const std::string_view key : SettingKeys()) {
    if (!table.Has(key)) continue;
    for (const Method& method : study.methods) {
      const bool is_set = std::any_of(method.settings.begin(),
                                      method.settings.end(),
                                      [&](const Setting& setting) { return setting.key == key; });
      if (is_set) {
        table.Fail(table.Node(key),
                   fmt::format("{} is set by the method \"{}\" too", key, method.name),
                   "vary it in the methods or in [grid]");
      }
    }
    study.factors.push_back(ParseFactor(table, key, size));
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

}  // namespace

std::string_view NameOf(StudySize size) noexcept {
  return size == StudySize::kSmall ? "small" : "full";
}

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
  if (top.Has("seed")) study.seed = WholeOf<std::uint64_t>(top, "seed", size, 0);
  if (top.Has("repetitions")) study.repetitions = WholeOf<int>(top, "repetitions", size, 1);
  ParseEvaluation(top, size, study);
  if (top.Has("settings")) {
    const TomlTable settings = top.Table("settings");
    settings.AllowOnly(SettingKeys());
    study.settings = ParseSettings(settings, size);
  }
  ParseMethods(top, size, study);
  ParseGrid(top, size, study);
  study.baseline = ParseBaseline(top, study);
  study.claim = ParseClaim(top);
  return study;
}

}  // namespace handcraft::experiments
