// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "datasets/formats/csv_rows.h"

namespace handcraft::datasets {

/// The lists that make a folder a data set: labelled pictures, or views; and what may stand beside
/// the views.
inline constexpr std::string_view kManifestFileName = "manifest.csv";
inline constexpr std::string_view kViewsFileName = "views.csv";
inline constexpr std::string_view kDemonstrationsFileName = "demonstrations.csv";
inline constexpr std::string_view kHoldsFileName = "holds.csv";

/// Throws Error with the record's line when a path that it gives is absolute, climbs by ".." or
/// holds a zero byte. An empty one passes.
void CheckLiesInFolder(const CsvRecords& records, std::string_view column, std::string_view path);

/// The angle [deg] in a column that may be empty: none where it is unknown. Throws as
/// CsvRows::Number does.
[[nodiscard]] std::optional<double> ReadAngle(const CsvRows& rows, std::size_t column);

/// The angle as it is written: the shortest text that reads back as the same number, or nothing.
[[nodiscard]] std::string AngleText(const std::optional<double>& angle_deg);

/// What may not come twice in a list of pictures.
class SeenBefore {
 public:
  /// Throws Error with the record's line when its image is listed already, or its instance in
  /// another split; the line it came on first is named.
  void Check(const CsvRecords& records,
             const std::string& image,
             const std::string& instance,
             const std::string& split);

 private:
  std::map<std::string, std::size_t> line_of_image_;
  std::map<std::string, std::pair<std::string, std::size_t>> split_of_instance_;
};

}  // namespace handcraft::datasets
