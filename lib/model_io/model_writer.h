// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace handcraft::model_io {

/// A tensor as it is written: row-major values and shape (rank ≤ 4).
struct Tensor {
  std::variant<std::vector<float>,
               std::vector<double>,
               std::vector<std::int64_t>,
               std::vector<std::int32_t>,
               std::vector<std::uint8_t>>
      values;
  std::vector<std::int64_t> shape;
};

/// A model file before it becomes bytes. Metadata keys are the hc.* keys of docs/model_format.md.
struct ModelFile {
  std::map<std::string, Tensor> tensors;
  std::map<std::string, std::string> metadata;
};

/// The bytes of the file, section by section of docs/model_format.md: sorted keys, 64-byte aligned
/// data, CRC last. Same model, same bytes. Throws Error when the model breaks a limit of the format
/// or holds a number that is not finite.
[[nodiscard]] std::vector<std::uint8_t> Serialise(const ModelFile& model);

/// The way back, for inspection and conversion: throws Error with the byte offset. Accepts exactly
/// the files the runtime accepts at format level (the runtime's own parser does the work).
[[nodiscard]] ModelFile Parse(std::span<const std::uint8_t> bytes, const std::string& path);

}  // namespace handcraft::model_io
