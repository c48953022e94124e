// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/svm_models.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/features/inner_products.h"
#include "lib/model_io/column_names.h"
#include "lib/runtime/format.h"

namespace handcraft::model_io {
namespace {

namespace format = runtime::format;
using Metadata = std::map<std::string, std::string>;

template <class T>
Tensor Vector(std::vector<T> values) {
  const auto size = static_cast<std::int64_t>(values.size());
  return {std::move(values), {size}};
}

template <class T>
Tensor Scalar(T value) {
  return {std::vector<T>{value}, {1}};
}

void CheckSizes(const SvmModel& model, const SvmNames& names) {
  const std::size_t p = model.NumFeatures();
  HC_CHECK(p >= 1 && model.feature_scale.size() == p && names.columns.size() == p,
           p,
           model.feature_scale.size(),
           names.columns.size());
  HC_CHECK(model.num_classes >= 2 && names.classes.size() == model.num_classes,
           model.num_classes,
           names.classes.size());
  HC_CHECK(model.support_vectors.size() == p * model.NumSupportVectors(),
           model.support_vectors.size(),
           p,
           model.NumSupportVectors());
  HC_CHECK(model.NumMachines() == features::NumMachines(model.scheme, model.num_classes) &&
               model.machine_begins.size() == model.NumMachines() + 1,
           model.NumMachines(),
           model.machine_begins.size());
  HC_CHECK(
      model.machine_supports.size() == model.dual_coefficients.size() &&
          static_cast<std::size_t>(model.machine_begins.back()) == model.dual_coefficients.size(),
      model.machine_supports.size(),
      model.dual_coefficients.size());
}

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
  metadata["hc.tie_rule"] = model.scheme == features::ClassScheme::kOneAgainstOne
                                ? "most votes of pairs, then the smaller number"
                                : "largest decision value, then the smaller number";
}

// x' of a raw row, in the precision of the support vectors.
std::vector<double> Normalised(const SvmModel& model, std::span<const double> row) {
  std::vector<double> sample;
  for (std::size_t j = 0; j < row.size(); ++j) {
    const double value = (row[j] - model.feature_mean[j]) / model.feature_scale[j];
    sample.push_back(model.single_precision ? static_cast<double>(static_cast<float>(value))
                                            : value);
  }
  return sample;
}

// With the runtime's own sums, so that the stored answers are the runtime's bits.
double InnerProduct(std::span<const double> a, std::span<const double> b) {
  const std::size_t stride = features::PaddedLength(a.size());
  std::vector<double> rows(2 * stride, 0.0);
  std::copy(a.begin(), a.end(), rows.begin());
  std::copy(b.begin(), b.end(), rows.begin() + static_cast<std::ptrdiff_t>(stride));
  double product = 0.0;
  features::InnerProducts(
      features::PaddedRows<double>{rows.data(), 1, stride}, rows.data() + stride, {&product, 1});
  return product;
}

std::vector<double> DecisionValues(const SvmModel& model, std::span<const double> row) {
  const std::size_t p = model.NumFeatures();
  const std::vector<double> sample = Normalised(model, row);
  const double squared_norm = InnerProduct(sample, sample);
  std::vector<double> kernels;
  for (std::size_t v = 0; v < model.NumSupportVectors(); ++v) {
    const auto support = std::span(model.support_vectors).subspan(v * p, p);
    kernels.push_back(model.similarity(
        InnerProduct(support, sample), squared_norm, InnerProduct(support, support)));
  }
  std::vector<double> values(model.intercepts);
  for (std::size_t m = 0; m < values.size(); ++m) {
    const auto end = static_cast<std::size_t>(model.machine_begins[m + 1]);
    for (auto k = static_cast<std::size_t>(model.machine_begins[m]); k < end; ++k) {
      values[m] +=
          model.dual_coefficients[k] * kernels[static_cast<std::size_t>(model.machine_supports[k])];
    }
  }
  return values;
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
  file.tensors["selftest.tolerance"] = Scalar(1e-9);
}

void RequireKind(const ModelFile& file) {
  const auto found = file.metadata.find(std::string(format::kKindKey));
  const std::string kind = found == file.metadata.end() ? "" : found->second;
  if (kind == format::kSvmKind) return;
  throw Error({.reason = "this is a model of kind '" + kind + "', not a support vector machine",
               .remedy = "give a model made by 'handcraft train svm'"});
}

template <class T>
const std::vector<T>& ValuesOf(const ModelFile& file, const std::string& name) {
  const auto found = file.tensors.find(name);
  const auto* values =
      found == file.tensors.end() ? nullptr : std::get_if<std::vector<T>>(&found->second.values);
  if (values != nullptr && !values->empty()) return *values;
  throw Error({.reason = "the tensor '" + name + "' is missing or of another type",
               .remedy = "look at it with 'handcraft check-model'"});
}

}  // namespace

