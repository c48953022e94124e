// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/grasp_sampler.h"

#include "lib/core/error.h"
#include "tests/datasets/synthetic/brute_force_grasp.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Sampled {
  std::vector<Grasp> grasps;
  GraspCounts counts;
};

Sampled Sample(const GraspCheck& check,
               const GraspSamplerOptions& options,
               std::uint64_t seed = 1) {
  Rng rng = Rng::Stream(seed, "grasps");
  Sampled sampled;
  sampled.grasps = SampleGrasps(check, options, rng, sampled.counts);
  return sampled;
}

TEST(SampleGrasps, PassThroughTheMiddleOfABall) {
  constexpr float kRadiusM = 0.04F;
  const Vector3f middle(0.0F, 0.0F, 0.2F);
  const GraspCheck check(testing::Ball(kRadiusM, middle.z(), 64), {}, {});
  const Sampled sampled = Sample(check, {.num_tries = 400});
  ASSERT_GT(sampled.grasps.size(), 100U);
  // A chord within both friction cones is no farther from the middle than r sin(atan µ); the facets
  // are turned by up to half of 2π / 64.
  const float limit_m = kRadiusM * std::sin(std::atan(check.rules().friction) + 0.05F);
  for (const Grasp& grasp : sampled.grasps) {
    const Vector3f closing = grasp.object_from_grasp.linear().col(0);
    const Vector3f from_middle = grasp.object_from_grasp.translation() - middle;
    EXPECT_LE(from_middle.cross(closing).norm(), limit_m);
    EXPECT_NEAR(from_middle.dot(closing), 0.0F, 1e-3F) << "the centre halves the chord";
  }
}

TEST(SampleGrasps, CloseOnTheParallelFacesOfABox) {
  const Vector3f size_m(0.05F, 0.3F, 0.25F);  // one pair of faces alone is near enough
  const GraspCheck check(RoundedBox(size_m, 0.001F, {}), {}, {.friction = 0.1F});
  const Sampled sampled = Sample(check, {.num_tries = 600});
  ASSERT_GT(sampled.grasps.size(), 100U);
  for (const Grasp& grasp : sampled.grasps) {
    EXPECT_GT(std::abs(grasp.object_from_grasp.linear()(0, 0)), std::cos(std::atan(0.1F)) - 1e-4F);
    EXPECT_NEAR(grasp.contacts.WidthM(), 0.05F, 0.05F * 0.006F);
  }
}

TEST(SampleGrasps, HoldByEverySlowSecondAnswer) {
  const Mesh object = RoundedBox({0.05F, 0.08F, 0.15F}, 0.008F, {});
  const GraspCheck check(object, {}, {});
  const Sampled sampled = Sample(check, {.num_tries = 1000, .most_grasps = 150});
  ASSERT_GT(sampled.grasps.size(), 100U);
  for (const Grasp& grasp : sampled.grasps) {
    EXPECT_EQ(
        testing::SlowClose(object, check.gripper(), check.rules(), grasp.object_from_grasp, 2e-5),
        GraspFault::kNone);
    const Eigen::Matrix3f rotation = grasp.object_from_grasp.linear();
    EXPECT_TRUE((rotation.transpose() * rotation).isIdentity(1e-5F));
    EXPECT_NEAR(rotation.determinant(), 1.0F, 1e-5F);
  }
}

TEST(SampleGrasps, FindsNothingToHoldOnWhatIsWiderThanTheHand) {
  const GraspCheck check(RoundedBox({0.2F, 0.3F, 0.25F}, 0.01F, {}), {}, {});
  const Sampled sampled = Sample(check, {.num_tries = 300});
  EXPECT_THAT(sampled.grasps, IsEmpty());
  EXPECT_GT(sampled.counts[GraspFault::kTooWide], 270U) << "of 300; others cut an edge";
}

TEST(SampleGrasps, FindsNothingToHoldOnWhatLiesFlat) {
  const GraspCheck check(RoundedBox({0.05F, 0.1F, 0.015F}, 0.001F, {}), {}, {});
  const Sampled sampled = Sample(check, {.num_tries = 300});
  EXPECT_THAT(sampled.grasps, IsEmpty());
  EXPECT_GT(sampled.counts[GraspFault::kNearTable], 100U);
}

TEST(SampleGrasps, CountsEveryPose) {
  const GraspCheck check(testing::Can(0.03F, 0.15F), {}, {});
  const Sampled sampled = Sample(check, {.num_tries = 200, .num_approaches = 3});
  EXPECT_EQ(sampled.counts[GraspFault::kNone], sampled.grasps.size());
  EXPECT_GE(sampled.counts.Total(), 200U);
  EXPECT_LE(sampled.counts.Total(), 600U);
  GraspCounts twice = sampled.counts;
  twice.Add(sampled.counts);
  EXPECT_EQ(twice.Total(), 2 * sampled.counts.Total());
}

TEST(GraspCounts, SayWhatCameOfThePoses) {
  GraspCounts counts;
  EXPECT_EQ(counts.ToText(), "of 0 poses");
  counts.Add(GraspFault::kSlips);
  counts.Add(GraspFault::kTooWide);
  counts.Add(GraspFault::kTooWide);
  EXPECT_EQ(counts.ToText(), "of 3 poses 2 too wide, 1 slips");
  EXPECT_THROWS_MESSAGE(
      RequireGrasps({}, "crate", counts),
      Error,
      HasSubstr("the hand cannot hold the crate: of 3 poses 2 too wide, 1 slips"));
  RequireGrasps({Grasp{}}, "crate", counts);
}

TEST(SampleGrasps, StopsWhenThereAreEnough) {
  const GraspCheck check(testing::Can(0.03F, 0.15F), {}, {});
  const Sampled sampled = Sample(check, {.most_grasps = 10, .num_approaches = 4});
  EXPECT_GE(sampled.grasps.size(), 10U);
  EXPECT_LT(sampled.grasps.size(), 14U);
}

TEST(SampleGrasps, DependsOnTheSeedAlone) {
  const GraspCheck check(testing::Can(0.03F, 0.15F), {}, {});
  const Sampled one = Sample(check, {.num_tries = 100});
  const Sampled same = Sample(check, {.num_tries = 100});
  const Sampled other = Sample(check, {.num_tries = 100}, 2);
  ASSERT_EQ(one.grasps.size(), same.grasps.size());
  for (std::size_t i = 0; i < one.grasps.size(); ++i) {
    EXPECT_EQ(one.grasps[i].object_from_grasp.matrix(), same.grasps[i].object_from_grasp.matrix());
  }
  EXPECT_NE(one.grasps[0].object_from_grasp.matrix(), other.grasps[0].object_from_grasp.matrix());
}

TEST(GraspSamplerOptions, RefuseWhatCannotBe) {
  EXPECT_THROWS_MESSAGE(GraspSamplerOptions{.num_tries = 0}.Validate(),
                        Error,
                        HasSubstr("GraspSamplerOptions.num_tries is 0; it must be from 1"));
  EXPECT_THROWS_MESSAGE(
      GraspSamplerOptions{.most_grasps = -1}.Validate(), Error, HasSubstr("most_grasps is -1"));
  EXPECT_THROWS_MESSAGE(GraspSamplerOptions{.num_approaches = 361}.Validate(),
                        Error,
                        HasSubstr("num_approaches is 361"));
}

}  // namespace
}  // namespace handcraft::synthetic
