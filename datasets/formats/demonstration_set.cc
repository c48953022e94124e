// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/demonstration_set.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "datasets/formats/csv_rows.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFileName = "demonstrations.csv";
constexpr std::string_view kFrame = "base";
constexpr std::string_view kEndEffector = "grasp_centre";

enum Column : std::size_t { kClass, kInstance, kView, kAngle, kFrameName, kEndEffectorName, kPose };
constexpr std::array<std::string_view, 13> kColumns = {"class",
                                                       "instance",
                                                       "view",
                                                       "angle_deg",
                                                       "frame",
                                                       "end_effector",
                                                       kPoseColumns[0],
                                                       kPoseColumns[1],
                                                       kPoseColumns[2],
                                                       kPoseColumns[3],
                                                       kPoseColumns[4],
                                                       kPoseColumns[5],
                                                       kPoseColumns[6]};

std::string Quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

std::string AngleText(const std::optional<double>& angle_deg) {
  return angle_deg ? NumberToText(*angle_deg) : "";
}

std::optional<double> ReadAngle(const CsvRows& rows, std::size_t column) {
  if (rows.Text(column).empty()) return std::nullopt;
  return rows.Number(column);
}

// What views.csv tells of a picture.
struct ViewRow {
  std::string object_class;
  std::string instance;
  std::optional<double> angle_deg;
  std::size_t line = 0;
};
using ViewRows = std::map<std::string, ViewRow, std::less<>>;

ViewRows ReadViewRows(const fs::path& path) {
  constexpr std::array<std::string_view, 4> kViewColumns = {
      "image", "class", "instance", "angle_deg"};
  ViewRows views;
  CsvRows rows(path, kViewColumns);
  while (rows.Next()) {
    views.try_emplace(std::string(rows.Required(0)),
                      ViewRow{.object_class = std::string(rows.Required(1)),
                              .instance = std::string(rows.Required(2)),
                              .angle_deg = ReadAngle(rows, 3),
                              .line = rows.line()});
  }
  return views;
}

void CheckName(const CsvRows& rows, Column column, std::string_view due, std::string_view remedy) {
  if (rows.Text(column) == due) return;
  rows.Fail(std::string(kColumns[column]) + " " + Quoted(rows.Text(column)) + "; " + Quoted(due) +
                " is due",
            std::string(remedy));
}

void CheckAgainstView(const CsvRows& rows, const Demonstration& item, const ViewRows& views) {
  const auto found = views.find(item.view);
  if (found == views.end()) {
    rows.Fail("the view " + Quoted(item.view) + " is no image of views.csv beside it");
  }
  const ViewRow& view = found->second;
  const auto check = [&](Column column, const std::string& own, const std::string& other) {
    if (own == other) return;
    rows.Fail(std::string(kColumns[column]) + " " + Quoted(own) + "; views.csv has " +
              Quoted(other) + " for this view on line " + std::to_string(view.line));
  };
  check(kClass, item.object_class, view.object_class);
  check(kInstance, item.instance, view.instance);
  check(kAngle, AngleText(item.angle_deg), AngleText(view.angle_deg));
}

Demonstration ReadRow(const CsvRows& rows, const ViewRows& views) {
  Demonstration item{.object_class = std::string(rows.Required(kClass)),
                     .instance = std::string(rows.Required(kInstance)),
                     .view = std::string(rows.Required(kView)),
                     .angle_deg = ReadAngle(rows, kAngle),
                     .pose = {}};
  CheckName(rows, kFrameName, kFrame, "bring the poses into the frame of the views' clouds");
  CheckName(rows,
            kEndEffectorName,
            kEndEffector,
            "give the point between the fingertips, z the approach axis, x the closing axis");
  item.pose = ReadPose(rows, kPose);
  CheckAgainstView(rows, item, views);
  return item;
}

// One row as it is written, in the order of kColumns.
std::string RowText(const Demonstration& item) {
  std::string text;
  for (const std::string& part :
       {item.object_class, item.instance, item.view, AngleText(item.angle_deg)}) {
    text += CsvField(part) + ",";
  }
  text.append(kFrame).append(",").append(kEndEffector).append(",");
  return text + PoseFields(item.pose) + "\n";
}

}  // namespace

DemonstrationSet ReadDemonstrationSet(const fs::path& root) {
  const fs::path path = root / kFileName;
  if (fs::is_directory(root) && !fs::exists(path)) {
    throw Error({.path = root.string(),
                 .reason = "no demonstrations.csv in this folder: not a demonstration set",
                 .remedy = "see docs/datasets.md, or make one with handcraft data synth"});
  }
  CsvRows rows(path, kColumns);
  const ViewRows views = ReadViewRows(root / "views.csv");
  DemonstrationSet set{.root = root, .items = {}};
  while (rows.Next()) set.items.push_back(ReadRow(rows, views));
  if (set.items.empty()) throw Error({.path = path.string(), .reason = "no pose is listed"});
  return set;
}

void WriteDemonstrations(const DemonstrationSet& set) {
  std::string text;
  for (const std::string_view column : kColumns) {
    text.append(text.empty() ? "" : ",").append(column);
  }
  text += '\n';
  for (const Demonstration& item : set.items) text += RowText(item);
  WriteFileAtomically(set.root / kFileName, text);
}

std::string Fingerprint(const DemonstrationSet& set) {
  std::vector<std::string> lines;
  lines.reserve(set.items.size());
  for (const Demonstration& item : set.items) lines.push_back(RowText(item));
  std::sort(lines.begin(), lines.end());
  Sha256 hash;
  for (const std::string& line : lines) hash.Update(line);
  return hash.HexDigest();
}

}  // namespace handcraft::datasets
