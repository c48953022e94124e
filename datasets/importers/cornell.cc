// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/cornell.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "datasets/formats/csv_records.h"
#include "datasets/importers/cornell_rectangles.h"
#include "datasets/importers/omissions.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

// The files of one number.
struct CornellPicture {
  int number = 0;
  fs::path image, positive, negative, cloud;
  std::vector<GraspRectangle> positive_rectangles;
};

// What a file of this ending is.
struct Part {
  std::string_view ending;
  fs::path CornellPicture::*slot;
};
constexpr std::array kParts = {Part{"r.png", &CornellPicture::image},
                               Part{"cpos.txt", &CornellPicture::positive},
                               Part{"cpos_recovered.txt", &CornellPicture::positive},
                               Part{"cneg.txt", &CornellPicture::negative},
                               Part{".txt", &CornellPicture::cloud}};

// "pcd0123cpos.txt" → 123 and that it holds positive rectangles.
std::optional<std::pair<int, Part>> ParseName(std::string_view name) {
  constexpr std::size_t kDigitsBegin = 3;
  constexpr std::size_t kDigitsEnd = 7;
  if (!name.starts_with("pcd") || name.size() < kDigitsEnd) return std::nullopt;
  int number = 0;
  const char* const end = name.data() + kDigitsEnd;
  const auto result = std::from_chars(name.data() + kDigitsBegin, end, number);
  if (result.ec != std::errc() || result.ptr != end || number < 0) return std::nullopt;
  const auto part = std::find_if(kParts.begin(), kParts.end(), [&](const Part& candidate) {
    return name.substr(kDigitsEnd) == candidate.ending;
  });
  if (part == kParts.end()) return std::nullopt;
  return std::pair(number, *part);
}

std::string FourDigits(int number) {
  const std::string digits = std::to_string(number);
  return std::string(4 - std::min<std::size_t>(digits.size(), 4), '0') + digits;
}

void Place(fs::path& slot, const fs::path& file) {
  if (!slot.empty()) {
    throw Error({.path = file.string(),
                 .reason = "stands for the same picture as " + slot.string(),
                 .remedy = "keep one of them"});
  }
  slot = file;
}

// All files of the data, by number.
std::map<int, CornellPicture> FindFiles(const fs::path& source) {
  const auto parse = [](const fs::path& file) { return ParseName(file.filename().string()); };
  std::map<int, CornellPicture> by_number;
  for (const fs::path& file :
       ListFiles(source, 1, [&](const fs::path& path) { return parse(path).has_value(); })) {
    const auto parsed = parse(file);
    if (!parsed) continue;
    const auto& [number, part] = *parsed;
    by_number[number].number = number;
    Place(by_number[number].*part.slot, file);
  }
  return by_number;
}

// How many have a file of this kind.
std::string CountOf(const std::map<int, CornellPicture>& by_number,
                    fs::path CornellPicture::*slot) {
  return std::to_string(std::count_if(by_number.begin(), by_number.end(), [&](const auto& entry) {
    return !(entry.second.*slot).empty();
  }));
}

// Pictures with positive rectangles, in the order of their numbers.
std::vector<CornellPicture> PicturesAmong(const std::map<int, CornellPicture>& by_number,
                                          Omissions& omissions) {
  std::vector<CornellPicture> pictures;
  for (const auto& entry : by_number) {
    CornellPicture picture = entry.second;
    if (picture.image.empty()) {
      const bool is_labelled = !picture.positive.empty() || !picture.negative.empty();
      const fs::path& label = picture.positive.empty() ? picture.negative : picture.positive;
      omissions.LeaveOut(is_labelled ? label : picture.cloud, "no pcdNNNNr.png of this number");
    } else if (picture.positive.empty()) {
      omissions.LeaveOut(picture.image, "no pcdNNNNcpos.txt of this number");
    } else {
      picture.positive_rectangles = ReadCornellRectangles(picture.positive);
      if (picture.positive_rectangles.empty()) {
        omissions.LeaveOut(picture.positive, kNoUsableRectangle);
      } else {
        pictures.push_back(std::move(picture));
      }
    }
  }
  return pictures;
}

