// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/view_set.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "datasets/formats/csv_records.h"
#include "datasets/formats/csv_rows.h"
#include "datasets/formats/listing_rules.h"
#include "datasets/formats/required_list.h"
#include "datasets/formats/set_fingerprint.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

enum Column : std::size_t {
  kImage,
  kMask,
  kCloud,
  kClass,
  kInstance,
  kAngle,
  kSplit,
  kLicence,
  kDepth,
  kScene,
  kSymmetry
};
constexpr std::array<std::string_view, 8> kColumns = {
    "image", "object_mask", "cloud", "class", "instance", "angle_deg", "split", "licence"};
constexpr std::array<std::string_view, 3> kOptionalColumns = {"depth", "scene", "symmetry"};
constexpr std::array<std::string_view, 4> kSymmetries = {"", "none", "half_turn", "round"};

std::optional<double> ReadAngleInCircle(const CsvRows& rows) {
  const std::optional<double> angle_deg = ReadAngle(rows, kAngle);
  if (angle_deg && (*angle_deg < 0.0 || *angle_deg >= 360.0)) {
    rows.Fail("angle_deg " + AngleText(angle_deg) + "; 0 or more and less than 360 is due");
  }
  return angle_deg;
}

std::string ReadPath(const CsvRows& rows, Column column, std::string_view name) {
  CheckLiesInFolder(rows.records(), name, rows.Text(column));
  return std::string(rows.Text(column));
}

ObjectView ReadRow(const CsvRows& rows) {
  const std::string_view symmetry = rows.Text(kSymmetry);
  if (std::find(kSymmetries.begin(), kSymmetries.end(), symmetry) == kSymmetries.end()) {
    rows.Fail("symmetry " + Quoted(symmetry) + "; none, half_turn, round or nothing is due");
  }
  for (const Column column : {kImage, kMask, kClass, kInstance, kSplit}) {
    static_cast<void>(rows.Required(column));
  }
  return {.image = ReadPath(rows, kImage, "image"),
          .object_mask = ReadPath(rows, kMask, "object_mask"),
          .cloud = ReadPath(rows, kCloud, "cloud"),
          .object_class = std::string(rows.Text(kClass)),
          .instance = std::string(rows.Text(kInstance)),
          .angle_deg = ReadAngleInCircle(rows),
          .split = std::string(rows.Text(kSplit)),
          .licence = std::string(rows.Text(kLicence)),
          .depth = ReadPath(rows, kDepth, "depth"),
          .scene = ReadPath(rows, kScene, "scene"),
          .symmetry = std::string(symmetry)};
}

}  // namespace

ViewSet ReadViewSet(const fs::path& root) {
  const fs::path path = root / kViewsFileName;
  RequireList(root, kViewsFileName, "a view set");
  CsvRows rows(path, kColumns, kOptionalColumns);
  ViewSet set{.root = root, .items = {}};
  SeenBefore seen;
  while (rows.Next()) {
    set.items.push_back(ReadRow(rows));
    const ObjectView& view = set.items.back();
    seen.Check(rows.records(), view.image, view.instance, view.split);
  }
  if (set.items.empty())
    throw Error({.path = path.string(),
                 .reason = "no view is listed",
                 .remedy = "add a row for each view; see docs/datasets.md"});
  return set;
}

void WriteViews(const ViewSet& set) {
  const auto uses = [&](std::string ObjectView::*field) {
    return std::any_of(set.items.begin(), set.items.end(), [&](const ObjectView& view) {
      return !(view.*field).empty();
    });
  };
  std::vector<std::string ObjectView::*> optional_fields;
  std::string text = "image,object_mask,cloud,class,instance,angle_deg,split,licence";
  const std::array fields = {&ObjectView::depth, &ObjectView::scene, &ObjectView::symmetry};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!uses(fields[i])) continue;
    optional_fields.push_back(fields[i]);
    text.append(",").append(kOptionalColumns[i]);
  }
  text += '\n';
  for (const ObjectView& view : set.items) {
    text += CsvField(view.image);
    for (const std::string& part : {view.object_mask,
                                    view.cloud,
                                    view.object_class,
                                    view.instance,
                                    AngleText(view.angle_deg),
                                    view.split,
                                    view.licence}) {
      text += "," + CsvField(part);
    }
    for (const auto field : optional_fields) text += "," + CsvField(view.*field);
    text += '\n';
  }
  WriteFileAtomically(set.root / kViewsFileName, text);
}

Image ReadObjectMask(const ViewSet& set, std::size_t index) {
  HC_CHECK(index < set.items.size(), index, set.items.size());
  return ReadObjectMask(set.root / set.items[index].object_mask);
}

LoadedView ReadView(const ViewSet& set, std::size_t index) {
  HC_CHECK(index < set.items.size(), index, set.items.size());
  const ObjectView& item = set.items[index];
  LoadedView view{.image = perception::ReadImage(set.root / item.image),
                  .object_mask = ReadObjectMask(set, index),
                  .cloud = std::nullopt};
  RequireSameSize(
      set.root / item.object_mask, "the mask", SizeOf(view.object_mask), SizeOf(view.image));
  if (!item.cloud.empty()) {
    view.cloud = ReadCloudOfPicture(set.root / item.cloud, SizeOf(view.image));
  }
  return view;
}

std::string Fingerprint(const ViewSet& set) {
  std::vector<std::string> lines;
  for (const ObjectView& item : set.items) {
    lines.push_back(FingerprintLine(item.image,
                                    {FileDigest(set.root / item.image),
                                     FileDigest(set.root / item.object_mask),
                                     item.cloud.empty() ? "" : FileDigest(set.root / item.cloud),
                                     item.object_class,
                                     item.instance,
                                     AngleText(item.angle_deg),
                                     item.split}));
  }
  return FingerprintOf(std::move(lines));
}

}  // namespace handcraft::datasets
