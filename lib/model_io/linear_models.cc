// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/linear_models.h"

#include <utility>

#include "lib/core/check.h"
#include "lib/core/sha256.h"
#include "lib/features/filter_bank.h"
#include "lib/model_io/column_names.h"
#include "lib/model_io/grasp_point_self_test.h"
#include "lib/runtime/format.h"
#include "lib/runtime/logistic_model.h"

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

// § 4.2: what a grasp-point model takes and gives.
void DescribeImageInterface(Metadata& metadata) {
  metadata["hc.inputs"] = "image";
  metadata["hc.input.image.dtype"] = "uint8";
  metadata["hc.input.image.shape"] = "height,width,channels";
  metadata["hc.input.image.layout"] = "rows from the top, channels interleaved";
  metadata["hc.input.image.encoding"] = "gray, BGR or RGB; Y'CbCr by ITU-R BT.601, full range";
  metadata["hc.input.image.units"] = "0 to 255";
  metadata["hc.outputs"] = "probability";
  metadata["hc.output.probability.dtype"] = "float32";
  metadata["hc.output.probability.shape"] = "height,width";
  metadata["hc.output.probability.layout"] = "rows from the top";
  metadata["hc.output.probability.units"] = "probability of label 1, 0 to 1";
  metadata["hc.labels.0"] = "other";
  metadata["hc.labels.1"] = "grasp_point";
  metadata["hc.tie_rule"] = "best first by probability, then smaller row, then smaller column";
  metadata["hc.frames"] = "image: u right, v down, (0, 0) the centre of the top-left pixel [px]";
}

void DescribeRowInterface(Metadata& metadata) {
  metadata["hc.inputs"] = "row";
  metadata["hc.input.row.dtype"] = "float64";
  metadata["hc.input.row.shape"] = "num_features";
  metadata["hc.input.row.layout"] = "columns in the order of the tensor column_names";
  metadata["hc.input.row.encoding"] = "raw numbers, as in the table";
  metadata["hc.input.row.units"] = "those of the table";
  metadata["hc.outputs"] = "probability";
  metadata["hc.output.probability.dtype"] = "float64";
  metadata["hc.output.probability.shape"] = "1";
  metadata["hc.output.probability.units"] = "probability of label 1, 0 to 1";
  metadata["hc.tie_rule"] = "label 1 if the probability is above 0.5";
}

// § 5.4: the normaliser that is folded into the weights; none is mean 0 and scale 1.
void AddNormaliser(const LinearModel& model, ModelFile& file) {
  const std::size_t num_features = model.weights.size();
  const bool none = model.feature_mean.empty() && model.feature_scale.empty();
  HC_CHECK(none || (model.feature_mean.size() == num_features &&
                    model.feature_scale.size() == num_features),
           num_features,
           model.feature_mean.size(),
           model.feature_scale.size());
  file.tensors["feature_mean"] =
      Vector(none ? std::vector<double>(num_features, 0.0) : model.feature_mean);
  file.tensors["feature_scale"] =
      Vector(none ? std::vector<double>(num_features, 1.0) : model.feature_scale);
}

// § 5.1, § 5.2: which numbers describe a pixel, and the filters themselves.
void AddFeatureSpec(const features::FeatureSpec& spec, ModelFile& file) {
  std::vector<std::int32_t> ids;
  std::vector<float> numbers;
  for (const features::Filter filter : spec.filters) {
    ids.push_back(static_cast<std::int32_t>(filter));
    for (const features::Kernel& component : features::KernelsOf(filter).components) {
      for (const auto& row : component) numbers.insert(numbers.end(), row.begin(), row.end());
    }
  }
  constexpr std::int64_t kSide = features::kKernelSize;
  file.tensors["filters"] = {std::move(numbers), {spec.NumFilters(), 2, kSide, kSide}};
  file.tensors["filter_ids"] = Vector(std::move(ids));
  file.tensors["window"] = Scalar<std::int32_t>(spec.window);
  file.tensors["energy"] = Scalar(static_cast<std::int32_t>(spec.energy));
  file.tensors["energy_offset"] = Scalar(features::kLogEnergyOffset);
  if (!spec.scales.empty()) {
    file.tensors["scales"] =
        Vector(std::vector<std::int32_t>(spec.scales.begin(), spec.scales.end()));
  }
  const std::string text = features::ToString(spec);
  Sha256 hash;
  hash.Update(text);
  file.metadata[std::string(format::kFeaturesKey)] = text;
  file.metadata[std::string(format::kFeaturesHashKey)] = hash.HexDigest();
}

