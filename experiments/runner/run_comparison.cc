// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/run_comparison.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "datasets/formats/csv_records.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/path_kind.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

using Row = std::map<std::string, std::string>;      // column → field
using RowKey = std::pair<std::string, std::string>;  // cell, class
constexpr const char* kMissing = "missing";

// results.csv with its order.
struct Results {
  std::vector<std::string> columns;
  std::vector<RowKey> order;
  std::map<RowKey, Row> rows;
};

std::vector<std::string> TextsOf(const std::vector<std::string_view>& fields) {
  return {fields.begin(), fields.end()};
}

Results ReadResults(const fs::path& folder) {
  const fs::path file = folder / "results.csv";
  if (KindOf(file) != PathKind::kFile) {
    throw Error({.kind = Error::Kind::kUsage,
                 .path = folder.string(),
                 .reason = "holds no results.csv",
                 .remedy = "name the folder of a study that has ended"});
  }
  datasets::CsvRecords records(file);
  std::vector<std::string_view> fields;
  Results results;
  if (records.Next(fields)) results.columns = TextsOf(fields);
  const auto has = [&](const char* column) {
    return std::find(results.columns.begin(), results.columns.end(), column) !=
           results.columns.end();
  };
  if (!has("cell") || !has("class")) records.Fail("has no columns cell and class");
  while (records.Next(fields)) {
    if (fields.size() != results.columns.size()) records.Fail("has another number of fields");
    Row row;
    for (std::size_t i = 0; i < fields.size(); ++i) row[results.columns[i]] = fields[i];
    RowKey key{row["cell"], row["class"]};
    results.order.push_back(key);
    results.rows[std::move(key)] = std::move(row);
  }
  return results;
}

// The field of a column, "missing" without the column.
std::string FieldOf(const Row& row, const std::string& column) {
  const auto found = row.find(column);
  return found == row.end() ? kMissing : found->second;
}

void CompareRows(const RowKey& key,
                 const Row& first,
                 const Row& second,
                 RunComparison& comparison) {
  std::set<std::string> columns;
  for (const auto& [column, field] : first) columns.insert(column);
  for (const auto& [column, field] : second) columns.insert(column);
  for (const std::string& column : columns) {
    std::string ours = FieldOf(first, column);
    std::string theirs = FieldOf(second, column);
    if (ours == theirs) continue;
    comparison.differences.push_back(
        {key.first, key.second, column, std::move(ours), std::move(theirs)});
  }
}

std::vector<std::string> DifferentInputs(const fs::path& first, const fs::path& second) {
  std::set<std::string> names;
  for (const fs::path& folder : {first / "inputs", second / "inputs"}) {
    if (KindOf(folder) != PathKind::kFolder) continue;
    for (const auto& entry : fs::directory_iterator(folder)) {
      names.insert(entry.path().filename().string());
    }
  }
  const auto text_of = [](const fs::path& file) {
    return Exists(file) ? ReadTextFile(file) : std::string();
  };
  std::vector<std::string> different;
  for (const std::string& name : names) {
    if (text_of(first / "inputs" / name) != text_of(second / "inputs" / name)) {
      different.push_back(name);
    }
  }
  return different;
}

}  // namespace

RunComparison CompareRuns(const fs::path& first, const fs::path& second) {
  const Results ours = ReadResults(first);
  const Results theirs = ReadResults(second);
  RunComparison comparison{.inputs = DifferentInputs(first, second), .differences = {}};
  for (const RowKey& key : ours.order) {
    const auto found = theirs.rows.find(key);
    if (found == theirs.rows.end()) {
      comparison.differences.push_back({key.first, key.second, "", "there", kMissing});
      continue;
    }
    ++comparison.num_rows;
    CompareRows(key, ours.rows.at(key), found->second, comparison);
  }
  for (const RowKey& key : theirs.order) {
    if (ours.rows.count(key) == 0) {
      comparison.differences.push_back({key.first, key.second, "", kMissing, "there"});
    }
  }
  return comparison;
}

}  // namespace handcraft::experiments
