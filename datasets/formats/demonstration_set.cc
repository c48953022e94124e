// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/demonstration_set.h"

#include <array>
#include <string_view>
#include <utility>

#include "datasets/formats/csv_rows.h"
#include "datasets/formats/listing_rules.h"
#include "datasets/formats/named_views.h"
#include "datasets/formats/set_fingerprint.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/path_kind.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

enum Column : std::size_t { kClass, kInstance, kView, kAngle, kFrameName, kEndEffectorName, kPose };
constexpr std::array<std::string_view, 13> kColumns = {"class",
                                                       "instance",
                                                       "view",
                                                       "angle_deg",
                                                       kFrameColumns[0],
                                                       kFrameColumns[1],
                                                       kPoseColumns[0],
                                                       kPoseColumns[1],
                                                       kPoseColumns[2],
                                                       kPoseColumns[3],
                                                       kPoseColumns[4],
                                                       kPoseColumns[5],
                                                       kPoseColumns[6]};

Demonstration ReadRow(const CsvRows& rows, const NamedViews& views) {
  Demonstration item{.object_class = std::string(rows.Required(kClass)),
                     .instance = std::string(rows.Required(kInstance)),
                     .view = std::string(rows.Required(kView)),
                     .angle_deg = ReadAngle(rows, kAngle),
                     .pose = {}};
  CheckFrames(rows, kFrameName);
  item.pose = ReadPose(rows, kPose);
  const NamedViews::View& view = views.Find(rows, item.view, item.object_class, item.instance);
  if (item.angle_deg != view.angle_deg) {
    FailAgainstView(
        rows, view, kColumns[kAngle], AngleText(item.angle_deg), AngleText(view.angle_deg));
  }
  return item;
}

// One row as it is written, in the order of kColumns.
std::string RowText(const Demonstration& item) {
  std::string text;
  for (const std::string& part :
       {item.object_class, item.instance, item.view, AngleText(item.angle_deg)}) {
    text += CsvField(part) + ",";
  }
  return text + FrameFields() + "," + PoseFields(item.pose) + "\n";
}

}  // namespace

DemonstrationSet ReadDemonstrationSet(const fs::path& root) {
  const fs::path path = root / kDemonstrationsFileName;
  if (KindOf(root) == PathKind::kFolder && KindOf(path) == PathKind::kNothing) {
    throw Error({.path = root.string(),
                 .reason = "no demonstrations.csv in this folder: not a demonstration set",
                 .remedy = "see docs/datasets.md, or make one with handcraft data synth"});
  }
  CsvRows rows(path, kColumns);
  const NamedViews views(root);
  DemonstrationSet set{.root = root, .items = {}};
  while (rows.Next()) set.items.push_back(ReadRow(rows, views));
  if (set.items.empty()) throw Error({.path = path.string(), .reason = "no pose is listed"});
  return set;
}

RowFindings CheckDemonstrations(const fs::path& root) {
  RowFindings findings;
  CollectFaults(root, findings.faults, [&] {
    CsvRows rows(root / kDemonstrationsFileName, kColumns);
    const NamedViews views(root);
    FindRowFaults(
        rows, root, [&] { return RowText(ReadRow(rows, views)); }, findings);
  });
  return findings;
}

void WriteDemonstrations(const DemonstrationSet& set) {
  std::string text;
  for (const std::string_view column : kColumns) {
    text.append(text.empty() ? "" : ",").append(column);
  }
  text += '\n';
  for (const Demonstration& item : set.items) text += RowText(item);
  WriteFileAtomically(set.root / kDemonstrationsFileName, text);
}

std::string Fingerprint(const DemonstrationSet& set) {
  std::vector<std::string> lines;
  lines.reserve(set.items.size());
  for (const Demonstration& item : set.items) lines.push_back(RowText(item));
  return FingerprintOf(std::move(lines));
}

}  // namespace handcraft::datasets
