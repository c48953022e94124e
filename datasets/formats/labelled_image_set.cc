// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/labelled_image_set.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "datasets/formats/csv_records.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kManifestName = "manifest.csv";

struct Column {
  std::string_view name;
  std::string LabelledImage::*field;
  bool may_be_empty;
};
constexpr std::array<Column, 6> kColumns = {{{"image", &LabelledImage::image, false},
                                             {"mask", &LabelledImage::mask, false},
                                             {"class", &LabelledImage::object_class, false},
                                             {"instance", &LabelledImage::instance, false},
                                             {"split", &LabelledImage::split, false},
                                             {"licence", &LabelledImage::licence, true}}};

std::string Quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

// The header line, each name once, with all that must be there.
std::vector<std::string> ReadHeader(const CsvRecords& records,
                                    const std::vector<std::string_view>& fields) {
  std::set<std::string_view> names;
  for (const std::string_view name : fields) {
    if (!names.insert(name).second && !name.empty())
      records.Fail("column " + Quoted(name) + " appears twice");
  }
  for (const Column& column : kColumns) {
    if (names.count(column.name) == 0) {
      records.Fail("no column " + Quoted(column.name),
                   "the first line names the columns: image,mask,class,instance,split,licence");
    }
  }
  return {fields.begin(), fields.end()};
}

void CheckPath(const CsvRecords& records, std::string_view column, const std::string& text) {
  const fs::path path(text);
  const bool climbs = std::find(path.begin(), path.end(), "..") != path.end();
  if (path.is_absolute() || climbs || text.find('\0') != std::string::npos) {
    records.Fail("the " + std::string(column) + " " + Quoted(text) + " lies outside the folder",
                 "give a path below the folder of the manifest");
  }
}

// What may not come twice, with the line it came on first.
class SeenBefore {
 public:
  void Check(const CsvRecords& records, const LabelledImage& item) {
    const std::string image = fs::path(item.image).lexically_normal().string();
    const auto [known_image, is_new] = line_of_image_.try_emplace(image, records.line());
    if (!is_new) {
      records.Fail("the image " + Quoted(item.image) + " stands on line " +
                   std::to_string(known_image->second) + " already");
    }
    const auto [known, is_new_instance] =
        split_of_instance_.try_emplace(item.instance, item.split, records.line());
    const auto& [split, line] = known->second;
    if (!is_new_instance && split != item.split) {
      records.Fail("instance " + Quoted(item.instance) + " is in split " + Quoted(item.split) +
                       " here and in " + Quoted(split) + " on line " + std::to_string(line),
                   "keep all pictures of an object in one split");
    }
  }

 private:
  std::map<std::string, std::size_t> line_of_image_;
  std::map<std::string, std::pair<std::string, std::size_t>> split_of_instance_;
};

LabelledImage ReadRow(const CsvRecords& records,
                      const std::vector<std::string>& header,
                      const std::vector<std::string_view>& fields) {
  LabelledImage item;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const auto column = std::find_if(kColumns.begin(), kColumns.end(), [&](const Column& known) {
      return known.name == header[i];
    });
    if (column == kColumns.end()) {
      if (!fields[i].empty() && !header[i].empty()) item.others.emplace(header[i], fields[i]);
      continue;
    }
    if (fields[i].empty() && !column->may_be_empty) records.Fail("no " + header[i] + " given");
    item.*column->field = std::string(fields[i]);
  }
  CheckPath(records, "image", item.image);
  CheckPath(records, "mask", item.mask);
  for (const std::string_view name : kCompanions) CheckPath(records, name, item.Companion(name));
  return item;
}

// The names of the columns besides the six, in the order in which they are written.
std::vector<std::string> OtherColumns(const LabelledImageSet& set) {
  std::set<std::string> names;
  for (const LabelledImage& item : set.items) {
    for (const auto& [name, value] : item.others) names.insert(name);
  }
  std::vector<std::string> columns;
  for (const std::string_view companion : kCompanions) {
    if (names.erase(std::string(companion)) > 0) columns.emplace_back(companion);
  }
  columns.insert(columns.end(), names.begin(), names.end());
  return columns;
}

void CheckSameSize(const LabelledPicture& picture, const fs::path& mask_path) {
  const auto size = [](const Image& image) {
    return std::to_string(image.width()) + "x" + std::to_string(image.height());
  };
  if (size(picture.image) == size(picture.mask)) return;
  throw Error({.path = mask_path.string(),
               .reason = "the mask is " + size(picture.mask) + " pixels, its picture " +
                         size(picture.image)});
}

