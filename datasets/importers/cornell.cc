// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/cornell.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "datasets/formats/csv_records.h"
#include "datasets/importers/staging_folder.h"
#include "datasets/parallel_reporting.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/option_rules.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

// The files of one number.
struct Picture {
  int number = 0;
  fs::path image, positive, negative;
  std::vector<GraspRectangle> positive_rectangles;
  std::string split;
};

// "pcd0123cpos.txt" → 123, "cpos.txt".
std::optional<std::pair<int, std::string_view>> ParseName(std::string_view name) {
  constexpr std::size_t kDigitsBegin = 3;
  constexpr std::size_t kDigitsEnd = 7;
  if (!name.starts_with("pcd") || name.size() < kDigitsEnd) return std::nullopt;
  int number = 0;
  const char* const end = name.data() + kDigitsEnd;
  const auto result = std::from_chars(name.data() + kDigitsBegin, end, number);
  if (result.ec != std::errc() || result.ptr != end || number < 0) return std::nullopt;
  return std::pair(number, name.substr(kDigitsEnd));
}

std::string FourDigits(int number) {
  const std::string digits = std::to_string(number);
  return std::string(4 - std::min<std::size_t>(digits.size(), 4), '0') + digits;
}

// Files of a folder and of the folders right below it, in order of their names.
std::vector<fs::path> ListFiles(const fs::path& source) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator it(source, error), end; !error && it != end;
       it.increment(error)) {
    if (it.depth() >= 1) it.disable_recursion_pending();
    if (it->is_regular_file()) files.push_back(it->path());
  }
  if (error) {
    throw Error({.path = source.string(),
                 .reason = "cannot read the folder: " + error.message(),
                 .remedy = "check the path"});
  }
  std::sort(files.begin(), files.end());
  return files;
}

void Place(fs::path& slot, const fs::path& file) {
  if (!slot.empty()) {
    throw Error({.path = file.string(),
                 .reason = "stands for the same picture as " + slot.string(),
                 .remedy = "keep one of them"});
  }
  slot = file;
}

// Pictures with positive rectangles, by number.
std::vector<Picture> FindPictures(const fs::path& source) {
  std::map<int, Picture> by_number;
  std::size_t num_images = 0;
  std::size_t num_labels = 0;
  for (const fs::path& file : ListFiles(source)) {
    const std::string name = file.filename().string();
    const auto parsed = ParseName(name);
    if (!parsed) continue;
    Picture& picture = by_number[parsed->first];
    picture.number = parsed->first;
    if (parsed->second == "r.png") Place(picture.image, file), ++num_images;
    if (parsed->second == "cneg.txt") Place(picture.negative, file);
    if (parsed->second == "cpos.txt" || parsed->second == "cpos_recovered.txt") {
      Place(picture.positive, file), ++num_labels;
    }
  }
  std::vector<Picture> pictures;
  for (auto& [number, picture] : by_number) {
    if (picture.image.empty() || picture.positive.empty()) continue;
    picture.positive_rectangles = ReadCornellRectangles(picture.positive);
    if (!picture.positive_rectangles.empty()) pictures.push_back(std::move(picture));
  }
  if (pictures.empty()) {
    throw Error({.path = source.string(),
                 .reason = "no pcdNNNNr.png with grasp rectangles in its pcdNNNNcpos.txt; found " +
                           std::to_string(num_images) + " pictures and " +
                           std::to_string(num_labels) + " files of rectangles",
                 .remedy = "give the folder that holds them, or holds 01 ... 10"});
  }
  return pictures;
}

// Keeps `count` of them, first and last among them.
void Thin(std::vector<Picture>& pictures, std::size_t count) {
  if (count == 0 || count >= pictures.size()) return;
  std::vector<Picture> kept;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t steps = std::max<std::size_t>(count - 1, 1);
    kept.push_back(std::move(pictures[(i * (pictures.size() - 1) + steps / 2) / steps]));
  }
  pictures = std::move(kept);
}

void AssignSplits(std::vector<Picture>& pictures, const CornellOptions& options) {
  std::set<int> instances;
  for (const Picture& picture : pictures) instances.insert(picture.number / options.instance_span);
  const auto num_instances = static_cast<std::ptrdiff_t>(instances.size());
  std::ptrdiff_t num_test = std::lround(options.test_share * static_cast<double>(num_instances));
  num_test = std::clamp<std::ptrdiff_t>(
      num_test, options.test_share > 0.0 ? 1 : 0, std::max<std::ptrdiff_t>(num_instances - 1, 0));
  const int first_test_instance =
      num_test == 0 ? *instances.rbegin() + 1 : *std::prev(instances.end(), num_test);

  std::optional<int> first_test_number;
  for (Picture& picture : pictures) {
    const bool in_test = picture.number / options.instance_span >= first_test_instance;
    picture.split = in_test ? "test" : "train";
    if (in_test && !first_test_number) first_test_number = picture.number;
  }
  std::erase_if(pictures, [&](const Picture& picture) {
    return picture.split == "train" && first_test_number &&
           *first_test_number - picture.number < options.split_gap;
  });
}

