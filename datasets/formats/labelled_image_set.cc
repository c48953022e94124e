// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/labelled_image_set.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "datasets/formats/csv_records.h"
#include "datasets/formats/listing_rules.h"
#include "datasets/formats/mask_picture.h"
#include "datasets/formats/required_list.h"
#include "datasets/formats/set_fingerprint.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

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
constexpr std::array<MaskValue, 3> kMaskValues = {
    {{kMaskGood, "good"}, {kMaskBad, "bad"}, {kMaskDontCare, "don't care"}}};

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
    if (fields[i].empty() && !column->may_be_empty)
      records.Fail("no " + header[i] + " given", "fill in the column");
    item.*column->field = std::string(fields[i]);
  }
  CheckLiesInFolder(records, "image", item.image);
  CheckLiesInFolder(records, "mask", item.mask);
  for (const std::string_view name : kCompanions)
    CheckLiesInFolder(records, name, item.Companion(name));
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
  const fs::path path = root / kManifestFileName;
  RequireList(root, kManifestFileName, "a labelled image set");
  CsvRecords records(path);
  records.RequireUtf8();
  std::vector<std::string_view> fields;
  if (!records.Next(fields))
    throw Error({.path = path.string(),
                 .reason = "the file is empty",
                 .remedy = "its first line names the columns; see docs/datasets.md"});
  const std::vector<std::string> header = ReadHeader(records, fields);

  LabelledImageSet set{.root = root, .items = {}};
  SeenBefore seen;
  while (records.Next(fields)) {
    if (fields.size() != header.size()) {
      records.Fail(std::to_string(fields.size()) + " fields; the first line has " +
                       std::to_string(header.size()),
                   "fill in what is missing; a field that holds a comma stands in quotes");
    }
    set.items.push_back(ReadRow(records, header, fields));
    const LabelledImage& item = set.items.back();
    seen.Check(records, item.image, item.instance, item.split);
  }
  if (set.items.empty())
    throw Error({.path = path.string(),
                 .reason = "no image is listed",
                 .remedy = "add a row for each picture; see docs/datasets.md"});
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
  WriteFileAtomically(set.root / kManifestFileName, text);
}

Image ReadMask(const LabelledImageSet& set, std::size_t index) {
  HC_CHECK(index < set.items.size(), index, set.items.size());
  return ReadMaskPicture(set.root / set.items[index].mask, kMaskValues);
}

LabelledPicture ReadLabelledPicture(const LabelledImageSet& set, std::size_t index) {
  HC_CHECK(index < set.items.size(), index, set.items.size());
  const LabelledImage& item = set.items[index];
  LabelledPicture picture;
  picture.image = perception::ReadImage(set.root / item.image);
  picture.mask = ReadMask(set, index);
  RequireSameSize(set.root / item.mask, "the mask", SizeOf(picture.mask), SizeOf(picture.image));
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
    lines.push_back(FingerprintLine(item.image,
                                    {FileDigest(set.root / item.image),
                                     FileDigest(set.root / item.mask),
                                     item.object_class,
                                     item.instance,
                                     item.split}));
  }
  return FingerprintOf(std::move(lines));
}

}  // namespace handcraft::datasets
