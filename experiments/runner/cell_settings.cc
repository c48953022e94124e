// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/cell_settings.h"

#include <algorithm>
#include <array>

#include "experiments/runner/setting_values.h"

namespace handcraft::experiments {
namespace {

double ParsePositive(const Setting& setting, double most, std::string_view rule) {
  const auto number = ParseNumber<double>(setting, rule);
  if (!(number > 0.0 && number <= most)) FailSetting(setting, rule);
  return number;
}

void ApplyFeatures(const Setting& setting, CellSettings& settings) {
  static_cast<void>(features::ParseFeatureSpec(setting.value));
  settings.features = setting.value;
  // A specification always has a window; an energy only where it says so.
  settings.window.reset();
  if (setting.value.find("energy=") != std::string::npos) settings.energy.reset();
}

void ApplyEnergy(const Setting& setting, CellSettings& settings) {
  using features::Energy;
  settings.energy = ParseWord(setting, {Energy::kSquare, Energy::kAbs, Energy::kLog});
}

void ApplyWindow(const Setting& setting, CellSettings& settings) {
  constexpr std::string_view kRule = "1, 3 or 5";
  const auto window = ParseNumber<int>(setting, kRule);
  if (window != 1 && window != 3 && window != 5) FailSetting(setting, kRule);
  settings.window = window;
}

void ApplyRidge(const Setting& setting, CellSettings& settings) {
  constexpr std::string_view kRule = "a number from 0 on";
  settings.ridge = ParseNumber<double>(setting, kRule);
  if (settings.ridge < 0.0) FailSetting(setting, kRule);
}

void ApplyClassifier(const Setting& setting, CellSettings& settings) {
  if (setting.value != "logistic" && setting.value != "lda")
    FailSetting(setting, "logistic or lda");
  settings.classifier = setting.value == "lda" ? Classifier::kLda : Classifier::kLogistic;
}

void ApplyShrinkage(const Setting& setting, CellSettings& settings) {
  constexpr std::string_view kRule = "a number in [0, 1], or auto";
  const bool is_auto = setting.value == "auto";
  settings.shrinkage = is_auto ? 0.0 : ParseNumber<double>(setting, kRule);
  if (!(settings.shrinkage >= 0.0 && settings.shrinkage <= 1.0)) FailSetting(setting, kRule);
  settings.shrinkage_rule = is_auto ? lda::ShrinkageRule::kLedoitWolf : lda::ShrinkageRule::kFixed;
}

void ApplyPrior(const Setting& setting, CellSettings& settings) {
  constexpr std::string_view kRule = "a probability in [0, 1), 0 meaning as in the samples";
  settings.prior = ParseNumber<double>(setting, kRule);
  if (!(settings.prior >= 0.0 && settings.prior < 1.0)) FailSetting(setting, kRule);
}

void ApplyRegion(const Setting& setting, CellSettings& settings) {
  if (setting.value != "picture" && setting.value != "object") {
    FailSetting(setting, "picture or object");
  }
  settings.region = setting.value == "object" ? TestRegion::kObject : TestRegion::kPicture;
}

// "1+0.5+1.5": numbers that differ.
void ApplyScales(const Setting& setting, CellSettings& settings) {
  constexpr std::string_view kRule = "different numbers from 0.1 to 10, such as 1+0.5+1.5";
  settings.training_scales.clear();
  std::size_t begin = 0;
  while (begin <= setting.value.size()) {
    const std::size_t end = std::min(setting.value.find('+', begin), setting.value.size());
    const Setting part{setting.key, setting.value.substr(begin, end - begin)};
    const auto scale = ParseNumber<double>(part, kRule);
    if (!(scale >= 0.1 && scale <= 10.0)) FailSetting(setting, kRule);
    std::vector<double>& scales = settings.training_scales;
    if (std::find(scales.begin(), scales.end(), scale) != scales.end()) FailSetting(setting, kRule);
    scales.push_back(scale);
    begin = end + 1;
  }
}

struct Key {
  std::string_view name;
  void (*apply)(const Setting& setting, CellSettings& settings);
};

constexpr std::array kKeys = {
    Key{"features", &ApplyFeatures},
    Key{"energy", &ApplyEnergy},
    Key{"window", &ApplyWindow},
    Key{"classifier", &ApplyClassifier},
    Key{"ridge", &ApplyRidge},
    Key{"shrinkage", &ApplyShrinkage},
    Key{"prior", &ApplyPrior},
    Key{"training_share",
        [](const Setting& setting, CellSettings& settings) {
          settings.training_share = ParsePositive(setting, 1.0, "a share in (0, 1]");
        }},
    Key{"samples",
        [](const Setting& setting, CellSettings& settings) {
          settings.samples = ParseNumber<std::size_t>(setting, "a whole number from 0 on");
        }},
    Key{"training_scales", &ApplyScales},
    Key{"bad_per_good",
        [](const Setting& setting, CellSettings& settings) {
          settings.bad_per_good = ParsePositive(setting, 1e6, "a number above 0, up to 1e6");
        }},
    Key{"region", &ApplyRegion},
};

constexpr auto kKeyNames = [] {
  std::array<std::string_view, kKeys.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kKeys[i].name;
  return names;
}();

}  // namespace

std::span<const std::string_view> SettingKeys() { return kKeyNames; }

std::optional<Classifier> OnlyReader(std::string_view key) {
  if (key == "ridge") return Classifier::kLogistic;
  if (key == "shrinkage" || key == "prior") return Classifier::kLda;
  return std::nullopt;
}

void ApplySetting(const Setting& setting, CellSettings& settings) {
  ApplyByKey(kKeys, kKeyNames, setting, settings);
}

features::FeatureSpec SpecOf(const CellSettings& settings) {
  features::FeatureSpec spec = features::ParseFeatureSpec(settings.features);
  if (settings.energy) spec.energy = *settings.energy;
  if (settings.window) spec.window = *settings.window;
  return spec;
}

}  // namespace handcraft::experiments
