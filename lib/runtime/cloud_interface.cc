// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// The functions of handcraft_runtime.h that predict on point clouds.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

#include "lib/runtime/cloud_view.h"
#include "lib/runtime/handcraft_runtime.h"
#include "lib/runtime/model_handle.h"
#include "lib/runtime/object_class_model.h"

namespace {

using handcraft::runtime::IsCloud;
using handcraft::runtime::ObjectClassModel;
using handcraft::runtime::SvmModel;

}  // namespace

size_t hc_model_num_machines(const hc_model* model) {
  const SvmModel* svm = model == nullptr ? nullptr : model->Svm();
  return svm == nullptr ? 0 : svm->NumMachines();
}

hc_status hc_classify_cloud(const hc_model* model,
                            hc_workspace* workspace,
                            const hc_cloud* cloud,
                            hc_class_prediction* prediction,
                            double* decision_values) {
  if (model == nullptr || workspace == nullptr || cloud == nullptr || prediction == nullptr) {
    return HC_ERROR_ARGUMENT;
  }
  const auto* classes = std::get_if<ObjectClassModel>(&model->predictor);
  if (classes == nullptr) return HC_ERROR_KIND;
  const std::span<std::byte> scratch = workspace->buffer.Bytes();
  if (!IsCloud(*cloud) || classes->WorkspaceBytes() > scratch.size()) return HC_ERROR_ARGUMENT;
  const std::optional<SvmModel::Prediction> found =
      classes->Predict(handcraft::runtime::ViewOf(*cloud), scratch);
  if (!found) return HC_ERROR_CLOUD;
  *prediction = {.number = static_cast<int32_t>(found->vote.winner),
                 .rejected = found->is_rejected ? 1 : 0,
                 .margin = found->vote.margin};
  if (decision_values != nullptr) {
    const std::span<const double> values = classes->svm.Decisions(scratch);
    std::copy(values.begin(), values.end(), decision_values);
  }
  return HC_OK;
}
