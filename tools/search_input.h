// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include "datasets/formats/organised_cloud.h"
#include "lib/core/image.h"
#include "lib/perception/search_region.h"

namespace handcraft::tools {

/// What a picture's depth is known from, as options say it: a cloud, a depth picture, or the right
/// picture of a stereo pair; and which way is up.
struct SearchInput {
  std::string cloud = {};
  std::string depth = {};
  std::string right = {};
  std::string camera = {};
  std::optional<float> cloud_unit_m = {};  ///< nothing: as ReadCloudOfPicture knows it
  std::string stereo_method = kSemiGlobal;
  /// Empty: (0, 0, 1) for a cloud, (0, −1, 0) in a camera's optical frame.
  std::vector<float> up = {};
  std::optional<double> up_angle_deg = {};      ///< nothing: 10
  std::optional<double> table_distance_m = {};  ///< nothing: 0.01

  static constexpr const char* kSemiGlobal = "semi-global";
  static constexpr const char* kBlock = "block";

  [[nodiscard]] bool IsGiven() const { return !cloud.empty() || !depth.empty() || !right.empty(); }
  /// The files that are read.
  [[nodiscard]] std::vector<std::filesystem::path> Files() const;
};

/// --cloud, --depth, --right (one of the three), --cloud-unit, --camera, --stereo-method, --up,
/// --up-angle, --table-distance.
void AddSearchOptions(CLI::App& command, SearchInput& input);

/// Throws Error(kUsage) unless the options fit each other and `num_inputs` pictures.
void RequireSearchFits(const SearchInput& input, std::size_t num_inputs);

/// Reads or forms the cloud of a picture, in the cloud's own frame or the camera's. Throws Error
/// with the path: a file that cannot be read, or is of another size than the picture. Of a stereo
/// pair, `matching` becomes the stage "matched": pixels with a point, and the time from the two
/// pictures in memory to the cloud.
[[nodiscard]] datasets::OrganisedCloud CloudFor(
    const SearchInput& input,
    const Image& image,
    std::optional<perception::SearchStage>* matching = nullptr);

/// The options of the reduction that the command line gave.
[[nodiscard]] perception::SearchRegionOptions RegionOptions(const SearchInput& input);

/// State, crop, planes and stages of a reduction.
[[nodiscard]] nlohmann::ordered_json SearchJson(const perception::SearchRegion& region);

/// The stages as a table for people: pixels left and time of each, and the sum.
[[nodiscard]] std::string SearchTable(const perception::SearchRegion& region);

}  // namespace handcraft::tools