// § 6.2: the mean row, and the rows one scale off it in turns, up first and down first.
void AddLogisticSelfTest(const LinearModel& model, ModelFile& file) {
  constexpr std::size_t kNumRows = 3;
  const std::size_t num_features = model.weights.size();
  const auto& mean = std::get<std::vector<double>>(file.tensors["feature_mean"].values);
  const auto& scale = std::get<std::vector<double>>(file.tensors["feature_scale"].values);
  const runtime::LogisticModel predictor{model.weights, model.intercept};
  std::vector<double> rows;
  std::vector<double> probabilities;
  for (std::size_t r = 0; r < kNumRows; ++r) {
    std::vector<double> row(mean);
    for (std::size_t i = 0; i < num_features && r > 0; ++i) {
      row[i] += (i + r) % 2 == 1 ? scale[i] : -scale[i];
    }
    probabilities.push_back(predictor.Probability(row));
    rows.insert(rows.end(), row.begin(), row.end());
  }
  file.tensors["selftest.input"] = {std::move(rows),
                                    {kNumRows, static_cast<std::int64_t>(num_features)}};
  file.tensors["selftest.output"] = Vector(std::move(probabilities));
  file.tensors["selftest.tolerance"] = Scalar(1e-9);
}

}  // namespace

ModelFile MakeGraspPointModel(const features::FeatureSpec& spec,
                              const LinearModel& model,
                              const Provenance& provenance) {
  const std::string_view fault = features::FaultOf(spec);
  HC_CHECK(fault.empty(), fault);
  HC_CHECK(model.weights.size() == static_cast<std::size_t>(spec.NumFeatures()),
           model.weights.size(),
           spec.NumFeatures());
  ModelFile file{.tensors = {}, .metadata = DescribeOrigin(provenance)};
  file.metadata[std::string(format::kKindKey)] = format::kGraspPointKind;
  file.metadata[std::string(format::kKindVersionKey)] = format::kKindVersion;
  DescribeImageInterface(file.metadata);
  AddFeatureSpec(spec, file);
  AddNormaliser(model, file);

  std::vector<float> weights(model.weights.begin(), model.weights.end());
  GraspPointSelfTest test = MakeGraspPointSelfTest(spec, weights, model.intercept);
  const std::int64_t height = test.picture.height();
  const std::int64_t width = test.picture.width();
  file.tensors["weights"] = Vector(std::move(weights));
  file.tensors["intercept"] = Scalar(model.intercept);
  file.tensors["selftest.input"] = {test.picture.values(), {height, width, 3}};
  file.tensors["selftest.output"] = {std::move(test.probabilities), {height, width}};
  file.tensors["selftest.tolerance"] = Scalar(test.tolerance);
  return file;
}

ModelFile MakeLogisticModel(const std::vector<std::string>& column_names,
                            const std::string& label_column,
                            const std::string& negative_label,
                            const std::string& positive_label,
                            const LinearModel& model,
                            const Provenance& provenance) {
  HC_CHECK(!column_names.empty() && column_names.size() == model.weights.size(),
           column_names.size(),
           model.weights.size());
  ModelFile file{.tensors = {}, .metadata = DescribeOrigin(provenance)};
  file.metadata[std::string(format::kKindKey)] = format::kLogisticKind;
  file.metadata[std::string(format::kKindVersionKey)] = format::kKindVersion;
  DescribeRowInterface(file.metadata);
  file.metadata["hc.label_column"] = label_column;
  file.metadata["hc.labels.0"] = negative_label;
  file.metadata["hc.labels.1"] = positive_label;
  file.tensors["weights"] = Vector(model.weights);
  file.tensors["intercept"] = Scalar(model.intercept);
  file.tensors["column_names"] = Vector(JoinColumnNames(column_names));
  AddNormaliser(model, file);
  AddLogisticSelfTest(model, file);
  return file;
}

}  // namespace handcraft::model_io