// grasp_type.csv, when there is one: picture's file name → class.
std::map<std::string, std::string> ReadClasses(const fs::path& source) {
  static constexpr std::array<std::string_view, 5> kGraspTypes = {
      "large_diameter", "palmar_pinch", "precision_sphere", "precision_disk", "parallel_extension"};
  std::map<std::string, std::string> classes;
  const fs::path path = source / "grasp_type.csv";
  if (!fs::exists(path)) return classes;
  CsvRecords records(path);
  std::vector<std::string_view> fields;
  for (bool is_header = true; records.Next(fields); is_header = false) {
    if (fields.size() != 2) records.Fail("two fields are due: image,grasp_type");
    if (is_header) continue;
    const bool is_type = fields[1].size() == 1 && fields[1] >= "1" && fields[1] <= "5";
    if (!is_type) records.Fail("grasp type '" + std::string(fields[1]) + "'; 1 ... 5 is due");
    const auto type = static_cast<std::size_t>(fields[1][0] - '1');
    classes[std::string(fields[0])] = kGraspTypes[type];
  }
  return classes;
}

LabelledImage DescribePicture(const Picture& picture,
                              const std::map<std::string, std::string>& classes,
                              const CornellOptions& options) {
  const int first = picture.number / options.instance_span * options.instance_span;
  const std::string name = "pcd" + FourDigits(picture.number);
  const auto object_class = classes.find(name + "r.png");
  return {
      .image = "images/" + name + "r.png",
      .mask = "masks/" + name + ".png",
      .object_class = object_class == classes.end() ? "object" : object_class->second,
      .instance =
          FourDigits(first) +
          (options.instance_span == 1 ? "" : "-" + FourDigits(first + options.instance_span - 1)),
      .split = picture.split,
      .licence = options.licence};
}

void WritePicture(const Picture& picture,
                  const LabelledImage& item,
                  const fs::path& root,
                  const CornellOptions& options) {
  const Image image = perception::ReadImage(picture.image);
  std::vector<GraspRectangle> negative;
  if (!picture.negative.empty() && options.use_negative_rectangles) {
    negative = ReadCornellRectangles(picture.negative);
  }
  const Image mask = MakeCornellMask(
      image.width(), image.height(), picture.positive_rectangles, negative, options);
  WriteFileAtomically(root / item.image, ReadFile(picture.image));
  perception::WritePng(root / item.mask, mask);
}

}  // namespace

void CornellOptions::Validate() const {
  RequireOption(
      good_share > 0.0 && good_share <= 1.0, "CornellOptions.good_share", good_share, "in (0, 1]");
  RequireOption(dont_care_margin_px >= 0,
                "CornellOptions.dont_care_margin_px",
                dont_care_margin_px,
                "0 or more");
  RequireOption(instance_span >= 1, "CornellOptions.instance_span", instance_span, "1 or more");
  RequireOption(
      test_share >= 0.0 && test_share < 1.0, "CornellOptions.test_share", test_share, "in [0, 1)");
  RequireOption(split_gap >= 0, "CornellOptions.split_gap", split_gap, "0 or more");
  RequireOption(max_images >= 0, "CornellOptions.max_images", max_images, "0 or more");
  RequireOption(num_threads >= 1, "CornellOptions.num_threads", num_threads, "1 or more");
}

LabelledImageSet ImportCornell(const fs::path& source,
                               const fs::path& out,
                               const CornellOptions& options) {
  options.Validate();
  std::vector<Picture> pictures = FindPictures(source);
  Thin(pictures, static_cast<std::size_t>(options.max_images));
  AssignSplits(pictures, options);
  const auto classes = ReadClasses(source);

  StagingFolder staging(out);
  LabelledImageSet set{.root = staging.path(), .items = {}};
  for (const Picture& picture : pictures) {
    set.items.push_back(DescribePicture(picture, classes, options));
  }
  staging.AddFolder("images");
  staging.AddFolder("masks");
  ParallelForReporting(
      pictures.size(),
      options.num_threads,
      options.progress,
      "importing pictures",
      [&](std::size_t i) { WritePicture(pictures[i], set.items[i], set.root, options); });
  WriteManifest(set);
  staging.MoveToTarget();
  set.root = out;
  return set;
}

}  // namespace handcraft::datasets
