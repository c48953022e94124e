// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/runtime/model_header.h"

namespace handcraft::runtime {

/// Any length is right in this dimension of a wanted shape.
inline constexpr std::uint64_t kAnyLength = UINT64_MAX;

/// Takes the tensors of a kind out of a parsed model and notices what is missing, has another type
/// or shape, or is unknown (docs/model_format.md § 5).
///
/// Every function returns whether it went well; the first failure sets error(), HC_ERROR_CONTENT,
/// and from then on all fail. Reading allocates (std::bad_alloc).
class ContentReader {
 public:
  /// `model` outlives the reader.
  explicit ContentReader(const ParsedModel& model) noexcept : model_(model) {}

  /// Copies the entries of a tensor of this type (float, double, std::int32_t, std::uint8_t) and
  /// shape; an entry of `shape` may be kAnyLength.
  template <class T>
  bool Read(std::string_view name,
            std::initializer_list<std::uint64_t> shape,
            std::vector<T>& values);

  /// As Read for a tensor of one entry.
  template <class T>
  bool ReadOne(std::string_view name, T& value) {
    std::vector<T> values;
    if (!Read(name, {1}, values)) return false;
    value = values[0];
    return true;
  }

  /// § 6.1: a tensor of `count` UTF-8 names separated by newlines, one for each of what `counted`
  /// says ("weights").
  bool ReadNames(std::string_view name,
                 std::size_t count,
                 const char* counted,
                 std::vector<std::string>& names);

  /// The tensor if there is one; counts as known from now on.
  [[nodiscard]] const TensorView* Find(std::string_view name) noexcept;

  /// § 5.4: the tensors feature_mean and feature_scale, which are for people: what the trainer
  /// subtracted and divided by is folded into the weights already.
  bool CheckNormaliser(std::uint64_t num_features);

  /// § 2.5: refuses tensors that nobody asked for, unless their names begin with "x.".
  bool RefuseUnknownTensors() noexcept;

  /// § 4: refuses a model whose metadata do not say this.
  bool ExpectMetadata(std::string_view key, std::string_view expected) noexcept;

  /// Refuses the model; always false.
  bool Fail(const ModelError& error) noexcept;
  /// The place of a tensor in the file, for Fail.
  [[nodiscard]] std::uint64_t OffsetOf(std::string_view name) const noexcept;
  [[nodiscard]] const ModelError& error() const noexcept { return *error_; }

 private:
  const TensorView* FindWithShape(std::string_view name,
                                  format::Dtype dtype,
                                  std::initializer_list<std::uint64_t> shape) noexcept;

  const ParsedModel& model_;
  std::array<bool, format::kMaxTensors> known_{};
  std::optional<ModelError> error_;
};

}  // namespace handcraft::runtime
