// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/demonstrator.h"

#include "lib/core/error.h"
#include "tests/datasets/synthetic/brute_force_grasp.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;
using ::testing::HasSubstr;

Isometry3f TurnedBy(float angle_rad) {
  return Isometry3f(Eigen::AngleAxisf(angle_rad, Vector3f::UnitZ()));
}

// A box that can be held across two of its sides, with a library of its grasps.
class BoxShown : public ::testing::Test {
 protected:
  BoxShown() {
    Rng rng = Rng::Stream(1, "grasps");
    GraspCounts counts;
    grasps_ = SampleGrasps(check_, {.num_tries = 2000, .most_grasps = 400}, rng, counts);
  }

  [[nodiscard]] Demonstrator Before(const PlacedBeforeArm& place,
                                    const DemonstratorOptions& options = {}) const {
    Rng rng = Rng::Stream(1, "favourites");
    return {check_, grasps_, place, options, rng};
  }

  [[nodiscard]] static std::vector<ShownGrasp> ShowSome(const Demonstrator& demonstrator,
                                                        std::uint64_t count) {
    std::vector<ShownGrasp> shown;
    GraspCounts counts;
    for (std::uint64_t i = 0; i < count; ++i) {
      Rng rng = Rng::Stream(1, "shown", i);
      shown.push_back(demonstrator.Show(rng, counts));
    }
    EXPECT_EQ(counts[GraspFault::kNone], count);
    return shown;
  }

  Mesh object_ = RoundedBox({0.06F, 0.09F, 0.18F}, 0.01F, {});
  GraspCheck check_{object_, {}, {}};
  std::vector<Grasp> grasps_;
};

TEST_F(BoxShown, ShowsWhatHoldsAndIsWithinReach) {
  PlacedBeforeArm place;
  place.base_from_object = Eigen::Translation3f(0.05F, -0.1F, 0.0F) * TurnedBy(0.7F);
  for (const ShownGrasp& shown : ShowSome(Before(place), 60)) {
    const Isometry3f object_from_grasp = InObject(shown.base_from_grasp, place.base_from_object);
    EXPECT_EQ(
        testing::SlowClose(object_, check_.gripper(), check_.rules(), object_from_grasp, 2e-5),
        GraspFault::kNone);
    const Eigen::Isometry3d base_from_grasp = shown.base_from_grasp.ToIsometry();
    const Eigen::Vector3d approach = base_from_grasp.linear().col(2);
    const Eigen::Vector3d wrist_m = base_from_grasp * Eigen::Vector3d(0.0, 0.0, -0.235);
    const Eigen::Vector3d shoulder_m(-0.5, -0.3, 0.35);
    EXPECT_LT((wrist_m - shoulder_m).norm(), 0.8551);
    const Eigen::Vector2d towards =
        (base_from_grasp.translation() - shoulder_m).head<2>().normalized();
    EXPECT_GT(approach.head<2>().dot(towards), -0.2501);
    EXPECT_LT(approach.z(), 0.1701);
  }
}

TEST_F(BoxShown, TurnsItsPosesWithTheObjectAndTheRobot) {
  PlacedBeforeArm place;
  const Isometry3f turn = Eigen::Translation3f(0.2F, 0.1F, 0.0F) * TurnedBy(1.1F);
  PlacedBeforeArm turned{.base_from_object = turn, .arm_in_base = place.arm_in_base.In(turn)};
  const std::vector<ShownGrasp> shown = ShowSome(Before(place), 30);
  const std::vector<ShownGrasp> shown_turned = ShowSome(Before(turned), 30);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Eigen::Isometry3d expected = turn.cast<double>() * shown[i].base_from_grasp.ToIsometry();
    EXPECT_TRUE(shown_turned[i].base_from_grasp.ToIsometry().isApprox(expected, 1e-5)) << i;
  }
}

TEST_F(BoxShown, ShowsTheSameForTheSameSeed) {
  const std::vector<ShownGrasp> one = ShowSome(Before({}), 5);
  const std::vector<ShownGrasp> two = ShowSome(Before({}), 10);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].base_from_grasp.position_m, two[i].base_from_grasp.position_m);
    EXPECT_EQ(one[i].base_from_grasp.rotation.coeffs(), two[i].base_from_grasp.rotation.coeffs());
  }
}

