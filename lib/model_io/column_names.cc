// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/column_names.h"

#include "lib/core/error.h"
#include "lib/core/utf8.h"

namespace handcraft::model_io {

// § 6.1: names separated by newlines.
std::vector<std::uint8_t> JoinColumnNames(const std::vector<std::string>& names) {
  std::vector<std::uint8_t> joined;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty() || names[i].find('\n') != std::string::npos) {
      throw Error({.reason = "the name of column " + std::to_string(i + 1) +
                             " is empty or has a line break",
                   .remedy = "rename the column"});
    }
    if (!IsUtf8(names[i])) {
      throw Error({.reason = "the name of column " + std::to_string(i + 1) + " is not UTF-8",
                   .remedy = "rename the column"});
    }
    if (i > 0) joined.push_back('\n');
    joined.insert(joined.end(), names[i].begin(), names[i].end());
  }
  return joined;
}

std::vector<std::string> ColumnNamesOf(const ModelFile& model) {
  const auto found = model.tensors.find("column_names");
  const auto* bytes = found == model.tensors.end()
                          ? nullptr
                          : std::get_if<std::vector<std::uint8_t>>(&found->second.values);
  if (bytes == nullptr) {
    throw Error(
        {.reason = "the model has no column names", .remedy = "give a model of kind logistic"});
  }
  std::vector<std::string> names(1);
  for (const std::uint8_t byte : *bytes) {
    if (byte == '\n') {
      names.emplace_back();
    } else {
      names.back() += static_cast<char>(byte);
    }
  }
  return names;
}

}  // namespace handcraft::model_io
