// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/object_classes.h"

#include <set>

#include <gtest/gtest.h>

namespace handcraft::synthetic {
namespace {

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
}

TEST(ClassesOf, ShareNeitherNamesNorBuildersBetweenTheFamilies) {
  std::set<Object (*)(Rng&)> trained;
  std::set<std::string_view> names;
  for (const ObjectClass& kind : ClassesOf(Family::kTrained)) {
    trained.insert(kind.draw);
    EXPECT_EQ(kind.family, Family::kTrained);
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
  }
  for (const ObjectClass& kind : ClassesOf(Family::kNovel)) {
    EXPECT_EQ(kind.family, Family::kNovel);
    EXPECT_FALSE(trained.contains(kind.draw)) << kind.name;
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
  }
}

TEST(ClassesOf, DrawTheSameObjectFromTheSameStreamAndAnotherFromAnother) {
  for (const Family family : {Family::kTrained, Family::kNovel}) {
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

}  // namespace
}  // namespace handcraft::synthetic
