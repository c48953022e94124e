// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/object_classes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::synthetic {
namespace {

using ::testing::HasSubstr;

constexpr std::array<Family, 5> kFamilies = {
    Family::kTrained, Family::kNovel, Family::kTaught, Family::kUntaught, Family::kRegrasp};

std::set<Object (*)(Rng&)> BuildersOf(Family family) {
  std::set<Object (*)(Rng&)> builders;
  for (const ObjectClass& kind : ClassesOf(family)) builders.insert(kind.draw);
  return builders;
}

// Mean over the surface of r (cos φ, sin φ) and of r (cos 2φ, sin 2φ), divided by that of r: half a
// turn changes the sign of the first, a quarter that of the second.
struct Moments {
  float second = 0.0F;
  float first = 0.0F;
};

Moments MomentsOf(const Mesh& mesh) {
  Eigen::Vector2f first = Eigen::Vector2f::Zero();
  Eigen::Vector2f second = Eigen::Vector2f::Zero();
  float total = 0.0F;
  for (const Face& face : mesh.faces) {
    const Eigen::Vector3f& a = mesh.vertices[face.vertices[0]];
    const Eigen::Vector3f& b = mesh.vertices[face.vertices[1]];
    const Eigen::Vector3f& c = mesh.vertices[face.vertices[2]];
    const Eigen::Vector3f at = (a + b + c) / 3.0F;
    const float radius = at.head<2>().norm() * (b - a).cross(c - a).norm();
    const float angle_rad = std::atan2(at.y(), at.x());
    first += radius * Eigen::Vector2f(std::cos(angle_rad), std::sin(angle_rad));
    second += radius * Eigen::Vector2f(std::cos(2.0F * angle_rad), std::sin(2.0F * angle_rad));
    total += radius;
  }
  return {second.norm() / total, first.norm() / total};
}

TEST(NameOf, HasAWordForEachSymmetry) {
  EXPECT_EQ(NameOf(Symmetry::kNone), "none");
  EXPECT_EQ(NameOf(Symmetry::kHalfTurn), "half_turn");
  EXPECT_EQ(NameOf(Symmetry::kRound), "round");
}

TEST(ClassesOf, AreTheDissertationsInNumberAndSize) {
  int num_images = 0;
  for (const ObjectClass& kind : ClassesOf(Family::kTrained)) {
    num_images += kind.num_images_full;
    EXPECT_GE(kind.num_images_full, 120);
    EXPECT_LE(kind.num_images_full, 2001);
  }
  EXPECT_EQ(ClassesOf(Family::kTrained).size(), 9U);
  EXPECT_EQ(num_images, 13247);
  EXPECT_EQ(ClassesOf(Family::kNovel).size(), 6U);
  EXPECT_EQ(ClassesOf(Family::kTaught).size(), 6U);
  EXPECT_EQ(ClassesOf(Family::kUntaught).size(), 8U);
  EXPECT_EQ(ClassesOf(Family::kRegrasp).size(), 4U);
}

TEST(ClassesOf, NameEachClassOnceAFamily) {
  for (const Family family : kFamilies) {
    std::set<std::string_view> names;
    for (const ObjectClass& kind : ClassesOf(family)) {
      EXPECT_EQ(kind.family, family) << kind.name;
      EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
      EXPECT_GE(kind.num_images_full, 30) << kind.name;
    }
  }
}

TEST(ClassesOf, ShareNoBuilderBetweenWhatIsLearntAndWhatIsTested) {
  const std::set<Object (*)(Rng&)> trained = BuildersOf(Family::kTrained);
  const std::set<Object (*)(Rng&)> taught = BuildersOf(Family::kTaught);
  for (const ObjectClass& kind : ClassesOf(Family::kNovel)) {
    EXPECT_FALSE(trained.contains(kind.draw)) << kind.name;
  }
  for (const ObjectClass& kind : ClassesOf(Family::kUntaught)) {
    EXPECT_FALSE(trained.contains(kind.draw)) << kind.name;
    EXPECT_FALSE(taught.contains(kind.draw)) << kind.name;
  }
}

// What can be measured on an object however it lies: its three sides, least first, how much of
// their box's surface it has, and how round its top is.
using Measures = std::array<float, 5>;

Measures MeasuresOf(const Mesh& mesh) {
  const Eigen::AlignedBox3f bounds = Bounds(mesh);
  Eigen::Vector3f sides_m = bounds.sizes();
  std::sort(sides_m.begin(), sides_m.end());
  float surface_m2 = 0.0F;
  for (const Face& face : mesh.faces) {
    const Eigen::Vector3f& a = mesh.vertices[face.vertices[0]];
    surface_m2 +=
        0.5F *
        (mesh.vertices[face.vertices[1]] - a).cross(mesh.vertices[face.vertices[2]] - a).norm();
  }
  Eigen::AlignedBox3f top;
  const float below_top_m = bounds.max().z() - 0.05F * bounds.sizes().z();
  for (const Eigen::Vector3f& at : mesh.vertices) {
    if (at.z() >= below_top_m) top.extend(at);
  }
  const float box_m2 =
      2.0F * (sides_m.x() * sides_m.y() + sides_m.y() * sides_m.z() + sides_m.z() * sides_m.x());
  const Eigen::Vector2f top_m = top.sizes().head<2>();
  return {sides_m.x(),
          sides_m.y(),
          sides_m.z(),
          surface_m2 / box_m2,
          top_m.minCoeff() / top_m.maxCoeff()};
}

// Least and greatest of each over many objects.
std::array<Measures, 2> RangesOf(const ObjectClass& kind) {
  std::array<Measures, 2> ranges;
  for (std::uint64_t i = 0; i < 60; ++i) {
    Rng rng = Rng::Stream(5, "object", i);
    const Measures measures = MeasuresOf(kind.draw(rng).mesh);
    for (std::size_t m = 0; m < measures.size(); ++m) {
      ranges[0].at(m) = i == 0 ? measures.at(m) : std::min(ranges[0].at(m), measures.at(m));
      ranges[1].at(m) = i == 0 ? measures.at(m) : std::max(ranges[1].at(m), measures.at(m));
    }
  }
  return ranges;
}

// The greatest gap between the ranges of a measure, as a share of the greater; 0: all overlap.
float Gap(const ObjectClass& one, const ObjectClass& other) {
  const auto a = RangesOf(one);
  const auto b = RangesOf(other);
  float gap = 0.0F;
  for (std::size_t m = 0; m < a[0].size(); ++m) {
    gap = std::max({gap, 1.0F - a[1].at(m) / b[0].at(m), 1.0F - b[1].at(m) / a[0].at(m)});
  }
  return gap;
}

TEST(ClassesOf, TellNovelObjectsFromTrainedOnesByTheirShape) {
  for (const ObjectClass& novel : ClassesOf(Family::kNovel)) {
    for (const ObjectClass& trained : ClassesOf(Family::kTrained)) {
      if (trained.num_objects > 1) continue;  // of the class of one
      EXPECT_GT(Gap(novel, trained), 0.01F) << novel.name << " and " << trained.name;
    }
  }
}

TEST(ClassesOf, TellTheTwoShampooBottlesApart) {
  const auto bottle_of = [](Family family) {
    const auto classes = ClassesOf(family);
    return *std::find_if(classes.begin(), classes.end(), [](const ObjectClass& kind) {
      return kind.name == "shampoo_bottle";
    });
  };
  EXPECT_GT(Gap(bottle_of(Family::kNovel), bottle_of(Family::kUntaught)), 0.1F)
      << "the caps: round, and as flat as the bottle";
}

TEST(ClassesOf, AreAsSymmetricAsTheySay) {
  for (const Family family : {Family::kTaught, Family::kUntaught, Family::kRegrasp}) {
    for (const ObjectClass& kind : ClassesOf(family)) {
      Rng rng = Rng::Stream(3, "object");
      const Moments moments = MomentsOf(kind.draw(rng).mesh);
      const bool is_round = kind.symmetry == Symmetry::kRound;
      EXPECT_EQ(moments.second < 0.02F, is_round) << kind.name << ' ' << moments.second;
      EXPECT_EQ(moments.first < 0.02F, kind.symmetry != Symmetry::kNone)
          << kind.name << ' ' << moments.first;
    }
  }
}

TEST(ClassesOf, DrawTheSameObjectFromTheSameStreamAndAnotherFromAnother) {
  for (const Family family : kFamilies) {
    for (const ObjectClass& kind : ClassesOf(family)) {
      Rng first = Rng::Stream(1, "object");
      Rng again = Rng::Stream(1, "object");
      Rng other = Rng::Stream(2, "object");
      const Object object = kind.draw(first);
      EXPECT_EQ(object.mesh.vertices, kind.draw(again).mesh.vertices) << kind.name;
      EXPECT_NE(object.mesh.vertices, kind.draw(other).mesh.vertices) << kind.name;
    }
  }
}

TEST(FamilyNamed, KnowsEveryNameAndSaysWhichThereAre) {
  for (const Family family : kFamilies) EXPECT_EQ(FamilyNamed(NameOf(family)), family);
  EXPECT_EQ(NameOf(Family::kUntaught), "untaught");
  EXPECT_THROWS_MESSAGE((void)FamilyNamed("Trained"),
                        Error,
                        HasSubstr("there is no family of objects \"Trained\" (give trained, novel, "
                                  "taught, untaught or regrasp)"));
}

}  // namespace
}  // namespace handcraft::synthetic
