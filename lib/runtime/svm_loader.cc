// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/svm_loader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lib/runtime/content_reader.h"

namespace handcraft::runtime {

bool RequireWithin(ContentReader& reader,
                   const char* tensor,
                   std::int32_t value,
                   std::int32_t low,
                   std::size_t high,
                   std::size_t entry) {
  if (value >= low && static_cast<std::size_t>(value) <= high) return true;
  return reader.Fail(MakeError(HC_ERROR_CONTENT,
                               reader.OffsetOf(tensor) + entry * sizeof(std::int32_t),
                               "entry %zu of the tensor '%s' is %d; a number from %d to %zu was "
                               "expected",
                               entry,
                               tensor,
                               value,
                               low,
                               high));
}

bool SvmLoader::Read() {
  return ReadKernel() && ReadNames() && ReadSupportVectors() && ReadMachines() && ReadThreshold();
}

bool SvmLoader::ReadKernel() {
  constexpr std::size_t kMaxDegree = 1000;
  std::int32_t type = 0;
  std::int32_t degree = 0;
  std::int32_t scheme = 0;
  features::Similarity& similarity = model_.similarity_;
  if (!reader_.ReadOne("kernel", type) || !RequireWithin(reader_, "kernel", type, 0, 2) ||
      !reader_.ReadOne("kernel_degree", degree) ||
      !RequireWithin(reader_, "kernel_degree", degree, 1, kMaxDegree) ||
      !reader_.ReadOne("kernel_gamma", similarity.gamma) ||
      !reader_.ReadOne("kernel_coef0", similarity.coef0) || !reader_.ReadOne("scheme", scheme) ||
      !RequireWithin(reader_, "scheme", scheme, 0, 1)) {
    return false;
  }
  similarity.type = static_cast<features::SimilarityType>(type);
  similarity.degree = degree;
  model_.scheme_ = static_cast<features::ClassScheme>(scheme);
  if (similarity.gamma > 0.0) return true;
  return reader_.Fail(MakeError(HC_ERROR_CONTENT,
                                reader_.OffsetOf("kernel_gamma"),
                                "the tensor 'kernel_gamma' holds %g; a number above 0 was expected",
                                similarity.gamma));
}

// The number of columns and of classes is that of feature_mean and class_counts.
bool SvmLoader::ReadNames() {
  std::int32_t num_classes = 0;
  constexpr std::size_t kMaxClasses = 4096;
  if (!reader_.Read("feature_mean", {kAnyLength}, model_.feature_mean_) ||
      !reader_.CheckNormaliser(model_.feature_mean_.size()) ||
      !reader_.Read("feature_scale", {model_.feature_mean_.size()}, model_.feature_scale_) ||
      !reader_.ReadOne("num_classes", num_classes) ||
      !RequireWithin(reader_, "num_classes", num_classes, 2, kMaxClasses)) {
    return false;
  }
  return reader_.ReadNames(
      "class_names", static_cast<std::size_t>(num_classes), "classes", model_.class_names_);
}

template <class T>
bool SvmLoader::ReadRows() {
  const std::size_t num_features = model_.NumFeatures();
  std::vector<T> values;
  if (!reader_.Read("support_vectors", {kAnyLength, num_features}, values)) return false;
  const std::size_t num_rows = values.size() / num_features;
  const std::size_t stride = features::PaddedLength(num_features);
  SupportVectors<T> support{AlignedBuffer(num_rows * stride * sizeof(T)), {}};
  T* rows = reinterpret_cast<T*>(support.buffer.Bytes().data());
  std::fill(rows, rows + num_rows * stride, T{0});
  for (std::size_t v = 0; v < num_rows; ++v) {
    std::copy_n(values.data() + v * num_features, num_features, rows + v * stride);
  }
  support.rows = {.data = rows, .num_rows = num_rows, .stride = stride};
  model_.squared_norms_.resize(num_rows);
  for (std::size_t v = 0; v < num_rows; ++v) {
    features::InnerProducts(features::PaddedRows<T>{support.rows.Row(v), 1, stride},
                            support.rows.Row(v),
                            {&model_.squared_norms_[v], 1});
  }
  model_.support_ = std::move(support);
  return true;
}

bool SvmLoader::ReadSupportVectors() {
  const TensorView* tensor = reader_.Find("support_vectors");
  const bool is_single = tensor != nullptr && tensor->dtype == format::Dtype::kF32;
  if (!(is_single ? ReadRows<float>() : ReadRows<double>())) return false;
  std::vector<std::int32_t> classes;
  if (!reader_.Read("support_classes", {model_.squared_norms_.size()}, classes)) return false;
  for (std::size_t v = 0; v < classes.size(); ++v) {
    if (!RequireWithin(
            reader_, "support_classes", classes[v], 0, model_.class_names_.size() - 1, v)) {
      return false;
    }
  }
  return true;
}

bool SvmLoader::ReadMachines() {
  const std::size_t num_machines =
      features::NumMachines(model_.scheme_, model_.class_names_.size());
  std::vector<std::int32_t>& begins = model_.machine_begins_;
  std::vector<std::int32_t>& supports = model_.machine_supports_;
  if (!reader_.Read("intercepts", {num_machines}, model_.intercepts_) ||
      !reader_.Read("machine_begins", {num_machines + 1}, begins) ||
      !reader_.Read("machine_supports", {kAnyLength}, supports) ||
      !reader_.Read("dual_coefficients", {supports.size()}, model_.dual_coefficients_) ||
      !RequireWithin(reader_, "machine_begins", begins[0], 0, 0)) {
    return false;
  }
  for (std::size_t m = 0; m < num_machines; ++m) {
    const std::size_t low =
        m + 1 == num_machines ? supports.size() : static_cast<std::size_t>(begins[m]);
    if (!RequireWithin(reader_,
                       "machine_begins",
                       begins[m + 1],
                       static_cast<std::int32_t>(low),
                       supports.size(),
                       m + 1)) {
      return false;
    }
  }
  for (std::size_t k = 0; k < supports.size(); ++k) {
    if (!RequireWithin(
            reader_, "machine_supports", supports[k], 0, model_.squared_norms_.size() - 1, k)) {
      return false;
    }
  }
  return true;
}

bool SvmLoader::ReadThreshold() {
  if (reader_.Find("rejection_threshold") == nullptr) return true;
  return reader_.ReadOne("rejection_threshold", model_.rejection_threshold_.emplace());
}

namespace {

// § 9.2: rows, one after another, and the values of each.
struct SelfTest {
  std::vector<double> rows;
  std::vector<double> decisions;
  double tolerance = 0.0;
};

bool ReadSelfTest(ContentReader& reader, const SvmModel& model, SelfTest& test) {
  return reader.Read("selftest.input", {kAnyLength, model.NumFeatures()}, test.rows) &&
         reader.Read("selftest.output",
                     {test.rows.size() / model.NumFeatures(), model.NumMachines()},
                     test.decisions) &&
         ReadSelfTestTolerance(reader, test.tolerance);
}

}  // namespace

bool ReadSelfTestTolerance(ContentReader& reader, double& tolerance) {
  if (!reader.ReadOne("selftest.tolerance", tolerance)) return false;
  if (tolerance > 0.0 && tolerance <= 1e-3) return true;
  return reader.Fail(MakeError(HC_ERROR_CONTENT,
                               reader.OffsetOf("selftest.tolerance"),
                               "the tensor 'selftest.tolerance' holds %g; above 0 and at most "
                               "0.001 was expected",
                               tolerance));
}

std::optional<ModelError> CheckSelfTestRow(const SvmModel& model,
                                           std::span<const double> expected,
                                           double tolerance,
                                           std::size_t row,
                                           std::span<std::byte> workspace) {
  const std::span<const double> decisions = model.Decisions(workspace);
  for (std::size_t m = 0; m < decisions.size(); ++m) {
    // A NaN fails as well.
    if (std::fabs(decisions[m] - expected[m]) <= tolerance * model.Magnitude(m, workspace))
      continue;
    return MakeError(HC_ERROR_SELF_TEST,
                     kNoOffset,
                     "the self-test gives %.17g for machine %zu on row %zu where the model stores "
                     "%.17g; train it again with this version of Handcraft",
                     decisions[m],
                     m,
                     row,
                     expected[m]);
  }
  return std::nullopt;
}

Result<SvmModel> LoadSvmModel(const ParsedModel& parsed) {
  ContentReader reader(parsed);
  SvmModel model;
  SelfTest test;
  std::vector<std::string> columns;  // for people and table readers
  const bool complete = SvmLoader(reader, model).Read() &&
                        reader.ReadNames("column_names", model.NumFeatures(), "columns", columns) &&
                        ReadSelfTest(reader, model, test) && reader.RefuseUnknownTensors();
  if (!complete) return reader.error();
  const AlignedBuffer workspace(model.WorkspaceBytes());
  const std::size_t p = model.NumFeatures();
  const std::size_t m = model.NumMachines();
  for (std::size_t r = 0; r * p < test.rows.size(); ++r) {
    static_cast<void>(model.Predict(std::span(test.rows).subspan(r * p, p), workspace.Bytes()));
    const auto expected = std::span(test.decisions).subspan(r * m, m);
    if (const auto error =
            CheckSelfTestRow(model, expected, test.tolerance, r, workspace.Bytes())) {
      return *error;
    }
  }
  return model;
}

}  // namespace handcraft::runtime
