// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <string>
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

class ClassifyCloud : public ::testing::Test {
 protected:
  hc_status Classify(const hc_cloud& cloud) {
    return hc_classify_cloud(model_.get(), workspace_.get(), &cloud, &prediction_, values_);
  }
  [[nodiscard]] hc_cloud Cloud() const { return {points_.data(), 2, 2, 6, 3, nullptr, 0}; }

  Model model_ = Load(SomeObjectClassModel());
  Workspace workspace_ = MakeRowWorkspace(model_);
  std::vector<float> points_ = {1, 0, 0, 3, 1, 0, 2, 0, 1, 2, 1, 1};  // F = (−1, 1, 0, 0)
  hc_class_prediction prediction_{};
  double values_[3] = {};
};

TEST_F(ClassifyCloud, ByHand) {
  EXPECT_EQ(hc_model_kind(model_.get()), HC_KIND_OBJECT_CLASS);
  EXPECT_EQ(hc_model_num_features(model_.get()), 4U);
  EXPECT_EQ(hc_model_num_classes(model_.get()), 3U);
  EXPECT_EQ(hc_model_num_machines(model_.get()), 3U);
  EXPECT_EQ(std::string(hc_model_class_name(model_.get(), 1)), "mug");
  ASSERT_EQ(Classify(Cloud()), HC_OK);
  EXPECT_EQ(prediction_.number, 1);
  EXPECT_EQ(prediction_.rejected, 0);
  EXPECT_EQ(prediction_.margin, 1.0);
  EXPECT_EQ(values_[0], -2.0);
  EXPECT_EQ(values_[1], -1.0);
  EXPECT_EQ(values_[2], 1.0);
  const hc_cloud cloud = Cloud();
  EXPECT_EQ(hc_classify_cloud(model_.get(), workspace_.get(), &cloud, &prediction_, nullptr),
            HC_OK);
}

TEST_F(ClassifyCloud, SaysWhenItIsNoneOfTheClasses) {
  model_io::ObjectClassModel made = SomeObjectClasses();
  made.svm.rejection_threshold = 1.5;
  model_ = Load(SomeObjectClassModel(made));
  workspace_ = MakeRowWorkspace(model_);
  ASSERT_EQ(Classify(Cloud()), HC_OK);
  EXPECT_EQ(prediction_.number, 1);
  EXPECT_EQ(prediction_.rejected, 1);
}

TEST_F(ClassifyCloud, OfTwoPointsEmptyOrNotMeasuredIsAStatus) {
  const std::uint8_t two[] = {255, 0, 255, 0};
  hc_cloud cloud = Cloud();
  cloud.mask = two;
  cloud.mask_stride = 2;
  EXPECT_EQ(Classify(cloud), HC_ERROR_CLOUD);
  EXPECT_STREQ(hc_status_message(HC_ERROR_CLOUD),
               "The object's cloud has too few points, or no plane that fits it best; look again.");
  const std::uint8_t none[] = {0, 0, 0, 0};
  cloud.mask = none;
  EXPECT_EQ(Classify(cloud), HC_ERROR_CLOUD);
  points_.assign(12, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(Classify(Cloud()), HC_ERROR_CLOUD);
}

TEST_F(ClassifyCloud, TakesAnyFloat) {
  constexpr float kBad[] = {std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::max(),
                            1e6F,
                            -1e6F,
                            std::numeric_limits<float>::denorm_min()};
  const SomeObject object(12, 10);
  for (const float bad : kBad) {
    SomeObject broken = object;
    for (std::size_t i = 0; i < broken.points.size(); i += 5) broken.points[i] = bad;
    ASSERT_EQ(Classify({broken.points.data(), 12, 10, 36, 3, broken.mask.data(), 12}), HC_OK);
    for (const double value : values_) EXPECT_TRUE(std::isfinite(value)) << bad;
  }
}

TEST_F(ClassifyCloud, DoesNotAllocate) {
  const hc_cloud cloud = Cloud();
  const AllocationCounter counter;
  const hc_status status = Classify(cloud);
  EXPECT_EQ(counter.Count(), 0U);
  EXPECT_EQ(status, HC_OK);
}

TEST_F(ClassifyCloud, RefusesWrongArguments) {
  const auto refused = [this](void (*change)(hc_cloud&)) {
    hc_cloud cloud = Cloud();
    change(cloud);
    EXPECT_EQ(Classify(cloud), HC_ERROR_ARGUMENT);
  };
  refused([](hc_cloud& cloud) { cloud.points = nullptr; });
  refused([](hc_cloud& cloud) { cloud.width = 0; });
  refused([](hc_cloud& cloud) { cloud.height = -1; });
  refused([](hc_cloud& cloud) { cloud.height = INT32_MAX; });
  refused([](hc_cloud& cloud) { cloud.row_stride = 5; });
  refused([](hc_cloud& cloud) { cloud.row_stride = INT64_MAX; });
  refused([](hc_cloud& cloud) { cloud.point_stride = 2; });
  refused([](hc_cloud& cloud) {
    static const std::uint8_t kMask[4] = {1, 1, 1, 1};
    cloud.mask = kMask;
    cloud.mask_stride = 1;
  });
  const hc_cloud cloud = Cloud();
  hc_model* model = model_.get();
  hc_workspace* workspace = workspace_.get();
  EXPECT_EQ(hc_classify_cloud(nullptr, workspace, &cloud, &prediction_, values_),
            HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_classify_cloud(model, nullptr, &cloud, &prediction_, values_), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_classify_cloud(model, workspace, nullptr, &prediction_, values_), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_classify_cloud(model, workspace, &cloud, nullptr, values_), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_model_num_machines(nullptr), 0U);
}

TEST_F(ClassifyCloud, RefusesOtherKindsAndTheirWorkspaces) {
  const Model rows = Load(SomeSvmModel());
  const Workspace row_workspace = MakeRowWorkspace(rows);
  const hc_cloud cloud = Cloud();
  EXPECT_EQ(hc_classify_cloud(rows.get(), row_workspace.get(), &cloud, &prediction_, nullptr),
            HC_ERROR_KIND);
  EXPECT_EQ(hc_classify_cloud(model_.get(), row_workspace.get(), &cloud, &prediction_, nullptr),
            HC_ERROR_ARGUMENT);
  const double row[] = {1.0, 2.0, 3.0, 4.0};
  EXPECT_EQ(hc_classify_row(model_.get(), workspace_.get(), row, 4, &prediction_), HC_ERROR_KIND);
}

}  // namespace
}  // namespace handcraft::testing
