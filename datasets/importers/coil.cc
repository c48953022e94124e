// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/coil.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "datasets/formats/npy_pictures.h"
#include "datasets/importers/flat_cloud.h"
#include "datasets/importers/object_mask.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/core/path_kind.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr int kNumViews = 72;  // of an object
constexpr double kStep_deg = 5.0;

// "objN__K" of both ways to keep the pictures.
SourcePicture Describe(const std::string& object, const std::string& image) {
  return {.image = image,
          .mask = fs::path(image).replace_extension(".png").generic_string(),
          .object_class = object,
          .instance = object};
}

// The pictures of an array, object after object.
SourceSet ListArray(const fs::path& source, std::uint8_t threshold) {
  const auto views = std::make_shared<const std::vector<Image>>(ReadNpyPictures(source));
  if (views->size() % kNumViews != 0) {
    throw Error({.path = source.string(),
                 .reason = std::to_string(views->size()) + " pictures; 72 of each object are due"});
  }
  SourceSet set;
  for (std::size_t i = 0; i < views->size(); ++i) {
    const std::size_t step = i % kNumViews;
    const std::string object = "obj" + std::to_string(i / kNumViews + 1);
    SourcePicture& picture =
        set.pictures.emplace_back(Describe(object, object + "__" + std::to_string(step) + ".png"));
    picture.path = source;
    picture.angle_deg = kStep_deg * static_cast<double>(step);
    picture.make_image = [views, i] { return (*views)[i]; };
    picture.make_mask = [views, i, threshold](int, int) {
      return MaskBeforeDarkness((*views)[i], threshold);
    };
  }
  return set;
}

struct ViewName {
  std::string object;
  int number = 0;
};

// "objN__K.png".
std::optional<ViewName> ParseName(const fs::path& file) {
  static const std::regex kPattern("(obj[0-9]+)__([0-9]{1,3})");
  const std::string stem = file.stem().string();
  std::smatch match;
  if (!IsNamedLikeAPicture(file) || !std::regex_match(stem, match, kPattern)) return std::nullopt;
  return ViewName{match[1], std::stoi(match[2])};
}

// The pictures of a folder.
SourceSet ListTree(const fs::path& source, std::uint8_t threshold) {
  SourceSet set;
  int last = 0;
  const auto is_meant = [](const fs::path& path) { return ParseName(path).has_value(); };
  for (const fs::path& file : ListFiles(source, std::numeric_limits<int>::max(), is_meant)) {
    const auto name = ParseName(file);
    if (!name) continue;
    last = std::max(last, name->number);
    SourcePicture& picture = set.pictures.emplace_back(
        Describe(name->object, file.lexically_relative(source).generic_string()));
    picture.path = file;
    picture.angle_deg = name->number;
    picture.make_mask = [file, threshold](int, int) {
      return MaskBeforeDarkness(perception::ReadImage(file), threshold);
    };
  }
  if (set.pictures.empty()) {
    throw Error({.path = source.string(),
                 .reason = "no objN__K.png in it",
                 .remedy = "give the folder of the unpacked pictures, or an NPY file of them"});
  }
  for (SourcePicture& picture : set.pictures) {
    picture.angle_deg =
        std::fmod(*picture.angle_deg * (last >= kNumViews ? 1.0 : kStep_deg), 360.0);
  }
  return set;
}

}  // namespace

void CoilOptions::Validate() const {
  RequireOption(
      threshold >= 0 && threshold <= 255, "CoilOptions.threshold", threshold, "from 0 to 255");
}

SourceSet ListCoil(const fs::path& source, const CoilOptions& options) {
  options.Validate();
  const auto threshold = static_cast<std::uint8_t>(options.threshold);
  SourceSet set = KindOf(source) == PathKind::kFile ? ListArray(source, threshold)
                                                    : ListTree(source, threshold);
  if (options.flat_clouds) AddFlatClouds(set);
  return set;
}

}  // namespace handcraft::datasets
