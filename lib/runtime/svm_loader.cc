// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/svm_loader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "lib/runtime/content_reader.h"

namespace handcraft::runtime {

/// Takes a support vector machine out of a parsed file, part by part.
class SvmLoader {
 public:
  explicit SvmLoader(const ParsedModel& parsed) noexcept : reader_(parsed) {}

  Result<SvmModel> Load() {
    const bool complete = ReadKernel() && ReadNames() && ReadSupportVectors() && ReadMachines() &&
                          ReadThreshold() && ReadSelfTest() && reader_.RefuseUnknownTensors();
    if (!complete) return reader_.error();
    if (const std::optional<ModelError> error = RunSelfTest()) return *error;
    return std::move(model_);
  }

 private:
  bool ReadKernel();
  bool ReadNames();
  bool ReadSupportVectors();
  template <class T>
  bool ReadRows();
  bool ReadMachines();
  bool ReadThreshold();
  bool ReadSelfTest();
  std::optional<ModelError> RunSelfTest();

  // Refuses a number of an I32 tensor outside [low, high].
  bool RequireWithin(const char* tensor,
                     std::int32_t value,
                     std::int32_t low,
                     std::size_t high,
                     std::size_t entry = 0);

  ContentReader reader_;
  SvmModel model_;
  std::vector<double> test_rows_;
  std::vector<double> test_decisions_;
  double test_tolerance_ = 0.0;
};

bool SvmLoader::RequireWithin(
    const char* tensor, std::int32_t value, std::int32_t low, std::size_t high, std::size_t entry) {
  if (value >= low && static_cast<std::size_t>(value) <= high) return true;
  return reader_.Fail(MakeError(HC_ERROR_CONTENT,
                                reader_.OffsetOf(tensor) + entry * sizeof(std::int32_t),
                                "entry %zu of the tensor '%s' is %d; a number from %d to %zu was "
                                "expected",
                                entry,
                                tensor,
                                value,
                                low,
                                high));
}

bool SvmLoader::ReadKernel() {
  constexpr std::size_t kMaxDegree = 1000;
  std::int32_t type = 0;
  std::int32_t degree = 0;
  std::int32_t scheme = 0;
  features::Similarity& similarity = model_.similarity_;
  if (!reader_.ReadOne("kernel", type) || !RequireWithin("kernel", type, 0, 2) ||
      !reader_.ReadOne("kernel_degree", degree) ||
      !RequireWithin("kernel_degree", degree, 1, kMaxDegree) ||
      !reader_.ReadOne("kernel_gamma", similarity.gamma) ||
      !reader_.ReadOne("kernel_coef0", similarity.coef0) || !reader_.ReadOne("scheme", scheme) ||
      !RequireWithin("scheme", scheme, 0, 1)) {
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
  std::vector<std::string> columns;  // for people and table readers
  constexpr std::size_t kMaxClasses = 4096;
  if (!reader_.Read("feature_mean", {kAnyLength}, model_.feature_mean_) ||
      !reader_.CheckNormaliser(model_.feature_mean_.size()) ||
      !reader_.Read("feature_scale", {model_.feature_mean_.size()}, model_.feature_scale_) ||
      !reader_.ReadOne("num_classes", num_classes) ||
      !RequireWithin("num_classes", num_classes, 2, kMaxClasses)) {
    return false;
  }
  return reader_.ReadNames("class_names",
                           static_cast<std::size_t>(num_classes),
                           "classes",
                           model_.class_names_) &&
         reader_.ReadNames("column_names", model_.feature_mean_.size(), "columns", columns);
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
    if (!RequireWithin("support_classes", classes[v], 0, model_.class_names_.size() - 1, v)) {
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
      !RequireWithin("machine_begins", begins[0], 0, 0)) {
    return false;
  }
  for (std::size_t m = 0; m < num_machines; ++m) {
    const std::size_t low =
        m + 1 == num_machines ? supports.size() : static_cast<std::size_t>(begins[m]);
    if (!RequireWithin("machine_begins",
                       begins[m + 1],
                       static_cast<std::int32_t>(low),
                       supports.size(),
                       m + 1)) {
      return false;
    }
  }
  for (std::size_t k = 0; k < supports.size(); ++k) {
    if (!RequireWithin("machine_supports", supports[k], 0, model_.squared_norms_.size() - 1, k)) {
      return false;
    }
  }
  return true;
}

bool SvmLoader::ReadThreshold() {
  if (reader_.Find("rejection_threshold") == nullptr) return true;
  return reader_.ReadOne("rejection_threshold", model_.rejection_threshold_.emplace());
}

bool SvmLoader::ReadSelfTest() {
  if (!reader_.Read("selftest.input", {kAnyLength, model_.NumFeatures()}, test_rows_) ||
      !reader_.Read("selftest.output",
                    {test_rows_.size() / model_.NumFeatures(), model_.NumMachines()},
                    test_decisions_) ||
      !reader_.ReadOne("selftest.tolerance", test_tolerance_)) {
    return false;
  }
  if (test_tolerance_ > 0.0 && test_tolerance_ <= 1e-3) return true;
  return reader_.Fail(MakeError(HC_ERROR_CONTENT,
                                reader_.OffsetOf("selftest.tolerance"),
                                "the tensor 'selftest.tolerance' holds %g; above 0 and at most "
                                "0.001 was expected",
                                test_tolerance_));
}

std::optional<ModelError> SvmLoader::RunSelfTest() {
  const AlignedBuffer workspace(model_.WorkspaceBytes());
  const std::size_t num_features = model_.NumFeatures();
  const std::size_t num_machines = model_.NumMachines();
  for (std::size_t r = 0; r * num_features < test_rows_.size(); ++r) {
    const std::span<const double> decisions =
        model_.Decide(std::span<const double>(test_rows_).subspan(r * num_features, num_features),
                      workspace.Bytes());
    for (std::size_t m = 0; m < num_machines; ++m) {
      const double expected = test_decisions_[r * num_machines + m];
      const double magnitude = model_.Magnitude(m, workspace.Bytes());
      // A NaN fails as well.
      if (std::fabs(decisions[m] - expected) <= test_tolerance_ * magnitude) continue;
      return MakeError(
          HC_ERROR_SELF_TEST,
          kNoOffset,
          "the self-test gives %.17g for machine %zu on row %zu where the model stores "
          "%.17g; train it again with this version of Handcraft",
          decisions[m],
          m,
          r,
          expected);
    }
  }
  return std::nullopt;
}

Result<SvmModel> LoadSvmModel(const ParsedModel& parsed) { return SvmLoader(parsed).Load(); }

}  // namespace handcraft::runtime
