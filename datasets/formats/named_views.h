// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "datasets/formats/csv_rows.h"

namespace handcraft::datasets {

/// The views of a folder's views.csv, by the name of their image, for the files that stand beside
/// it and name them. They are not opened.
class NamedViews {
 public:
  /// What is told of a view, there and in the file beside it.
  struct View {
    std::string object_class;
    std::string instance;
    std::optional<double> angle_deg;  ///< none where unknown
    std::size_t line = 0;             ///< of views.csv
  };

  /// Throws Error with path and line when views.csv cannot be read.
  explicit NamedViews(const std::filesystem::path& root);

  /// The view of this image. Throws Error with the line of `rows` when there is none, or when its
  /// class or instance is another.
  [[nodiscard]] const View& Find(const CsvRows& rows,
                                 std::string_view image,
                                 std::string_view object_class,
                                 std::string_view instance) const;

 private:
  std::map<std::string, View, std::less<>> by_image_;
};

/// Throws Error with the line of `rows`: a column of it has `own`, views.csv has `other`.
[[noreturn]] void FailAgainstView(const CsvRows& rows,
                                  const NamedViews::View& view,
                                  std::string_view column,
                                  std::string_view own,
                                  std::string_view other);

}  // namespace handcraft::datasets
