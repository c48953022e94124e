// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// The functions of handcraft_runtime.h that predict on rows of numbers.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <new>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lib/runtime/aligned_buffer.h"
#include "lib/runtime/grasp_library_model.h"
#include "lib/runtime/handcraft_runtime.h"
#include "lib/runtime/logistic_model.h"
#include "lib/runtime/model_handle.h"
#include "lib/runtime/object_class_model.h"
#include "lib/runtime/svm_model.h"

namespace {

using handcraft::runtime::AlignedBuffer;
using handcraft::runtime::GraspLibraryModel;
using handcraft::runtime::LogisticModel;
using handcraft::runtime::ObjectClassModel;
using handcraft::runtime::SvmModel;

bool AreFinite(const double* row, size_t size) noexcept {
  return std::all_of(row, row + size, [](double x) { return std::isfinite(x); });
}

// Null for a kind without classes.
const std::vector<std::string>* ClassNamesOf(const hc_model* model) noexcept {
  if (model == nullptr) return nullptr;
  if (const SvmModel* svm = model->Svm()) return &svm->ClassNames();
  const auto* library = std::get_if<GraspLibraryModel>(&model->predictor);
  return library == nullptr ? nullptr : &library->class_names;
}

}  // namespace

hc_status hc_predict_row(const hc_model* model,
                         const double* row,
                         size_t size,
                         double* probability) {
  if (model == nullptr || row == nullptr || probability == nullptr) return HC_ERROR_ARGUMENT;
  const auto* logistic = std::get_if<LogisticModel>(&model->predictor);
  if (logistic == nullptr) return HC_ERROR_KIND;
  if (size != logistic->weights.size() || !AreFinite(row, size)) return HC_ERROR_ARGUMENT;
  *probability = logistic->Probability({row, size});
  return HC_OK;
}

size_t hc_model_num_classes(const hc_model* model) {
  const std::vector<std::string>* names = ClassNamesOf(model);
  return names == nullptr ? 0 : names->size();
}

const char* hc_model_class_name(const hc_model* model, size_t number) {
  if (number >= hc_model_num_classes(model)) return nullptr;
  return (*ClassNamesOf(model))[number].c_str();
}

hc_status hc_row_workspace_create(const hc_model* model, hc_workspace** workspace) {
  if (model == nullptr || workspace == nullptr) return HC_ERROR_ARGUMENT;
  *workspace = nullptr;
  const SvmModel* svm = model->Svm();
  if (svm == nullptr) return HC_ERROR_KIND;
  const auto* classes = std::get_if<ObjectClassModel>(&model->predictor);
  try {
    AlignedBuffer buffer(classes == nullptr ? svm->WorkspaceBytes() : classes->WorkspaceBytes());
    *workspace = new hc_workspace{std::move(buffer), 0, 0};
  } catch (const std::bad_alloc&) {
    return HC_ERROR_MEMORY;
  }
  return HC_OK;
}

hc_status hc_classify_row(const hc_model* model,
                          hc_workspace* workspace,
                          const double* row,
                          size_t size,
                          hc_class_prediction* prediction) {
  if (model == nullptr || workspace == nullptr || row == nullptr || prediction == nullptr) {
    return HC_ERROR_ARGUMENT;
  }
  const auto* svm = std::get_if<SvmModel>(&model->predictor);
  if (svm == nullptr) return HC_ERROR_KIND;
  if (size != svm->NumFeatures() || !AreFinite(row, size) ||
      svm->WorkspaceBytes() > workspace->buffer.Bytes().size()) {
    return HC_ERROR_ARGUMENT;
  }
  const SvmModel::Prediction found = svm->Predict({row, size}, workspace->buffer.Bytes());
  *prediction = {.number = static_cast<int32_t>(found.vote.winner),
                 .rejected = found.is_rejected ? 1 : 0,
                 .margin = found.vote.margin};
  return HC_OK;
}