ModelFile MakeSvmModel(const SvmModel& model, const SvmNames& names, const Provenance& provenance) {
  CheckSizes(model, names);
  ModelFile file{.tensors = {}, .metadata = DescribeOrigin(provenance)};
  file.metadata[std::string(format::kKindKey)] = format::kSvmKind;
  file.metadata[std::string(format::kKindVersionKey)] = format::kKindVersion;
  DescribeInterface(names, model, file.metadata);
  file.tensors["kernel"] = Scalar(static_cast<std::int32_t>(model.similarity.type));
  file.tensors["kernel_degree"] = Scalar<std::int32_t>(model.similarity.degree);
  file.tensors["kernel_gamma"] = Scalar(model.similarity.gamma);
  file.tensors["kernel_coef0"] = Scalar(model.similarity.coef0);
  file.tensors["scheme"] = Scalar(static_cast<std::int32_t>(model.scheme));
  file.tensors["num_classes"] = Scalar(static_cast<std::int32_t>(model.num_classes));
  file.tensors["class_names"] = Vector(JoinNames(names.classes, "class"));
  file.tensors["column_names"] = Vector(JoinColumnNames(names.columns));
  file.tensors["feature_mean"] = Vector(model.feature_mean);
  file.tensors["feature_scale"] = Vector(model.feature_scale);
  const std::vector<std::int64_t> shape = {static_cast<std::int64_t>(model.NumSupportVectors()),
                                           static_cast<std::int64_t>(model.NumFeatures())};
  if (model.single_precision) {
    std::vector<float> rows;
    rows.reserve(model.support_vectors.size());
    for (const double value : model.support_vectors) rows.push_back(static_cast<float>(value));
    file.tensors["support_vectors"] = {std::move(rows), shape};
  } else {
    file.tensors["support_vectors"] = {model.support_vectors, shape};
  }
  file.tensors["support_classes"] = Vector(model.support_classes);
  file.tensors["machine_begins"] = Vector(model.machine_begins);
  file.tensors["machine_supports"] = Vector(model.machine_supports);
  file.tensors["dual_coefficients"] = Vector(model.dual_coefficients);
  file.tensors["intercepts"] = Vector(model.intercepts);
  if (model.rejection_threshold) {
    file.tensors["rejection_threshold"] = Scalar(*model.rejection_threshold);
  }
  AddSelfTest(model, file);
  return file;
}

SvmModel ReadSvmModel(const ModelFile& file) {
  RequireKind(file);
  using Numbers = std::vector<double>;
  const auto integer = [&file](const std::string& name) {
    return ValuesOf<std::int32_t>(file, name)[0];
  };
  const auto number = [&file](const std::string& name) { return ValuesOf<double>(file, name)[0]; };
  SvmModel model;
  model.similarity = {.type = static_cast<features::SimilarityType>(integer("kernel")),
                      .degree = integer("kernel_degree"),
                      .gamma = number("kernel_gamma"),
                      .coef0 = number("kernel_coef0")};
  model.scheme = static_cast<features::ClassScheme>(integer("scheme"));
  model.num_classes = static_cast<std::size_t>(integer("num_classes"));
  model.feature_mean = ValuesOf<double>(file, "feature_mean");
  model.feature_scale = ValuesOf<double>(file, "feature_scale");
  const auto rows = file.tensors.find("support_vectors");
  model.single_precision =
      rows != file.tensors.end() && std::holds_alternative<std::vector<float>>(rows->second.values);
  if (model.single_precision) {
    const auto& values = ValuesOf<float>(file, "support_vectors");
    model.support_vectors = Numbers(values.begin(), values.end());
  } else {
    model.support_vectors = ValuesOf<double>(file, "support_vectors");
  }
  model.support_classes = ValuesOf<std::int32_t>(file, "support_classes");
  model.machine_begins = ValuesOf<std::int32_t>(file, "machine_begins");
  model.machine_supports = ValuesOf<std::int32_t>(file, "machine_supports");
  model.dual_coefficients = ValuesOf<double>(file, "dual_coefficients");
  model.intercepts = ValuesOf<double>(file, "intercepts");
  if (file.tensors.contains("rejection_threshold")) {
    model.rejection_threshold = number("rejection_threshold");
  }
  return model;
}

SvmNames ReadSvmNames(const ModelFile& file) {
  RequireKind(file);
  const auto label = file.metadata.find("hc.label_column");
  return {.columns = NamesIn(file, "column_names"),
          .classes = NamesIn(file, "class_names"),
          .label_column = label == file.metadata.end() ? "" : label->second};
}

}  // namespace handcraft::model_io
