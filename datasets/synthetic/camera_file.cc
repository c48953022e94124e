// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/camera_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include <toml++/toml.h>

#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/structured_text/toml_file.h"

namespace handcraft::synthetic {
namespace {

constexpr std::array<std::string_view, 6> kKeys = {
    "width_px", "height_px", "focal_px", "centre_u_px", "centre_v_px", "baseline_m"};

class CameraTable {
 public:
  CameraTable(const std::filesystem::path& path, const toml::table& table)
      : path_(path), table_(table) {
    for (const auto& [key, value] : table) {
      if (std::find(kKeys.begin(), kKeys.end(), key.str()) != kKeys.end()) continue;
      Fail(value,
           "'" + std::string(key.str()) + "' is no key of [camera]",
           "there are width_px, height_px, focal_px, centre_u_px, centre_v_px and baseline_m");
    }
  }

  [[noreturn]] void Fail(const toml::node& at, std::string reason, std::string remedy = {}) const {
    throw Error({.path = path_.string(),
                 .line = at.source().begin.line,
                 .reason = std::move(reason),
                 .remedy = std::move(remedy)});
  }

  // `refusal` begins with the key, or with Struct.key.
  [[noreturn]] void FailAtKey(const std::string& refusal) const {
    constexpr std::string_view kStruct = "PinholeCamera.";
    const std::string reason =
        refusal.starts_with(kStruct) ? refusal.substr(kStruct.size()) : refusal;
    Fail(Need(reason.substr(0, reason.find(' '))), reason);
  }

  [[nodiscard]] bool Has(std::string_view key) const { return table_.contains(key); }

  [[nodiscard]] float Number(std::string_view key) const {
    const toml::node& node = Need(key);
    if (!node.is_number())
      Fail(node, std::string(key) + " is no number", "write one without quotes");
    return static_cast<float>(*node.value<double>());
  }

  [[nodiscard]] int Integer(std::string_view key) const {
    const toml::node& node = Need(key);
    if (!node.is_integer())
      Fail(node, std::string(key) + " is no whole number", "write one without quotes");
    constexpr std::int64_t kMost = std::numeric_limits<int>::max();
    return static_cast<int>(std::clamp<std::int64_t>(*node.value<std::int64_t>(), -kMost, kMost));
  }

 private:
  [[nodiscard]] const toml::node& Need(std::string_view key) const {
    const toml::node* const node = table_.get(key);
    if (node == nullptr) {
      Fail(table_, "no " + std::string(key) + " in [camera]", "add it; see docs/synthetic_data.md");
    }
    return *node;
  }

  const std::filesystem::path& path_;
  const toml::table& table_;
};

}  // namespace

CameraFile ReadCameraFile(const std::filesystem::path& path) {
  const toml::table root = ReadTomlFile(path);
  const toml::table* const found = root["camera"].as_table();
  if (found == nullptr) {
    throw Error({.path = path.string(),
                 .reason = "no table [camera]",
                 .remedy = "see docs/synthetic_data.md; dataset.toml of a made-up set has one"});
  }
  const CameraTable table(path, *found);
  CameraFile file{.camera = {.width_px = table.Integer("width_px"),
                             .height_px = table.Integer("height_px"),
                             .focal_px = table.Number("focal_px"),
                             .centre_u_px = table.Number("centre_u_px"),
                             .centre_v_px = table.Number("centre_v_px")},
                  .baseline_m = std::nullopt};
  if (table.Has("baseline_m")) file.baseline_m = table.Number("baseline_m");
  try {
    file.camera.Validate();
    const float baseline_m = file.baseline_m.value_or(1.0F);
    RequireOption(baseline_m > 0.0F && baseline_m <= 1.0F, "baseline_m", baseline_m, "in (0, 1]");
  } catch (const Error& refusal) {
    table.FailAtKey(refusal.details().reason);
  }
  return file;
}

}  // namespace handcraft::synthetic