// Those that have no such file although others do.
void TellOfLack(const std::vector<CornellPicture>& pictures,
                fs::path CornellPicture::*slot,
                const std::string& part,
                const std::string& why,
                Omissions& omissions) {
  std::vector<fs::path> lacking;
  for (const CornellPicture& picture : pictures) {
    if ((picture.*slot).empty()) lacking.push_back(picture.image);
  }
  omissions.GoWithoutWhatOthersHave(lacking, pictures.size(), part, why);
}

// grasp_type.csv, when there is one: picture's file name → class.
std::map<std::string, std::string> ReadClasses(const fs::path& source) {
  static constexpr std::array<std::string_view, 5> kGraspTypes = {
      "large_diameter", "palmar_pinch", "precision_sphere", "precision_disk", "parallel_extension"};
  std::map<std::string, std::string> classes;
  const fs::path path = source / "grasp_type.csv";
  if (!HasFile(path)) return classes;
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

constexpr float kMillimetre_m = 0.001F;

std::string InstanceOf(int number, int span) {
  const int first = number / span * span;
  return FourDigits(first) + (span == 1 ? "" : "-" + FourDigits(first + span - 1));
}

SourcePicture Describe(const CornellPicture& picture,
                       const std::map<std::string, std::string>& classes,
                       const CornellOptions& options) {
  const std::string name = "pcd" + FourDigits(picture.number);
  const auto object_class = classes.find(name + "r.png");
  const auto read = [positive = picture.positive_rectangles, negative = picture.negative] {
    return MarkedRectangles{.positive = positive,
                            .negative = negative.empty() ? std::vector<GraspRectangle>()
                                                         : ReadCornellRectangles(negative)};
  };
  SourcePicture found{
      .path = picture.image,
      .image = name + "r.png",
      .mask = name + ".png",
      .object_class = object_class == classes.end() ? "object" : object_class->second,
      .instance = InstanceOf(picture.number, options.instance_span),
      .number = picture.number,
      .make_mask =
          [read, picture, options](int width, int height) {
            MarkedRectangles marked = read();
            if (!options.use_negative_rectangles) marked.negative.clear();
            RequireWithinPicture(picture.positive, marked.positive, width, height);
            RequireWithinPicture(picture.negative, marked.negative, width, height);
            return MakeGraspMask(width, height, marked.positive, marked.negative, options.mask);
          },
      .read_rectangles = read};
  if (!picture.cloud.empty()) {
    found.make_cloud = [cloud = picture.cloud](int width, int height) {
      return ReadCloudOfPicture(cloud, {width, height}, kMillimetre_m);
    };
  }
  return found;
}

}  // namespace

void CornellOptions::Validate() const {
  mask.Validate();
  RequireOption(instance_span >= 1, "CornellOptions.instance_span", instance_span, "1 or more");
  RequireOption(split_gap >= 0, "CornellOptions.split_gap", split_gap, "0 or more");
}

SourceSet ListCornell(const fs::path& source, const CornellOptions& options) {
  options.Validate();
  SourceSet set{.pictures = {}, .split_gap = options.split_gap};
  Omissions omissions;
  const auto classes = ReadClasses(source);
  const auto by_number = FindFiles(source);
  const std::vector<CornellPicture> pictures = PicturesAmong(by_number, omissions);
  TellOfLack(pictures, &CornellPicture::cloud, "its cloud", "no pcdNNNN.txt", omissions);
  TellOfLack(
      pictures, &CornellPicture::negative, "negative rectangles", "no pcdNNNNcneg.txt", omissions);
  for (const CornellPicture& picture : pictures) {
    set.pictures.push_back(Describe(picture, classes, options));
  }
  omissions.Conclude(
      set,
      {.path = source.string(),
       .reason = "no pcdNNNNr.png with grasp rectangles in its pcdNNNNcpos.txt; "
                 "found " +
                 CountOf(by_number, &CornellPicture::image) + " pictures and " +
                 CountOf(by_number, &CornellPicture::positive) + " files of rectangles",
       .remedy = "give the folder that holds them, or holds 01 ... 10"});
  return set;
}

}  // namespace handcraft::datasets
