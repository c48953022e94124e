// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/core/error.h"
#include "lib/model_io/model_writer.h"
#include "lib/model_io/svm_model.h"

namespace handcraft::model_io {

/// A tensor of one dimension.
template <class T>
[[nodiscard]] Tensor VectorTensor(std::vector<T> values) {
  const auto size = static_cast<std::int64_t>(values.size());
  return {std::move(values), {size}};
}

/// A tensor of one entry.
template <class T>
[[nodiscard]] Tensor ScalarTensor(T value) {
  return {std::vector<T>{value}, {1}};
}

/// Throws Error(kBadInput) when the file is not of this kind; `command` makes such files.
void RequireKind(const ModelFile& file, std::string_view kind, const std::string& command);

/// The values of a tensor. Throws Error(kBadInput) when it is missing, empty or of another type.
template <class T>
[[nodiscard]] const std::vector<T>& ValuesOf(const ModelFile& file, const std::string& name) {
  const auto found = file.tensors.find(name);
  const auto* values =
      found == file.tensors.end() ? nullptr : std::get_if<std::vector<T>>(&found->second.values);
  if (values != nullptr && !values->empty()) return *values;
  throw Error({.reason = "the tensor '" + name + "' is missing or of another type",
               .remedy = "look at it with 'handcraft check-model'"});
}

/// Adds the tensors of docs/model_format.md § 9 but for column_names and the self-test. Throws
/// std::logic_error when sizes do not fit, Error(kBadInput) for a bad class name.
void AddSvmTensors(const SvmModel& model, const std::vector<std::string>& classes, ModelFile& file);

/// The way back. Throws Error(kBadInput) as ValuesOf does.
[[nodiscard]] SvmModel ReadSvmTensors(const ModelFile& file);

/// The value of every machine for a row of raw numbers, with the runtime's own sums.
[[nodiscard]] std::vector<double> DecisionValues(const SvmModel& model,
                                                 std::span<const double> row);

/// hc.tie_rule.
[[nodiscard]] std::string TieRuleOf(features::ClassScheme scheme);

}  // namespace handcraft::model_io
