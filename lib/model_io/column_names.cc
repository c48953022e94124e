// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/column_names.h"

#include "lib/core/error.h"
#include "lib/core/utf8.h"

namespace handcraft::model_io {

// § 6.1: names separated by newlines.
std::vector<std::uint8_t> JoinNames(const std::vector<std::string>& names,
                                    std::string_view counted) {
  const auto refuse = [counted](std::size_t i, const std::string& fault) {
    return Error({.reason = "the name of " + std::string(counted) + " " + std::to_string(i + 1) +
                            " is " + fault,
                  .remedy = "rename the " + std::string(counted)});
  };
  std::vector<std::uint8_t> joined;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty() || names[i].find('\n') != std::string::npos) {
      throw refuse(i, "empty or has a line break");
    }
    if (!IsUtf8(names[i])) throw refuse(i, "not UTF-8");
    if (i > 0) joined.push_back('\n');
    joined.insert(joined.end(), names[i].begin(), names[i].end());
  }
  return joined;
}

std::vector<std::uint8_t> JoinColumnNames(const std::vector<std::string>& names) {
  return JoinNames(names, "column");
}

std::vector<std::string> NamesIn(const ModelFile& model, const std::string& tensor) {
  const auto found = model.tensors.find(tensor);
  const auto* bytes = found == model.tensors.end()
                          ? nullptr
                          : std::get_if<std::vector<std::uint8_t>>(&found->second.values);
  if (bytes == nullptr) return {};
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

std::vector<std::string> ColumnNamesOf(const ModelFile& model) {
  std::vector<std::string> names = NamesIn(model, "column_names");
  if (names.empty()) {
    throw Error({.reason = "the model has no column names",
                 .remedy = "give a model of kind logistic or svm"});
  }
  return names;
}

}  // namespace handcraft::model_io
