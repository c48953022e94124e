// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "experiments/object_classes/object_class_training.h"
#include "experiments/runner/setting.h"
#include "lib/features/object_rotation.h"

namespace handcraft::experiments {

/// What a cell of a study of views does: how it describes a cloud, how it tells classes apart, how
/// it finds the most similar view.
struct ViewSettings {
  ObjectClassOptions classes = {};
  features::RotationRule rotation = {};
  std::size_t num_classes = 0;  ///< the first ones alone; 0: all
};

/// The keys of settings, in the order in which cells are told apart by them.
[[nodiscard]] std::span<const std::string_view> ViewSettingKeys();

/// Reads one setting into `settings`. Throws Error(kUsage) that names key, value and rule for a key
/// that is none and a value that does not fit it.
void ApplyViewSetting(const Setting& setting, ViewSettings& settings);

}  // namespace handcraft::experiments
