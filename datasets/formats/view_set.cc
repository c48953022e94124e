// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/view_set.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "datasets/formats/csv_records.h"
#include "datasets/formats/csv_rows.h"
#include "datasets/formats/listing_rules.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kListName = "views.csv";

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

std::string Quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

std::optional<double> ReadAngle(const CsvRows& rows) {
  if (rows.Text(kAngle).empty()) return std::nullopt;
  const double angle_deg = rows.Number(kAngle);
  if (angle_deg < 0.0 || angle_deg >= 360.0) {
    rows.Fail("angle_deg " + NumberToText(angle_deg) + "; 0 or more and less than 360 is due");
  }
  return angle_deg;
}

std::string ReadPath(const CsvRows& rows, Column column, std::string_view name) {
  CheckLiesInFolder(rows, name, rows.Text(column));
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
          .angle_deg = ReadAngle(rows),
          .split = std::string(rows.Text(kSplit)),
          .licence = std::string(rows.Text(kLicence)),
          .depth = ReadPath(rows, kDepth, "depth"),
          .scene = ReadPath(rows, kScene, "scene"),
          .symmetry = std::string(symmetry)};
}

std::string AngleText(const ObjectView& view) {
  return view.angle_deg ? NumberToText(*view.angle_deg) : "";
}

std::string SizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

void CheckSameSize(const fs::path& path,
                   std::string_view what,
                   const std::string& size,
                   const Image& image) {
  if (size == SizeText(image.width(), image.height())) return;
  throw Error({.path = path.string(),
               .reason = "the " + std::string(what) + " is " + size + " pixels, its picture " +
                         SizeText(image.width(), image.height())});
}

void CheckMaskValues(const Image& mask, const fs::path& path) {
  for (int v = 0; v < mask.height(); ++v) {
    for (int u = 0; u < mask.width(); ++u) {
      const std::uint8_t value = mask.At(u, v);
      if (value == kObject || value == kNoObject) continue;
      throw Error({.path = path.string(),
                   .reason = "value " + std::to_string(value) + " at column " + std::to_string(u) +
                             ", row " + std::to_string(v) +
                             "; 255 (object) or 0 (something else) is due",
                   .remedy = "save the mask without smoothing, as PNG"});
    }
  }
}

std::string FileDigest(const fs::path& path) { return Sha256Hex(ReadFile(path)); }

void FindFaultsOf(const LoadedView& view, const ObjectView& item, std::vector<Fault>& faults) {
  std::size_t num_object = 0;
  std::size_t num_measured = 0;
  for (std::size_t i = 0; i < view.object_mask.values().size(); ++i) {
    if (view.object_mask.values()[i] != kObject) continue;
    ++num_object;
    if (view.cloud && IsMeasured(view.cloud->points[i])) ++num_measured;
  }
  if (num_object == 0) {
    faults.push_back({item.object_mask, "no pixel of an object (255)"});
  } else if (view.cloud && num_measured == 0) {
    faults.push_back({item.cloud, "no point of the object was measured"});
  }
}

}  // namespace

bool IsViewSet(const fs::path& root) { return fs::exists(root / kListName); }

ViewSet ReadViewSet(const fs::path& root) {
  const fs::path path = root / kListName;
  if (fs::is_directory(root) && !IsViewSet(root)) {
    throw Error({.path = root.string(),
                 .reason = "no views.csv in this folder: not a view set",
                 .remedy = "see docs/datasets.md, or make one with handcraft data synth"});
  }
  CsvRows rows(path, kColumns, kOptionalColumns);
  ViewSet set{.root = root, .items = {}};
  SeenBefore seen;
  while (rows.Next()) {
    set.items.push_back(ReadRow(rows));
    const ObjectView& view = set.items.back();
    seen.Check(rows, view.image, view.instance, view.split);
  }
  if (set.items.empty()) throw Error({.path = path.string(), .reason = "no view is listed"});
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
                                    AngleText(view),
                                    view.split,
                                    view.licence}) {
      text += "," + CsvField(part);
    }
    for (const auto field : optional_fields) text += "," + CsvField(view.*field);
    text += '\n';
  }
  WriteFileAtomically(set.root / kListName, text);
}

Image ReadObjectMask(const ViewSet& set, std::size_t index) {
  HC_CHECK(index < set.items.size(), index, set.items.size());
  const fs::path path = set.root / set.items[index].object_mask;
  Image mask = perception::ReadImage(path, perception::Channels::kGray);
  CheckMaskValues(mask, path);
  return mask;
}

LoadedView ReadView(const ViewSet& set, std::size_t index) {
  HC_CHECK(index < set.items.size(), index, set.items.size());
  const ObjectView& item = set.items[index];
  LoadedView view{.image = perception::ReadImage(set.root / item.image),
                  .object_mask = ReadObjectMask(set, index),
                  .cloud = std::nullopt};
  CheckSameSize(set.root / item.object_mask,
                "mask",
                SizeText(view.object_mask.width(), view.object_mask.height()),
                view.image);
  if (!item.cloud.empty()) {
    view.cloud = ReadPcd(set.root / item.cloud);
    CheckSameSize(set.root / item.cloud,
                  "cloud",
                  SizeText(view.cloud->width, view.cloud->height),
                  view.image);
  }
  return view;
}

std::string Fingerprint(const ViewSet& set) {
  std::vector<std::string> lines;
  for (const ObjectView& item : set.items) {
    std::string line = fs::path(item.image).lexically_normal().generic_string();
    for (const std::string& part : {FileDigest(set.root / item.image),
                                    FileDigest(set.root / item.object_mask),
                                    item.cloud.empty() ? "" : FileDigest(set.root / item.cloud),
                                    item.object_class,
                                    item.instance,
                                    AngleText(item),
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

std::vector<Fault> FindFaults(const ViewSet& set) {
  std::vector<Fault> faults;
  std::map<std::string, std::size_t> first_of_content;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    const ObjectView& item = set.items[i];
    try {
      FindFaultsOf(ReadView(set, i), item, faults);
      const auto [first, is_new] =
          first_of_content.try_emplace(FileDigest(set.root / item.image), i);
      if (!is_new) {
        faults.push_back({item.image, "the same picture as " + set.items[first->second].image});
      }
    } catch (const Error& error) {
      const Error::Details& details = error.details();
      faults.push_back(
          {fs::path(details.path).lexically_relative(set.root).string(), details.reason});
    }
  }
  return faults;
}

}  // namespace handcraft::datasets
