// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/runtime/format.h"
#include "lib/runtime/result.h"

namespace handcraft::runtime {

/// A tensor of a model file, still as bytes (little-endian, row-major) in the file's memory.
struct TensorView {
  std::string name;
  format::Dtype dtype = format::Dtype::kU8;
  std::size_t rank = 0;
  std::array<std::uint64_t, format::kMaxRank> shape{};  ///< the first `rank` count
  std::uint64_t begin = 0;      ///< of its bytes, counted from the first byte after the header
  std::uint64_t num_bytes = 0;  ///< what dtype and shape take
  std::span<const std::uint8_t> bytes;  ///< empty until ParseModel has checked the layout
  std::uint64_t byte_offset = 0;        ///< of its bytes in the file, likewise
};

/// A model file taken apart.
struct ParsedModel {
  std::vector<TensorView> tensors;                            ///< by name
  std::vector<std::pair<std::string, std::string>> metadata;  ///< by key

  /// Null when there is none.
  [[nodiscard]] const TensorView* FindTensor(std::string_view name) const noexcept;
  [[nodiscard]] const std::string* FindMetadata(std::string_view key) const noexcept;
};

/// Reads the JSON header of a model file (docs/model_format.md § 2.1, § 2.2) and checks the format
/// version (§ 3) on the way; `header` lies right behind the header length. Where the tensors lie is
/// checked for each alone. Errors: HC_ERROR_FORMAT, HC_ERROR_VERSION, with the place in the file.
/// Allocates in proportion to the header (std::bad_alloc).
[[nodiscard]] Result<ParsedModel> ReadModelHeader(std::span<const std::uint8_t> header);

}  // namespace handcraft::runtime
