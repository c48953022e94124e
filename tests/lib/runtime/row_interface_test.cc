// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "lib/runtime/handcraft_runtime.h"
#include "tests/lib/runtime/c_interface.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/allocation_counter.h"

namespace handcraft::testing {
namespace {

Workspace MakeRowWorkspace(const Model& model) {
  hc_workspace* workspace = nullptr;
  EXPECT_EQ(hc_row_workspace_create(model.get(), &workspace), HC_OK);
  return Workspace(workspace);
}

TEST(ClassifyRow, ByHand) {
  const Model model = Load(SomeSvmModel());
  EXPECT_EQ(hc_model_kind(model.get()), HC_KIND_SVM);
  EXPECT_EQ(hc_model_num_features(model.get()), 2U);
  EXPECT_EQ(hc_model_num_classes(model.get()), 3U);
  EXPECT_EQ(std::string(hc_model_class_name(model.get(), 2)), "drill");
  EXPECT_EQ(hc_model_class_name(model.get(), 3), nullptr);
  const Workspace workspace = MakeRowWorkspace(model);
  const double row[] = {2.5, 1.5};
  hc_class_prediction prediction{};
  ASSERT_EQ(hc_classify_row(model.get(), workspace.get(), row, 2, &prediction), HC_OK);
  EXPECT_EQ(prediction.number, 0);
  EXPECT_EQ(prediction.rejected, 0);
  EXPECT_EQ(prediction.margin, 1.0);
}

TEST(ClassifyRow, SaysWhenItIsNoneOfTheClasses) {
  model_io::SvmModel made = SomeSvm();
  made.rejection_threshold = 1.5;
  const Model model = Load(SomeSvmModel(made));
  const Workspace workspace = MakeRowWorkspace(model);
  const double row[] = {2.5, 1.5};
  hc_class_prediction prediction{};
  ASSERT_EQ(hc_classify_row(model.get(), workspace.get(), row, 2, &prediction), HC_OK);
  EXPECT_EQ(prediction.number, 0);
  EXPECT_EQ(prediction.rejected, 1);
}

TEST(ClassifyRow, DoesNotAllocate) {
  const Model model = Load(SomeSvmModel());
  const Workspace workspace = MakeRowWorkspace(model);
  const double row[] = {2.5, 1.5};
  hc_class_prediction prediction{};
  const AllocationCounter counter;
  const hc_status status = hc_classify_row(model.get(), workspace.get(), row, 2, &prediction);
  EXPECT_EQ(counter.Count(), 0U);
  EXPECT_EQ(status, HC_OK);
}

TEST(ClassifyRow, RefusesWrongArguments) {
  const Model model = Load(SomeSvmModel());
  const Workspace workspace = MakeRowWorkspace(model);
  const double row[] = {2.5, 1.5, 0.0};
  const double wrong[] = {2.5, std::numeric_limits<double>::quiet_NaN()};
  hc_class_prediction prediction{};
  const auto classify = [&](const double* numbers, std::size_t size) {
    return hc_classify_row(model.get(), workspace.get(), numbers, size, &prediction);
  };
  EXPECT_EQ(classify(row, 1), HC_ERROR_ARGUMENT);
  EXPECT_EQ(classify(row, 3), HC_ERROR_ARGUMENT);
  EXPECT_EQ(classify(wrong, 2), HC_ERROR_ARGUMENT);
  EXPECT_EQ(classify(nullptr, 2), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_classify_row(nullptr, workspace.get(), row, 2, &prediction), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_classify_row(model.get(), nullptr, row, 2, &prediction), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_classify_row(model.get(), workspace.get(), row, 2, nullptr), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_row_workspace_create(model.get(), nullptr), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_model_num_classes(nullptr), 0U);
  EXPECT_EQ(hc_model_class_name(nullptr, 0), nullptr);
}

TEST(ClassifyRow, RefusesOtherKindsAndTheWorkspacesOfSmallerModels) {
  const Model logistic = Load(SomeLogisticModel());
  const Model model = Load(SomeSvmModel());
  const Workspace small = MakeRowWorkspace(model);
  hc_workspace* none = nullptr;
  EXPECT_EQ(hc_row_workspace_create(logistic.get(), &none), HC_ERROR_KIND);
  EXPECT_EQ(hc_workspace_create(model.get(), 10, 10, &none), HC_ERROR_KIND);
  const double row[] = {2.5, 1.5};
  hc_class_prediction prediction{};
  EXPECT_EQ(hc_classify_row(logistic.get(), small.get(), row, 2, &prediction), HC_ERROR_KIND);
  double probability = 0.0;
  EXPECT_EQ(hc_predict_row(model.get(), row, 2, &probability), HC_ERROR_KIND);
  EXPECT_EQ(hc_model_num_classes(logistic.get()), 0U);

  model_io::SvmModel made = SomeSvm();
  made.support_vectors.resize(2 * 40, 0.5);
  made.support_classes.resize(40, 2);
  const Model larger = Load(SomeSvmModel(made));
  EXPECT_EQ(hc_classify_row(larger.get(), small.get(), row, 2, &prediction), HC_ERROR_ARGUMENT);
}

}  // namespace
}  // namespace handcraft::testing
