// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/pca_models.h"

#include "lib/core/check.h"
#include "lib/model_io/column_names.h"
#include "lib/runtime/format.h"

namespace handcraft::model_io {

namespace {

void CheckSizes(const PcaModel& model, std::size_t num_columns) {
  HC_CHECK(num_columns >= 1 && model.eigenvalues.size() == num_columns,
           num_columns,
           model.eigenvalues.size());
  HC_CHECK(model.feature_mean.size() == num_columns && model.feature_scale.size() == num_columns,
           num_columns,
           model.feature_mean.size(),
           model.feature_scale.size());
  const std::size_t size = model.components.size();
  HC_CHECK(size >= num_columns && size <= num_columns * num_columns && size % num_columns == 0,
           num_columns,
           size);
}

}  // namespace

ModelFile MakePcaModel(const std::vector<std::string>& column_names,
                       const PcaModel& model,
                       const Provenance& provenance) {
  const std::size_t p = column_names.size();
  CheckSizes(model, p);
  const std::size_t count = model.components.size() / p;
  ModelFile file{.tensors = {}, .metadata = DescribeOrigin(provenance)};
  file.metadata[std::string(runtime::format::kKindKey)] = "pca";
  file.metadata[std::string(runtime::format::kKindVersionKey)] = "1";
  file.metadata["hc.inputs"] = "row";
  file.metadata["hc.input.row.dtype"] = "float64";
  file.metadata["hc.input.row.shape"] = "num_features";
  file.metadata["hc.input.row.layout"] = "columns in the order of the tensor column_names";
  file.metadata["hc.outputs"] = "component";
  file.metadata["hc.output.component.dtype"] = "float64";
  file.metadata["hc.output.component.shape"] = std::to_string(count);
  const auto size = static_cast<std::int64_t>(p);
  std::vector<std::uint8_t> names = JoinColumnNames(column_names);
  const auto num_bytes = static_cast<std::int64_t>(names.size());
  file.tensors["column_names"] = {std::move(names), {num_bytes}};
  file.tensors["components"] = {model.components, {static_cast<std::int64_t>(count), size}};
  file.tensors["eigenvalues"] = {model.eigenvalues, {size}};
  file.tensors["feature_mean"] = {model.feature_mean, {size}};
  file.tensors["feature_scale"] = {model.feature_scale, {size}};
  return file;
}

}  // namespace handcraft::model_io
