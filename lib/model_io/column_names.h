// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/model_io/model_writer.h"

namespace handcraft::model_io {

/// Names separated by newlines, docs/model_format.md § 6.1. Throws Error(kBadInput) for a name that
/// is empty, has a line break or is not UTF-8; `counted` says in it what they are names of
/// ("class").
[[nodiscard]] std::vector<std::uint8_t> JoinNames(const std::vector<std::string>& names,
                                                  std::string_view counted);

/// The way back: the names in a tensor of a model, empty when there is none of bytes.
[[nodiscard]] std::vector<std::string> NamesIn(const ModelFile& model, const std::string& tensor);

/// The names as the tensor column_names holds them, docs/model_format.md § 6.1. Throws
/// Error(kBadInput) for a name that is empty, has a line break or is not UTF-8.
[[nodiscard]] std::vector<std::uint8_t> JoinColumnNames(const std::vector<std::string>& names);

/// The columns of a model of kind "logistic", "svm" or "pca", in the order of its weights. Throws
/// Error(kBadInput) for a kind without.
[[nodiscard]] std::vector<std::string> ColumnNamesOf(const ModelFile& model);

}  // namespace handcraft::model_io
