// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/grasp_library_model.h"

#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/runtime/model_parser.h"
#include "tests/lib/features/some_cloud.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/lib/runtime/stored_model.h"

namespace handcraft::runtime {
namespace {

using features::testing::SomeCloud;
using model_io::ModelFile;

Result<GraspLibraryModel> Load(const ModelFile& model) {
  return testing::LoadStored<&LoadGraspLibrary>(model);
}

void ExpectRefused(const std::function<void(ModelFile&)>& change,
                   const std::string& message,
                   hc_status status = HC_ERROR_CONTENT) {
  testing::ExpectRefusal<&LoadGraspLibrary>(
      testing::SomeGraspLibraryModel(), change, message, status);
}

// Sets an entry of a tensor.
template <class T>
std::function<void(ModelFile&)> Set(const std::string& name, std::size_t entry, T value) {
  return [=](ModelFile& model) { testing::In<T>(model, name)[entry] = value; };
}

SomeCloud UprightPatch() {
  SomeCloud cloud(20, 12);
  for (int v = 1; v < 11; ++v) {
    for (int u = 2; u < 18; ++u) cloud.Set(u, v, {0.3, 0.01 * u, 0.1 + 0.01 * v});
  }
  return cloud;
}

TEST(LoadGraspLibrary, KeepsEverything) {
  const auto model = Load(testing::SomeGraspLibraryModel());
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->class_names, (std::vector<std::string>{"mug", "drill"}));
  const features::GraspLibrary expected = features::testing::SomeGraspLibrary();
  EXPECT_EQ(model->library.view_begins, expected.view_begins);
  EXPECT_EQ(model->library.view_normals, expected.view_normals);
  EXPECT_EQ(model->library.moment_scales, expected.moment_scales);
  EXPECT_EQ(model->library.positions_m, expected.positions_m);
  EXPECT_EQ(model->library.rotations, expected.rotations);
  EXPECT_EQ(model->library.numbers, expected.numbers);
  EXPECT_EQ(model->library.rejection_distance_m, expected.rejection_distance_m);
}

TEST(LoadGraspLibrary, RefusesEachMissingTensor) {
  const ModelFile whole = testing::SomeGraspLibraryModel();
  EXPECT_EQ(whole.tensors.size(), 23U);
  for (const auto& entry : whole.tensors) {
    const std::string& name = entry.first;
    if (name == "rejection_distance") continue;
    ExpectRefused([&](ModelFile& model) { model.tensors.erase(name); },
                  "the tensor '" + name + "' ");
  }
  ModelFile without = whole;
  without.tensors.erase("rejection_distance");
  EXPECT_TRUE(Load(without));
}

TEST(LoadGraspLibrary, RefusesNumbersOutOfRange) {
  ExpectRefused(Set<std::int32_t>("compared_moments", 0, 3), "is 3; 0, 1 or 2 was expected");
  ExpectRefused(Set<std::int32_t>("num_candidates", 0, 65), "a number from 0 to 64");
  ExpectRefused(Set<double>("angle_weight", 0, -1.0), "a number from 0 to 1e6");
  ExpectRefused(Set<std::int32_t>("num_classes", 0, 0), "a number from 1 to 4096");
  ExpectRefused(Set<std::int32_t>("view_begins", 0, 1), "entry 0 of the tensor 'view_begins' is 1");
  ExpectRefused(Set<std::int32_t>("pose_begins", 2, 20),
                "entry 2 of the tensor 'pose_begins' is 20; more than the entry before");
  ExpectRefused(Set<double>("view_angles", 3, 6.3), "'view_angles' is 6.3; an angle of 0 or more");
  ExpectRefused(Set<double>("shown_angles", 0, -0.1), "'shown_angles' is -0.1; an angle");
  ExpectRefused(Set<double>("view_normals", 4, 0.9), "a row of length 1");
  ExpectRefused(Set<double>("rotations", 7, 0.9), "a row of length 1");
  ExpectRefused(Set<double>("view_moments", 8, 0.0), "an area above 0");
  ExpectRefused(Set<double>("moment_scales", 5, 0.0), "a number above 0");
  ExpectRefused(Set<double>("shown_means", 1, 101.0), "at most 100 m");
  ExpectRefused(Set<double>("positions", 1, -101.0), "at most 100 m");
  ExpectRefused(Set<std::int32_t>("demonstration_numbers", 9, -1), "0 or more");
  ExpectRefused(Set<double>("rejection_distance", 0, 0.0), "a distance above 0");
  ExpectRefused(Set<double>("selftest.tolerance", 0, 0.01), "above 0 and at most 0.001");
}

TEST(LoadGraspLibrary, RefusesContradictions) {
  ExpectRefused(Set<std::int32_t>("num_classes", 0, 3), "holds 2 names for 3 classes");
  // Row 10 divides the first twenty along x.
  ExpectRefused(Set<double>("positions", 30, 50.0),
                "rows 0 to 19 of the tensor 'positions' are not ordered as a k-d tree");
  ExpectRefused(
      [](ModelFile& model) {
        model.tensors["hand"] = {std::vector<double>{1.0}, {1}};
      },
      "the tensor 'hand' is unknown");
}

TEST(LoadGraspLibrary, RunsTheSelfTest) {
  ExpectRefused(Set<double>("selftest.output", 9, 5.0), "the self-test gives ", HC_ERROR_SELF_TEST);
  ExpectRefused(
      [](ModelFile& model) {
        auto& mask = std::get<std::vector<std::uint8_t>>(model.tensors.at("selftest.mask").values);
        mask.assign(mask.size(), 0);
      },
      "the self-test gives ",
      HC_ERROR_SELF_TEST);
}

TEST(GraspLibraryModel, FindsWhatTheLibraryHolds) {
  const auto model = Load(testing::SomeGraspLibraryModel());
  ASSERT_TRUE(model);
  const SomeCloud cloud = UprightPatch();
  std::vector<float> scratch(features::ObjectPlaneScratch(20, 12));
  features::ViewDescription view;
  ASSERT_EQ(features::DescribeView(cloud.View(), scratch, view), features::CloudFault::kNone);
  for (std::size_t c = 0; c < 2; ++c) {
    const features::GraspRequest request{.point_m = {0.3, 0.1, 0.15}, .num_neighbours = 2};
    const auto answer = model->Find(c, cloud.View(), request, scratch);
    const features::FoundGrasp expected =
        features::FindGrasp(model->library.Class(c), model->library.rule, view, request);
    EXPECT_EQ(answer.fault, features::CloudFault::kNone);
    EXPECT_EQ(answer.grasp.number, expected.number);
    EXPECT_EQ(answer.grasp.rotation, expected.rotation);
    EXPECT_EQ(answer.is_rejected, expected.distance_m > 0.05);
  }
}

TEST(GraspLibraryModel, RejectsWhatIsTooFarFromAnyDemonstration) {
  const auto model = Load(testing::SomeGraspLibraryModel());
  const SomeCloud cloud = UprightPatch();
  std::vector<float> scratch(features::ObjectPlaneScratch(20, 12));
  const auto answer = model->Find(0, cloud.View(), {.point_m = {5, 5, 5}}, scratch);
  EXPECT_TRUE(answer.is_rejected);
  EXPECT_GT(answer.grasp.distance_m, 5.0);
}

TEST(GraspLibraryModel, SaysWhatIsWrongWithACloud) {
  const auto model = Load(testing::SomeGraspLibraryModel());
  SomeCloud cloud(4, 4);
  cloud.Set(0, 0, {0, 0, 0});
  cloud.Set(1, 1, {1, 0, 0});
  std::vector<float> scratch(features::ObjectPlaneScratch(4, 4));
  EXPECT_EQ(model->Find(0, cloud.View(), {}, scratch).fault, features::CloudFault::kTooFewPoints);
}

}  // namespace
}  // namespace handcraft::runtime
