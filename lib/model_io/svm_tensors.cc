// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/svm_tensors.h"

#include <algorithm>

#include "lib/core/check.h"
#include "lib/features/inner_products.h"
#include "lib/model_io/column_names.h"
#include "lib/runtime/format.h"

namespace handcraft::model_io {
namespace {

void CheckSizes(const SvmModel& model, const std::vector<std::string>& classes) {
  const std::size_t p = model.NumFeatures();
  HC_CHECK(p >= 1 && model.feature_scale.size() == p, p, model.feature_scale.size());
  HC_CHECK(model.num_classes >= 2 && classes.size() == model.num_classes,
           model.num_classes,
           classes.size());
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

}  // namespace

void RequireKind(const ModelFile& file, std::string_view kind, const std::string& command) {
  const auto found = file.metadata.find(std::string(runtime::format::kKindKey));
  const std::string is = found == file.metadata.end() ? "" : found->second;
  if (is == kind) return;
  throw Error({.reason = "this is a model of kind '" + is + "', not of kind " + std::string(kind),
               .remedy = "give a model made by '" + command + "'"});
}

void AddSvmTensors(const SvmModel& model,
                   const std::vector<std::string>& classes,
                   ModelFile& file) {
  CheckSizes(model, classes);
  file.tensors["kernel"] = ScalarTensor(static_cast<std::int32_t>(model.similarity.type));
  file.tensors["kernel_degree"] = ScalarTensor<std::int32_t>(model.similarity.degree);
  file.tensors["kernel_gamma"] = ScalarTensor(model.similarity.gamma);
  file.tensors["kernel_coef0"] = ScalarTensor(model.similarity.coef0);
  file.tensors["scheme"] = ScalarTensor(static_cast<std::int32_t>(model.scheme));
  file.tensors["num_classes"] = ScalarTensor(static_cast<std::int32_t>(model.num_classes));
  file.tensors["class_names"] = VectorTensor(JoinNames(classes, "class"));
  file.tensors["feature_mean"] = VectorTensor(model.feature_mean);
  file.tensors["feature_scale"] = VectorTensor(model.feature_scale);
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
  file.tensors["support_classes"] = VectorTensor(model.support_classes);
  file.tensors["machine_begins"] = VectorTensor(model.machine_begins);
  file.tensors["machine_supports"] = VectorTensor(model.machine_supports);
  file.tensors["dual_coefficients"] = VectorTensor(model.dual_coefficients);
  file.tensors["intercepts"] = VectorTensor(model.intercepts);
  if (model.rejection_threshold) {
    file.tensors["rejection_threshold"] = ScalarTensor(*model.rejection_threshold);
  }
}

SvmModel ReadSvmTensors(const ModelFile& file) {
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

std::string TieRuleOf(features::ClassScheme scheme) {
  return scheme == features::ClassScheme::kOneAgainstOne
             ? "most votes of pairs, then the smaller number"
             : "largest decision value, then the smaller number";
}

}  // namespace handcraft::model_io