TEST_F(BoxShown, ScattersAboutItsFavourites) {
  const Demonstrator steady = Before({}, {.position_sd_m = 0.0F, .rotation_sd_rad = 0.0F});
  const Demonstrator shaky = Before({}, {.position_sd_m = 0.004F, .rotation_sd_rad = 0.05F});
  const auto apart = [](const Demonstrator& demonstrator, const ShownGrasp& shown) {
    const Isometry3f pose = InObject(shown.base_from_grasp, Isometry3f::Identity());
    float least_m = 1.0F;
    for (const Grasp& favourite : demonstrator.favourites()) {
      const Isometry3f difference = favourite.object_from_grasp.inverse() * pose;
      const float turned_rad = Eigen::AngleAxisf(difference.linear()).angle();
      least_m = std::min(least_m, difference.translation().norm() + 0.1F * turned_rad);
    }
    return least_m;
  };
  for (const ShownGrasp& shown : ShowSome(steady, 20)) EXPECT_LT(apart(steady, shown), 1e-4F);
  float mean_m = 0.0F;
  for (const ShownGrasp& shown : ShowSome(shaky, 100)) mean_m += apart(shaky, shown) / 100.0F;
  // Six normal numbers of 4 to 5 mm: 0.004 · 1.6 + 0.1 · 0.05 · 1.6 on average, cut by the checks.
  EXPECT_GT(mean_m, 0.006F);
  EXPECT_LT(mean_m, 0.018F);
}

TEST_F(BoxShown, SpreadsItsFavouritesFarthestFirst) {
  const Demonstrator demonstrator = Before({}, {.num_favourites = 8});
  const auto& favourites = demonstrator.favourites();
  ASSERT_EQ(favourites.size(), 8U);
  const auto apart = [](const Grasp& a, const Grasp& b) {
    const Isometry3f difference = a.object_from_grasp.inverse() * b.object_from_grasp;
    return difference.translation().norm() + 0.1F * Eigen::AngleAxisf(difference.linear()).angle();
  };
  // Each next one is nearer to those before it than the last one was.
  float last_m = 10.0F;
  for (std::size_t i = 1; i < favourites.size(); ++i) {
    float nearest_m = 10.0F;
    for (std::size_t k = 0; k < i; ++k) {
      nearest_m = std::min(nearest_m, apart(favourites[i], favourites[k]));
    }
    EXPECT_LE(nearest_m, last_m + 1e-4F);
    last_m = nearest_m;
  }
  EXPECT_GT(last_m, 0.05F);
}

TEST_F(BoxShown, SaysSoWhenThereIsNothingToShow) {
  PlacedBeforeArm far_away;
  far_away.base_from_object.translation().x() = 2.0F;
  EXPECT_THROWS_MESSAGE(Before(far_away), Error, HasSubstr("grasps is within the arm's reach"));
  const Demonstrator wild = Before({}, {.position_sd_m = 0.1F, .num_tries = 1});
  EXPECT_THROWS_MESSAGE(
      ShowSome(wild, 200), Error, HasSubstr("no pose that holds the object in 1 tries"));
}

TEST(DemonstratorOptions, RefuseWhatCannotBe) {
  EXPECT_THROWS_MESSAGE(DemonstratorOptions{.num_favourites = 0}.Validate(),
                        Error,
                        HasSubstr("DemonstratorOptions.num_favourites is 0"));
  EXPECT_THROWS_MESSAGE(DemonstratorOptions{.position_sd_m = -0.1F}.Validate(),
                        Error,
                        HasSubstr("position_sd_m is -0.1; it must be from 0 to 0.1"));
  EXPECT_THROWS_MESSAGE(
      DemonstratorOptions{.rotation_sd_rad = 2.0F}.Validate(), Error, HasSubstr("rotation_sd_rad"));
  EXPECT_THROWS_MESSAGE(DemonstratorOptions{.metres_per_radian = 0.0F}.Validate(),
                        Error,
                        HasSubstr("metres_per_radian is 0"));
  EXPECT_THROWS_MESSAGE(
      DemonstratorOptions{.num_tries = 0}.Validate(), Error, HasSubstr("num_tries is 0"));
}

}  // namespace
}  // namespace handcraft::synthetic
