// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/hold_set.h"

#include <array>
#include <string_view>
#include <utility>

#include "datasets/formats/csv_rows.h"
#include "datasets/formats/listing_rules.h"
#include "datasets/formats/named_views.h"
#include "datasets/formats/set_fingerprint.h"
#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

enum Column : std::size_t { kClass, kInstance, kView, kFrameName, kRight = 5, kLeft = 12 };
constexpr std::array<std::string_view, 19> kColumns = {"class",
                                                       "instance",
                                                       "view",
                                                       kFrameColumns[0],
                                                       kFrameColumns[1],
                                                       "right_x_m",
                                                       "right_y_m",
                                                       "right_z_m",
                                                       "right_qx",
                                                       "right_qy",
                                                       "right_qz",
                                                       "right_qw",
                                                       "left_x_m",
                                                       "left_y_m",
                                                       "left_z_m",
                                                       "left_qx",
                                                       "left_qy",
                                                       "left_qz",
                                                       "left_qw"};

Hold ReadRow(const CsvRows& rows, const NamedViews& views) {
  Hold item{.object_class = std::string(rows.Required(kClass)),
            .instance = std::string(rows.Required(kInstance)),
            .view = std::string(rows.Required(kView)),
            .right = {},
            .left = {}};
  CheckFrames(rows, kFrameName);
  item.right = ReadPose(rows, kRight);
  item.left = ReadPose(rows, kLeft);
  static_cast<void>(views.Find(rows, item.view, item.object_class, item.instance));
  return item;
}

// One row as it is written, in the order of kColumns.
std::string RowText(const Hold& item) {
  std::string text;
  for (const std::string& part : {item.object_class, item.instance, item.view}) {
    text += CsvField(part) + ",";
  }
  return text + FrameFields() + "," + PoseFields(item.right) + "," + PoseFields(item.left) + "\n";
}

}  // namespace

HoldSet ReadHoldSet(const fs::path& root) {
  const fs::path path = root / kHoldsFileName;
  CsvRows rows(path, kColumns);
  const NamedViews views(root);
  HoldSet set{.root = root, .items = {}};
  while (rows.Next()) set.items.push_back(ReadRow(rows, views));
  if (set.items.empty()) throw Error({.path = path.string(), .reason = "no hold is listed"});
  return set;
}

RowFindings CheckHolds(const fs::path& root) {
  RowFindings findings;
  CollectFaults(root, findings.faults, [&] {
    CsvRows rows(root / kHoldsFileName, kColumns);
    const NamedViews views(root);
    FindRowFaults(
        rows, root, [&] { return RowText(ReadRow(rows, views)); }, findings);
  });
  return findings;
}

void WriteHolds(const HoldSet& set) {
  std::string text;
  for (const std::string_view column : kColumns) {
    text.append(text.empty() ? "" : ",").append(column);
  }
  text += '\n';
  for (const Hold& item : set.items) text += RowText(item);
  WriteFileAtomically(set.root / kHoldsFileName, text);
}

std::string Fingerprint(const HoldSet& set) {
  std::vector<std::string> lines;
  lines.reserve(set.items.size());
  for (const Hold& item : set.items) lines.push_back(RowText(item));
  return FingerprintOf(std::move(lines));
}

}  // namespace handcraft::datasets
