// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "datasets/formats/csv_rows.h"

namespace handcraft::datasets {

/// Throws Error with the row's line when a path that it gives is absolute, climbs by ".." or holds
/// a zero byte. An empty one passes.
void CheckLiesInFolder(const CsvRows& rows, std::string_view column, std::string_view path);

/// What may not come twice in a list of pictures.
class SeenBefore {
 public:
  /// Throws Error with the row's line when its image is listed already, or its instance in another
  /// split; the line it came on first is named.
  void Check(const CsvRows& rows,
             const std::string& image,
             const std::string& instance,
             const std::string& split);

 private:
  std::map<std::string, std::size_t> line_of_image_;
  std::map<std::string, std::pair<std::string, std::size_t>> split_of_instance_;
};

}  // namespace handcraft::datasets
