// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/svm_models.h"

#include <cstdint>
#include <span>
#include <utility>

#include "lib/core/check.h"
#include "lib/model_io/column_names.h"
#include "lib/model_io/svm_tensors.h"
#include "lib/runtime/format.h"

namespace handcraft::model_io {
namespace {

namespace format = runtime::format;
using Metadata = std::map<std::string, std::string>;

void DescribeInterface(const SvmNames& names, const SvmModel& model, Metadata& metadata) {
  metadata["hc.inputs"] = "row";
  metadata["hc.input.row.dtype"] = "float64";
  metadata["hc.input.row.shape"] = "num_features";
  metadata["hc.input.row.layout"] = "columns in the order of the tensor column_names";
  metadata["hc.input.row.encoding"] = "raw numbers, as in the table";
  metadata["hc.input.row.units"] = "those of the table";
  metadata["hc.outputs"] = "class margin";
  metadata["hc.output.class.dtype"] = "int32";
  metadata["hc.output.class.shape"] = "1";
  metadata["hc.output.class.units"] = "number of the class, from 0, in the tensor class_names";
  metadata["hc.output.margin.dtype"] = "float64";
  metadata["hc.output.margin.shape"] = "1";
  metadata["hc.output.margin.units"] = "smallest decision value of the class against another";
  metadata["hc.label_column"] = names.label_column;
  metadata["hc.tie_rule"] = TieRuleOf(model.scheme);
}

// § 9.2: the mean row, and the first and the last support vector taken back to raw numbers.
void AddSelfTest(const SvmModel& model, ModelFile& file) {
  const std::size_t p = model.NumFeatures();
  std::vector<double> rows(model.feature_mean);
  for (const std::size_t v : {std::size_t{0}, model.NumSupportVectors() - 1}) {
    for (std::size_t j = 0; j < p; ++j) {
      rows.push_back(model.support_vectors[v * p + j] * model.feature_scale[j] +
                     model.feature_mean[j]);
    }
  }
  std::vector<double> decisions;
  for (std::size_t r = 0; r < rows.size() / p; ++r) {
    const std::vector<double> values = DecisionValues(model, std::span(rows).subspan(r * p, p));
    decisions.insert(decisions.end(), values.begin(), values.end());
  }
  const auto num_rows = static_cast<std::int64_t>(rows.size() / p);
  file.tensors["selftest.input"] = {std::move(rows), {num_rows, static_cast<std::int64_t>(p)}};
  file.tensors["selftest.output"] = {std::move(decisions),
                                     {num_rows, static_cast<std::int64_t>(model.NumMachines())}};
  file.tensors["selftest.tolerance"] = ScalarTensor(1e-9);
}

}  // namespace

ModelFile MakeSvmModel(const SvmModel& model, const SvmNames& names, const Provenance& provenance) {
  HC_CHECK(names.columns.size() == model.NumFeatures(), names.columns.size(), model.NumFeatures());
  ModelFile file{.tensors = {}, .metadata = DescribeOrigin(provenance)};
  file.metadata[std::string(format::kKindKey)] = format::kSvmKind;
  file.metadata[std::string(format::kKindVersionKey)] = format::kKindVersion;
  DescribeInterface(names, model, file.metadata);
  AddSvmTensors(model, names.classes, file);
  file.tensors["column_names"] = VectorTensor(JoinColumnNames(names.columns));
  AddSelfTest(model, file);
  return file;
}

SvmModel ReadSvmModel(const ModelFile& file) {
  RequireKind(file, format::kSvmKind, "handcraft train svm");
  return ReadSvmTensors(file);
}

SvmNames ReadSvmNames(const ModelFile& file) {
  RequireKind(file, format::kSvmKind, "handcraft train svm");
  const auto label = file.metadata.find("hc.label_column");
  return {.columns = NamesIn(file, "column_names"),
          .classes = NamesIn(file, "class_names"),
          .label_column = label == file.metadata.end() ? "" : label->second};
}

}  // namespace handcraft::model_io
