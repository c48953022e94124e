// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/listing_rules.h"

#include <algorithm>
#include <filesystem>

#include "lib/core/fields.h"

namespace handcraft::datasets {

namespace fs = std::filesystem;

void CheckLiesInFolder(const CsvRecords& records, std::string_view column, std::string_view text) {
  const fs::path path(text);
  const bool climbs = std::find(path.begin(), path.end(), "..") != path.end();
  if (path.is_absolute() || climbs || text.find('\0') != std::string_view::npos) {
    records.Fail("the " + std::string(column) + " " + Quoted(text) + " lies outside the folder",
                 "give a path below the folder of this file");
  }
}

std::optional<double> ReadAngle(const CsvRows& rows, std::size_t column) {
  if (rows.Text(column).empty()) return std::nullopt;
  return rows.Number(column);
}

std::string AngleText(const std::optional<double>& angle_deg) {
  return angle_deg ? NumberToText(*angle_deg) : "";
}

void SeenBefore::Check(const CsvRecords& records,
                       const std::string& image,
                       const std::string& instance,
                       const std::string& split) {
  const auto [known_image, is_new] =
      line_of_image_.try_emplace(fs::path(image).lexically_normal().string(), records.line());
  if (!is_new) {
    records.Fail("the image " + Quoted(image) + " stands on line " +
                 std::to_string(known_image->second) + " already");
  }
  const auto [known, is_new_instance] =
      split_of_instance_.try_emplace(instance, split, records.line());
  const auto& [known_split, line] = known->second;
  if (!is_new_instance && known_split != split) {
    records.Fail("instance " + Quoted(instance) + " is in split " + Quoted(split) +
                     " here and in " + Quoted(known_split) + " on line " + std::to_string(line),
                 "keep all pictures of an object in one split");
  }
}

}  // namespace handcraft::datasets
