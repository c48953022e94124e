// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/folders.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "datasets/formats/mask_picture.h"
#include "datasets/importers/label_picture.h"
#include "datasets/importers/omissions.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/core/path_kind.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr int kNumValues = 256;
constexpr int kDeepest = std::numeric_limits<int>::max();

using MaskValues = std::array<std::uint8_t, kNumValues>;

// What each value of a foreign mask becomes.
MaskValues MeaningOfValues(const FoldersOptions& options) {
  MaskValues meaning{};
  meaning.fill(options.good.empty() ? kMaskGood : kMaskBad);
  if (options.good.empty()) meaning[0] = kMaskBad;
  for (const int value : options.good) meaning.at(static_cast<std::size_t>(value)) = kMaskGood;
  for (const int value : options.dont_care) {
    meaning.at(static_cast<std::size_t>(value)) = kMaskDontCare;
  }
  return meaning;
}

// Path below `folder` without extension and suffix; nothing if the name does not end so.
std::optional<std::string> KeyOf(const fs::path& file,
                                 const fs::path& folder,
                                 const std::string& suffix) {
  if (!IsNamedLikeAPicture(file)) return std::nullopt;
  const std::string key = file.lexically_relative(folder).replace_extension().string();
  if (!key.ends_with(suffix) || key.size() == suffix.size()) return std::nullopt;
  return key.substr(0, key.size() - suffix.size());
}

// Where the files of one kind lie and how they are named.
struct Place {
  fs::path folder;
  std::string suffix;
};

bool IsBelow(const fs::path& path, const fs::path& folder) {
  const fs::path relative = path.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

// Whether a file at `place` is rather one of the other kind: in a folder of its own further down,
// or in the same one with a longer suffix.
bool IsOfOtherKind(const fs::path& file, const Place& place, const Place& other) {
  if (place.folder == other.folder) {
    return other.suffix.size() > place.suffix.size() && KeyOf(file, other.folder, other.suffix);
  }
  return IsBelow(other.folder, place.folder) && IsBelow(file, other.folder);
}

// Files of one kind, by key.
std::map<std::string, fs::path> FindFiles(const Place& place, const Place& other) {
  std::map<std::string, fs::path> files;
  const auto key_of = [&](const fs::path& file) {
    return IsOfOtherKind(file, place, other) ? std::nullopt
                                             : KeyOf(file, place.folder, place.suffix);
  };
  const auto is_meant = [&](const fs::path& path) { return key_of(path).has_value(); };
  for (const fs::path& file : ListFiles(place.folder, kDeepest, is_meant)) {
    const std::optional<std::string> key = key_of(file);
    if (!key) continue;
    const auto [twin, is_new] = files.try_emplace(*key, file);
    if (!is_new) {
      throw Error({.path = file.string(),
                   .reason = "stands for the same picture as " + twin->second.string(),
                   .remedy = "keep one of them"});
    }
  }
  return files;
}

// The names in a folder, a few of them, for a message.
std::string NamesIn(const fs::path& folder) {
  constexpr std::size_t kMostNames = 5;
  std::vector<std::string> names;
  std::error_code ignored;
  for (fs::directory_iterator it(folder, ignored), end; it != end; it.increment(ignored)) {
    names.push_back(it->path().filename().string());
  }
  if (names.empty()) return "nothing";
  std::sort(names.begin(), names.end());
  std::string text = names.front();
  for (std::size_t i = 1; i < std::min(names.size(), kMostNames); ++i) text += ", " + names[i];
  return names.size() > kMostNames ? text + ", …" : text;
}

void RequireFolderIn(const fs::path& source, const fs::path& folder) {
  RequireFolder(folder.parent_path());  // itself: it ends in a slash
  if (KindOf(folder) == PathKind::kFolder) return;
  throw Error({.path = source.string(),
               .reason = "expected the folder " + folder.lexically_relative(source).string() +
                         " in it, found " + NamesIn(source),
               .remedy = "name the folders of pictures and masks (--images, --masks)"});
}

// "labels/…_label.*", for a message.
std::string PatternOf(const Place& place) {
  return (place.folder / "…").string() + place.suffix + ".*";
}

SourcePicture Describe(const fs::path& image,
                       const fs::path& mask,
                       const std::string& key,
                       const fs::path& relative,
                       const MaskValues& meaning) {
  return {.path = image,
          .image = relative.generic_string(),
          .mask = key + ".png",
          .object_class = ClassOfPath(relative),
          .instance = key,
          .make_mask = [mask, meaning](int width, int height) {
            Image values = ReadLabelValues(mask);
            RequireSameSize(mask, "the mask", {values.width(), values.height()}, {width, height});
            for (int v = 0; v < height; ++v) {
              std::uint8_t* const row = values.Row(v);
              std::transform(row, row + width, row, [&](std::uint8_t x) { return meaning[x]; });
            }
            return values;
          }};
}

}  // namespace

void FoldersOptions::Validate() const {
  for (const auto& [name, values] : {std::pair("FoldersOptions.good", &good),
                                     std::pair("FoldersOptions.dont_care", &dont_care)}) {
    for (const int value : *values) {
      RequireOption(value >= 0 && value < kNumValues, name, value, "from 0 to 255");
    }
  }
  for (const int value : dont_care) {
    if (std::find(good.begin(), good.end(), value) == good.end()) continue;
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "the value " + std::to_string(value) +
                           " has two roles; it must be one of good and don't care"});
  }
}

SourceSet ListFolders(const fs::path& source, const FoldersOptions& options) {
  options.Validate();
  const Place images{(source / options.images / "").lexically_normal(), options.image_suffix};
  const Place masks{(source / options.masks / "").lexically_normal(), options.mask_suffix};
  if (images.folder == masks.folder && images.suffix == masks.suffix) {
    throw Error({.kind = Error::Kind::kUsage,
                 .path = images.folder.string(),
                 .reason = "pictures and masks have the same folder and the same suffix",
                 .remedy = "give another folder or suffix for one of them"});
  }
  RequireFolder(source);
  for (const Place* place : {&images, &masks}) RequireFolderIn(source, place->folder);
  const auto image_files = FindFiles(images, masks);
  const auto mask_files = FindFiles(masks, images);
  SourceSet set;
  Omissions omissions;
  const MaskValues meaning = MeaningOfValues(options);
  for (const auto& [key, image] : image_files) {
    const auto mask = mask_files.find(key);
    if (mask == mask_files.end()) {
      omissions.LeaveOut(image, "no mask: expected " + PatternOf(masks));
    } else {
      set.pictures.push_back(
          Describe(image, mask->second, key, image.lexically_relative(images.folder), meaning));
    }
  }
  for (const auto& [key, mask] : mask_files) {
    if (image_files.contains(key)) continue;
    omissions.LeaveOut(mask, "no picture: expected " + PatternOf(images));
  }
  omissions.Conclude(set,
                     {.path = images.folder.string(),
                      .reason = "no picture *" + images.suffix +
                                ".png, .jpg, .bmp, .ppm or .pgm with a mask; found " +
                                std::to_string(image_files.size()) + " pictures and " +
                                std::to_string(mask_files.size()) + " masks",
                      .remedy = "name the folders and suffixes of pictures and masks"});
  return set;
}

}  // namespace handcraft::datasets
