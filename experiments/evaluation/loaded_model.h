// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::experiments {

struct FreeModel {
  void operator()(hc_model* model) const noexcept { hc_model_free(model); }
};
/// A model as the robot has it: loaded and checked by the runtime.
using LoadedModel = std::unique_ptr<hc_model, FreeModel>;

/// Throws Error(kBadInput) with the runtime's own words and the byte offset.
[[nodiscard]] LoadedModel LoadModel(const std::filesystem::path& path);

/// The same from a model file's bytes.
[[nodiscard]] LoadedModel LoadModel(std::span<const std::uint8_t> bytes);

/// A metadata value, empty when there is none.
[[nodiscard]] std::string MetadataOf(const hc_model* model, const char* key);

/// "grasp_point", "logistic", "svm", "object_class" or "grasp_library".
[[nodiscard]] std::string_view KindName(hc_kind kind) noexcept;

}  // namespace handcraft::experiments