void CheckMaskValues(const Image& mask, const fs::path& path) {
  for (int v = 0; v < mask.height(); ++v) {
    for (int u = 0; u < mask.width(); ++u) {
      const std::uint8_t value = mask.At(u, v);
      if (value == kMaskGood || value == kMaskBad || value == kMaskDontCare) continue;
      throw Error({.path = path.string(),
                   .reason = "value " + std::to_string(value) + " at column " + std::to_string(u) +
                             ", row " + std::to_string(v) +
                             "; 255 (good), 0 (bad) or 128 (don't care) is due",
                   .remedy = "save the mask without smoothing, as PNG"});
    }
  }
}

std::string FileDigest(const fs::path& path) { return Sha256Hex(ReadFile(path)); }

}  // namespace

std::string LabelledImage::Companion(std::string_view column) const {
  const auto found = others.find(column);
  return found == others.end() ? std::string() : found->second;
}

LabelledImageSet LabelledImageSet::Only(const std::string& split) const {
  if (split.empty()) return *this;
  LabelledImageSet chosen{.root = root, .items = {}};
  std::set<std::string> splits;
  for (const LabelledImage& item : items) {
    splits.insert(item.split);
    if (item.split == split) chosen.items.push_back(item);
  }
  if (chosen.items.empty()) {
    std::string names;
    for (const std::string& name : splits) names += (names.empty() ? "" : ", ") + Quoted(name);
    throw Error({.kind = Error::Kind::kUsage,
                 .path = root.string(),
                 .reason = "no split " + Quoted(split) + "; there are: " + names});
  }
  return chosen;
}

LabelledImageSet ReadLabelledImageSet(const fs::path& root) {
  const fs::path path = root / kManifestName;
  if (fs::is_directory(root) && !fs::exists(path)) {
    throw Error({.path = root.string(),
                 .reason = "no manifest.csv in this folder: not a labelled image set",
                 .remedy = "see docs/datasets.md, or make one with handcraft data import"});
  }
  CsvRecords records(path);
  std::vector<std::string_view> fields;
  if (!records.Next(fields)) throw Error({.path = path.string(), .reason = "the file is empty"});
  const std::vector<std::string> header = ReadHeader(records, fields);

  LabelledImageSet set{.root = root, .items = {}};
  SeenBefore seen;
  while (records.Next(fields)) {
    if (fields.size() != header.size()) {
      records.Fail(std::to_string(fields.size()) + " fields; the first line has " +
                   std::to_string(header.size()));
    }
    set.items.push_back(ReadRow(records, header, fields));
    seen.Check(records, set.items.back());
  }
  if (set.items.empty()) throw Error({.path = path.string(), .reason = "no image is listed"});
  return set;
}

void WriteManifest(const LabelledImageSet& set) {
  const std::vector<std::string> others = OtherColumns(set);
  std::string text = "image,mask,class,instance,split,licence";
  for (const std::string& name : others) text += "," + CsvField(name);
  text += '\n';
  for (const LabelledImage& item : set.items) {
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      text += (i == 0 ? "" : ",") + CsvField(item.*kColumns[i].field);
    }
    for (const std::string& name : others) text += "," + CsvField(item.Companion(name));
    text += '\n';
  }
  WriteFileAtomically(set.root / kManifestName, text);
}

Image ReadMask(const LabelledImageSet& set, std::size_t index) {
  HC_CHECK(index < set.items.size(), index, set.items.size());
  const fs::path path = set.root / set.items[index].mask;
  Image mask = perception::ReadImage(path, perception::Channels::kGray);
  CheckMaskValues(mask, path);
  return mask;
}

LabelledPicture ReadLabelledPicture(const LabelledImageSet& set, std::size_t index) {
  HC_CHECK(index < set.items.size(), index, set.items.size());
  const LabelledImage& item = set.items[index];
  LabelledPicture picture;
  picture.image = perception::ReadImage(set.root / item.image);
  picture.mask = ReadMask(set, index);
  CheckSameSize(picture, set.root / item.mask);
  return picture;
}

std::set<std::string> LicencesOf(const LabelledImageSet& set) {
  std::set<std::string> licences;
  for (const LabelledImage& item : set.items) licences.insert(item.licence);
  return licences;
}

std::string Fingerprint(const LabelledImageSet& set) {
  std::vector<std::string> lines;
  for (const LabelledImage& item : set.items) {
    std::string line = fs::path(item.image).lexically_normal().generic_string();
    for (const std::string& part : {FileDigest(set.root / item.image),
                                    FileDigest(set.root / item.mask),
                                    item.object_class,
                                    item.instance,
                                    item.split}) {
      line += '\0' + part;
    }
    lines.push_back(line + '\n');
  }
  std::sort(lines.begin(), lines.end());
  Sha256 hash;
  for (const std::string& line : lines) hash.Update(line);
  return hash.HexDigest();
}

}  // namespace handcraft::datasets
