// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/runner/setting.h"
#include "lib/features/feature_spec.h"
#include "trainers/lda/lda.h"

namespace handcraft::experiments {

/// How the weights are found.
enum class Classifier : std::uint8_t {
  kLogistic,  ///< docs/methods/logistic_regression.md
  kLda,       ///< docs/methods/linear_discriminant_analysis.md
};

/// Where best pixels are looked for.
enum class TestRegion : std::uint8_t {
  kPicture,  ///< everywhere
  kObject,   ///< region R of search-space reduction (object_region.h)
};

/// What a cell of a study does: which pixels it is trained on, as which features, by what.
struct CellSettings {
  std::string features = "all500,energy=log";   ///< lib/features/feature_spec.h
  std::optional<features::Energy> energy = {};  ///< none: as `features` say
  std::optional<int> window = {};               ///< 1, 3 or 5 [px]; none: as `features` say
  double ridge = 0.0;                           ///< λ ≥ 0 of logistic regression
  Classifier classifier = Classifier::kLogistic;
  lda::ShrinkageRule shrinkage_rule = lda::ShrinkageRule::kFixed;  ///< of LDA, as what follows
  double shrinkage = 0.0;                                          ///< λ in [0, 1]
  double prior = 0.0;  ///< P(good) in (0, 1); 0: as in the samples
  TestRegion region = TestRegion::kPicture;
  double training_share = 0.7;  ///< share of the instances to train on, (0, 1]
  std::size_t samples = 40000;  ///< pixels to train on; 0: every labelled one
  /// Sizes in which each picture is trained on, [0.1, 10], each size a picture of its own.
  std::vector<double> training_scales = {1.0};
  double bad_per_good = 1.0;  ///< bad pixels for each good one, > 0
};

/// The keys of settings, in the order in which cells are told apart by them.
[[nodiscard]] std::span<const std::string_view> SettingKeys();

/// The classifier that alone reads a setting; none when both do.
[[nodiscard]] std::optional<Classifier> OnlyReader(std::string_view key);

/// Reads one setting into `settings`. Throws Error(kUsage) that names key, value and rule for a key
/// that is none and a value that does not fit it.
void ApplySetting(const Setting& setting, CellSettings& settings);

/// The features after the changes of `energy` and `window`. Throws Error(kUsage) when they name
/// none.
[[nodiscard]] features::FeatureSpec SpecOf(const CellSettings& settings);

}  // namespace handcraft::experiments
