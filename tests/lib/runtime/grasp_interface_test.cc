// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "lib/runtime/handcraft_runtime.h"
#include "tests/lib/features/some_cloud.h"
#include "tests/lib/runtime/c_interface.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/allocation_counter.h"

namespace handcraft::testing {
namespace {

using features::testing::SomeCloud;

const double kNan = std::numeric_limits<double>::quiet_NaN();

SomeCloud UprightPatch() {
  SomeCloud cloud(20, 12);
  for (int v = 1; v < 11; ++v) {
    for (int u = 2; u < 18; ++u) cloud.Set(u, v, {0.3, 0.01 * u, 0.1 + 0.01 * v});
  }
  return cloud;
}

hc_cloud View(const SomeCloud& cloud) {
  return {cloud.points.data(),
          cloud.width,
          cloud.height,
          std::int64_t{3} * cloud.width,
          3,
          cloud.mask.data(),
          cloud.width};
}

constexpr hc_grasp_request kRequest = {1, 1, {0.3, 0.1, 0.15}};

TEST(FindGrasp, SaysHowToHoldTheObject) {
  const Model model = Load(SomeGraspLibraryModel());
  EXPECT_EQ(hc_model_kind(model.get()), HC_KIND_GRASP_LIBRARY);
  EXPECT_EQ(hc_model_num_classes(model.get()), 2U);
  EXPECT_EQ(std::string(hc_model_class_name(model.get(), 0)), "mug");
  EXPECT_EQ(hc_model_num_features(model.get()), 0U);
  EXPECT_EQ(std::string(hc_model_metadata(model.get(), "hc.joint_names")), "j1 j2");
  const Workspace workspace = MakeWorkspace(model, 20, 12);
  const SomeCloud patch = UprightPatch();
  const hc_cloud cloud = View(patch);
  hc_grasp grasp{};
  ASSERT_EQ(hc_find_grasp(model.get(), workspace.get(), &cloud, &kRequest, &grasp), HC_OK);
  const features::GraspLibrary library = features::testing::SomeGraspLibrary();
  features::ViewDescription view;
  std::vector<float> scratch(features::ObjectPlaneScratch(20, 12));
  ASSERT_EQ(features::DescribeView(patch.View(), scratch, view), features::CloudFault::kNone);
  const features::FoundGrasp expected = features::FindGrasp(
      library.Class(1), library.rule, view, {.point_m = {0.3, 0.1, 0.15}, .num_neighbours = 1});
  EXPECT_EQ(grasp.demonstration, expected.number);
  EXPECT_EQ(grasp.view, static_cast<int>(expected.view));
  EXPECT_EQ(grasp.distance_m, expected.distance_m);
  EXPECT_EQ(grasp.turn_rad, expected.turn_rad);
  EXPECT_EQ(grasp.object_angle_rad, expected.object_angle_rad);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(grasp.quaternion_xyzw[i], expected.rotation[i]);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(grasp.position_m[i], expected.position_m[i]);
}

TEST(FindGrasp, DoesNotAllocate) {
  const Model model = Load(SomeGraspLibraryModel());
  const Workspace workspace = MakeWorkspace(model, 20, 12);
  const SomeCloud patch = UprightPatch();
  const hc_cloud cloud = View(patch);
  const hc_grasp_request request{0, 32, {0.3, 0.1, 0.15}};
  hc_grasp grasp{};
  const AllocationCounter counter;
  const hc_status status = hc_find_grasp(model.get(), workspace.get(), &cloud, &request, &grasp);
  EXPECT_EQ(counter.Count(), 0U);
  EXPECT_EQ(status, HC_OK);
}

TEST(FindGrasp, RefusesWrongArguments) {
  const Model model = Load(SomeGraspLibraryModel());
  const Workspace workspace = MakeWorkspace(model, 20, 12);
  const SomeCloud patch = UprightPatch();
  const hc_cloud cloud = View(patch);
  hc_grasp grasp{};
  const auto status_of = [&](const hc_cloud& c, const hc_grasp_request& request) {
    return hc_find_grasp(model.get(), workspace.get(), &c, &request, &grasp);
  };
  EXPECT_EQ(status_of(cloud, kRequest), HC_OK);
  for (const hc_grasp_request& request : {hc_grasp_request{2, 1, {0, 0, 0}},  // unknown class
                                          hc_grasp_request{-1, 1, {0, 0, 0}},
                                          hc_grasp_request{0, 0, {0, 0, 0}},
                                          hc_grasp_request{0, 33, {0, 0, 0}},
                                          hc_grasp_request{0, 1, {0, kNan, 0}},
                                          hc_grasp_request{0, 1, {0, 0, 1e9}}}) {
    EXPECT_EQ(status_of(cloud, request), HC_ERROR_ARGUMENT);
  }
  hc_cloud wrong = cloud;
  wrong.points = nullptr;
  EXPECT_EQ(status_of(wrong, kRequest), HC_ERROR_ARGUMENT);
  wrong = cloud;
  wrong.row_stride = 59;
  EXPECT_EQ(status_of(wrong, kRequest), HC_ERROR_ARGUMENT);
  wrong = cloud;
  wrong.mask = nullptr;  // a picture full of object has no shape
  EXPECT_EQ(status_of(wrong, kRequest), HC_ERROR_ARGUMENT);
  wrong = cloud;
  wrong.mask_stride = 19;
  EXPECT_EQ(status_of(wrong, kRequest), HC_ERROR_ARGUMENT);
  wrong = cloud;
  wrong.width = 21;
  wrong.row_stride = 63;
  wrong.mask_stride = 21;
  EXPECT_EQ(status_of(wrong, kRequest), HC_ERROR_ARGUMENT);
  wrong = cloud;
  wrong.height = 0;
  EXPECT_EQ(status_of(wrong, kRequest), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_find_grasp(nullptr, workspace.get(), &cloud, &kRequest, &grasp), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_find_grasp(model.get(), nullptr, &cloud, &kRequest, &grasp), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_find_grasp(model.get(), workspace.get(), &cloud, &kRequest, nullptr),
            HC_ERROR_ARGUMENT);
}

TEST(FindGrasp, RefusesOtherKinds) {
  const Model svm = Load(SomeSvmModel());
  const Model library = Load(SomeGraspLibraryModel());
  const Workspace workspace = MakeWorkspace(library, 20, 12);
  const SomeCloud patch = UprightPatch();
  const hc_cloud cloud = View(patch);
  hc_grasp grasp{};
  EXPECT_EQ(hc_find_grasp(svm.get(), workspace.get(), &cloud, &kRequest, &grasp), HC_ERROR_KIND);
  hc_workspace* none = nullptr;
  EXPECT_EQ(hc_row_workspace_create(library.get(), &none), HC_ERROR_KIND);
}

TEST(FindGrasp, SaysThatACloudIsOfNoUse) {
  const Model model = Load(SomeGraspLibraryModel());
  const Workspace workspace = MakeWorkspace(model, 20, 12);
  SomeCloud two_points(20, 12);
  two_points.Set(3, 3, {0, 0, 0});
  two_points.Set(9, 3, {0.1, 0, 0});
  const hc_cloud cloud = View(two_points);
  hc_grasp grasp{};
  EXPECT_EQ(hc_find_grasp(model.get(), workspace.get(), &cloud, &kRequest, &grasp), HC_ERROR_CLOUD);
  EXPECT_EQ(std::string(hc_status_message(HC_ERROR_CLOUD)),
            "The object's cloud has too few points, or no plane that fits it best; look again.");
}

TEST(FindGrasp, ReadsRowsApart) {
  const Model model = Load(SomeGraspLibraryModel());
  const Workspace workspace = MakeWorkspace(model, 20, 12);
  const SomeCloud patch = UprightPatch();
  std::vector<float> points(12 * 100, 1.0F);
  std::vector<std::uint8_t> mask(12 * 64, 1);
  for (std::size_t v = 0; v < 12; ++v) {
    std::copy_n(patch.points.data() + 60 * v, 60, points.data() + 100 * v);
    std::copy_n(patch.mask.data() + 20 * v, 20, mask.data() + 64 * v);
  }
  const hc_cloud packed = View(patch);
  const hc_cloud apart{points.data(), 20, 12, 100, 3, mask.data(), 64};
  hc_grasp a{};
  hc_grasp b{};
  ASSERT_EQ(hc_find_grasp(model.get(), workspace.get(), &packed, &kRequest, &a), HC_OK);
  ASSERT_EQ(hc_find_grasp(model.get(), workspace.get(), &apart, &kRequest, &b), HC_OK);
  EXPECT_EQ(a.distance_m, b.distance_m);
  EXPECT_EQ(a.quaternion_xyzw[2], b.quaternion_xyzw[2]);
}

TEST(FindGrasp, IsTheSameFromManyThreads) {
  const Model model = Load(SomeGraspLibraryModel());
  const SomeCloud patch = UprightPatch();
  const hc_cloud cloud = View(patch);
  std::vector<hc_grasp> grasps(4);
  std::vector<std::thread> threads;
  threads.reserve(grasps.size());
  for (hc_grasp& grasp : grasps) {
    threads.emplace_back([&model, &cloud, &grasp] {
      const Workspace workspace = MakeWorkspace(model, 20, 12);
      for (int i = 0; i < 50; ++i) {
        static_cast<void>(hc_find_grasp(model.get(), workspace.get(), &cloud, &kRequest, &grasp));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const hc_grasp& grasp : grasps) EXPECT_EQ(grasp.distance_m, grasps[0].distance_m);
}

}  // namespace
}  // namespace handcraft::testing
