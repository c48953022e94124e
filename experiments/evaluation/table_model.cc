// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/table_model.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "datasets/formats/csv_records.h"
#include "datasets/formats/libsvm_table.h"
#include "datasets/formats/npy.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/model_io/column_names.h"
#include "lib/model_io/model_writer.h"
#include "lib/model_io/svm_models.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

void RequireNotPictures(const fs::path& path) {
  constexpr std::array<std::string_view, 6> kPictures = {
      ".png", ".jpg", ".jpeg", ".bmp", ".pgm", ".ppm"};
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  std::error_code ignored;  // what cannot be looked at is named when it is read
  const bool is_folder = fs::is_directory(path, ignored);
  const auto* const found = std::find(kPictures.begin(), kPictures.end(), extension);
  if (!is_folder && found == kPictures.end()) return;
  throw Error({.path = path.string(),
               .reason = std::string("this model reads tables; a ") +
                         (is_folder ? "folder" : "picture") + " was given",
               .remedy = "give a CSV or NPY file"});
}

// The label column as ReadTable takes it; empty when the file has none.
std::string LabelColumnIn(const fs::path& path, const TableModel& model) {
  if (datasets::IsLibsvmText(path)) return "label";
  if (datasets::IsNpy(path)) {
    const bool has_one_more = datasets::ReadNpy(path).columns == model.columns.size() + 1;
    return has_one_more ? model.label_column : "";
  }
  datasets::CsvRecords records(path);
  std::vector<std::string_view> header;
  const bool is_there = records.Next(header) &&
                        std::find(header.begin(), header.end(), model.label_column) != header.end();
  return is_there ? model.label_column : "";
}

// Where each of the model's columns stands in the table. Throws Error naming those that do not.
std::vector<std::size_t> FindColumns(const TableModel& model,
                                     const datasets::Table& table,
                                     const fs::path& path) {
  std::vector<std::size_t> places;
  std::string missing;
  for (const std::string& column : model.columns) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), column);
    places.push_back(static_cast<std::size_t>(found - table.columns.begin()));
    if (found == table.columns.end()) missing += (missing.empty() ? "'" : ", '") + column + "'";
  }
  if (!missing.empty()) {
    throw Error({.path = path.string(),
                 .reason = "the model reads columns that are not there: " + missing,
                 .remedy = "the first line must name them"});
  }
  return places;
}

datasets::Table TakeColumns(const datasets::Table& table,
                            const std::vector<std::size_t>& places,
                            const std::vector<std::string>& names) {
  datasets::Table taken{.columns = names,
                        .values = {},
                        .num_rows = table.num_rows,
                        .label_column = table.label_column,
                        .labels = table.labels};
  taken.values.reserve(table.num_rows * places.size());
  for (std::size_t row = 0; row < table.num_rows; ++row) {
    for (const std::size_t place : places) {
      taken.values.push_back(table.values[row * table.columns.size() + place]);
    }
  }
  return taken;
}

}  // namespace

TableModel ReadTableModel(const fs::path& path) {
  const model_io::ModelFile file = model_io::Parse(ReadFile(path), path.string());
  const auto metadata = [&file](const std::string& key) {
    const auto found = file.metadata.find(key);
    return found == file.metadata.end() ? std::string() : found->second;
  };
  const std::string kind = metadata("hc.kind");
  if (kind == "svm") {
    model_io::SvmNames names = model_io::ReadSvmNames(file);
    return {.columns = std::move(names.columns),
            .label_column = std::move(names.label_column),
            .negative_label = {},
            .positive_label = {},
            .classes = std::move(names.classes)};
  }
  if (kind != "logistic") {
    throw Error(
        {.path = path.string(),
         .reason = "this is a model of kind " + kind + ", which reads no tables",
         .remedy = "give a model made by 'handcraft train logistic' or 'handcraft train svm'"});
  }
  return {.columns = model_io::ColumnNamesOf(file),
          .label_column = metadata("hc.label_column"),
          .negative_label = metadata("hc.labels.0"),
          .positive_label = metadata("hc.labels.1"),
          .classes = {metadata("hc.labels.0"), metadata("hc.labels.1")}};
}

datasets::Table ReadTableFor(const TableModel& model, const fs::path& path) {
  RequireNotPictures(path);
  datasets::Table table = datasets::ReadTable(path, LabelColumnIn(path, model), model.columns);
  const bool has_no_names = datasets::IsNpy(path) || datasets::IsLibsvmText(path);
  if (has_no_names && table.columns.size() == model.columns.size()) {
    table.columns = model.columns;
    return table;
  }
  return TakeColumns(table, FindColumns(model, table, path), model.columns);
}

std::vector<double> PredictTable(const hc_model* model, const datasets::Table& table) {
  const std::size_t num_features = hc_model_num_features(model);
  HC_CHECK(table.columns.size() == num_features, table.columns.size(), num_features);
  std::vector<double> probabilities(table.num_rows);
  for (std::size_t row = 0; row < table.num_rows; ++row) {
    const hc_status status = hc_predict_row(
        model, table.values.data() + row * num_features, num_features, &probabilities[row]);
    HC_CHECK(status == HC_OK, hc_status_message(status));
  }
  return probabilities;
}

void RequireLabelsOf(const TableModel& model, const datasets::Table& table, const fs::path& path) {
  if (table.labels.empty()) {
    throw Error({.path = path.string(),
                 .reason = "no label column '" + model.label_column + "' to compare with",
                 .remedy = "add it, or use 'handcraft predict'"});
  }
  const auto wrong =
      std::find_if(table.labels.begin(), table.labels.end(), [&model](const std::string& label) {
        return std::find(model.classes.begin(), model.classes.end(), label) == model.classes.end();
      });
  if (wrong == table.labels.end()) return;
  std::string list;
  for (const std::string& label : model.classes) {
    list += list.empty() ? "'" : ", '";
    list += label;
    list += '\'';
  }
  throw Error({.path = path.string(),
               .reason = "the label '" + *wrong + "' of row " +
                         std::to_string(wrong - table.labels.begin() + 1) +
                         " is not one of the model's: " + list});
}

}  // namespace handcraft::experiments
