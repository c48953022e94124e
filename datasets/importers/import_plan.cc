// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/import_plan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <utility>

#include "datasets/formats/mask_picture.h"
#include "datasets/importers/omissions.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/option_rules.h"
#include "lib/core/utf8.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

void RefuseTwins(const std::vector<SourcePicture>& pictures, std::string SourcePicture::*name) {
  std::map<std::string, const SourcePicture*> known;
  for (const SourcePicture& picture : pictures) {
    const auto [twin, is_new] = known.try_emplace(picture.*name, &picture);
    if (is_new) continue;
    throw Error({.path = picture.path.string(),
                 .reason = "stands for the same picture as " + twin->second->path.string(),
                 .remedy = "keep one of them"});
  }
}

// Our lists are UTF-8, and other systems know no other names.
void RequireUtf8Names(const std::vector<SourcePicture>& pictures) {
  for (const SourcePicture& picture : pictures) {
    for (const std::string* name : {&picture.image, &picture.mask}) {
      const std::size_t good = Utf8PrefixLength(*name);
      if (good == name->size()) continue;
      throw Error({.path = picture.path.string(),
                   .reason = "the name is not UTF-8 after '" + name->substr(0, good) + "'",
                   .remedy = "rename the file"});
    }
  }
}

std::regex ParsePattern(const std::string& pattern) {
  try {
    return std::regex(pattern);
  } catch (const std::regex_error& error) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "ImportOptions.instance_pattern is '" + pattern +
                           "'; it must be a regular expression: " + error.what()});
  }
}

void NameInstances(std::vector<SourcePicture>& pictures, const std::string& pattern) {
  if (pattern.empty()) return;
  const std::regex expression = ParsePattern(pattern);
  for (SourcePicture& picture : pictures) {
    std::smatch match;
    const bool found = std::regex_search(picture.image, match, expression);
    const std::string instance = found ? match[match.size() > 1 ? 1 : 0].str() : "";
    if (instance.empty()) {
      throw Error({.path = picture.path.string(),
                   .reason = "the instance pattern '" + pattern + "' finds nothing in '" +
                             picture.image + "'",
                   .remedy = "give one that names the object of every picture"});
    }
    picture.instance = instance;
  }
}

// Keeps `count` of them, first and last among them.
void Thin(std::vector<SourcePicture>& pictures, std::size_t count) {
  if (count == 0 || count >= pictures.size()) return;
  std::vector<SourcePicture> kept;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t steps = std::max<std::size_t>(count - 1, 1);
    kept.push_back(std::move(pictures[(i * (pictures.size() - 1) + steps / 2) / steps]));
  }
  pictures = std::move(kept);
}

void AssignSplits(std::vector<SourcePicture>& pictures, double test_share) {
  std::set<std::string> instances;
  for (const SourcePicture& picture : pictures) instances.insert(picture.instance);
  const auto num_instances = static_cast<std::ptrdiff_t>(instances.size());
  std::ptrdiff_t num_test = std::lround(test_share * static_cast<double>(num_instances));
  num_test = std::clamp<std::ptrdiff_t>(
      num_test, test_share > 0.0 ? 1 : 0, std::max<std::ptrdiff_t>(num_instances - 1, 0));
  const std::set<std::string> test(std::prev(instances.end(), num_test), instances.end());
  for (SourcePicture& picture : pictures) {
    picture.split = test.contains(picture.instance) ? "test" : "train";
  }
}

void LeaveOutNeighboursOfTheTest(SourceSet& source) {
  std::optional<int> first;
  for (const SourcePicture& picture : source.pictures) {
    if (picture.split != "test" || !picture.number) continue;
    first = std::min(first.value_or(*picture.number), *picture.number);
  }
  if (!first) return;
  Omissions omissions;
  std::erase_if(source.pictures, [&](const SourcePicture& picture) {
    const bool is_near =
        picture.split == "train" && picture.number && *first - *picture.number < source.split_gap;
    if (is_near) {
      omissions.LeaveOut(picture.path,
                         "its number is less than " + std::to_string(source.split_gap) +
                             " below the first of the test, and it may show the same object");
    }
    return is_near;
  });
  for (Fault& note : omissions.Notes()) source.notes.push_back(std::move(note));
}

}  // namespace

void ImportOptions::Validate() const {
  RequireOption(
      test_share >= 0.0 && test_share < 1.0, "ImportOptions.test_share", test_share, "in [0, 1)");
  RequireOption(max_images >= 0, "ImportOptions.max_images", max_images, "0 or more");
  RequireOption(num_threads >= 1, "ImportOptions.num_threads", num_threads, "1 or more");
  ParsePattern(instance_pattern);
}

void PlanImport(SourceSet& source, const ImportOptions& options) {
  options.Validate();
  std::vector<SourcePicture>& pictures = source.pictures;
  HC_CHECK(!pictures.empty());
  RequireUtf8Names(pictures);
  RefuseTwins(pictures, &SourcePicture::image);
  RefuseTwins(pictures, &SourcePicture::mask);
  NameInstances(pictures, options.instance_pattern);
  Thin(pictures, static_cast<std::size_t>(options.max_images));
  AssignSplits(pictures, options.test_share);
  LeaveOutNeighboursOfTheTest(source);
}

void TellNotes(const std::vector<Fault>& notes_on_source,
               const std::vector<std::vector<Fault>>& notes_of_pictures,
               const ImportOptions& options) {
  if (!options.on_note) return;
  std::for_each(notes_on_source.begin(), notes_on_source.end(), options.on_note);
  for (const std::vector<Fault>& notes : notes_of_pictures) {
    std::for_each(notes.begin(), notes.end(), options.on_note);
  }
}

void AddFoldersOf(const StagingFolder& staging, const std::vector<std::string>& files) {
  std::set<fs::path> folders;
  for (const std::string& file : files) {
    for (fs::path at = fs::path(file).parent_path(); !at.empty(); at = at.parent_path()) {
      folders.insert(at);
    }
  }
  for (const fs::path& folder : folders) staging.AddFolder(folder);  // parents come first
}

Image CopyPicture(const SourcePicture& picture, const fs::path& copy) {
  if (picture.make_image) {
    Image image = picture.make_image();
    if (!image.empty()) perception::WritePng(copy, image);
    return image;
  }
  if (!picture.embedded) {
    Image image = perception::ReadImage(picture.path);
    WriteFileAtomically(copy, ReadFile(picture.path));
    return image;
  }
  WriteFileAtomically(copy, picture.embedded());
  try {
    return perception::ReadImage(copy);  // from where it was written to, faults told of its source
  } catch (const Error& error) {
    Error::Details details = error.details();
    details.path = picture.path.string();
    details.reason = "the embedded picture: " + details.reason;
    throw Error(details);
  }
}

std::string CloudPath(const SourcePicture& picture) {
  if (!picture.make_cloud) return "";
  return "clouds/" + fs::path(picture.mask).replace_extension(".pcd").generic_string();
}

void WriteCloud(const SourcePicture& picture, const PixelSize& size, const fs::path& path) {
  const OrganisedCloud cloud =
      picture.make_cloud(static_cast<int>(size[0]), static_cast<int>(size[1]));
  RequireSameSize(picture.path, "the cloud", {cloud.width, cloud.height}, size);
  WritePcd(path, cloud);
}

}  // namespace handcraft::datasets
