// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/split_assignment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;

// Classes "c0", "c1" … with so many instances of so many pictures.
LabelledImageSet MakeSet(int num_classes, int num_instances, int num_pictures) {
  LabelledImageSet set{.root = "here", .items = {}};
  for (int c = 0; c < num_classes; ++c) {
    for (int i = 0; i < num_instances; ++i) {
      for (int p = 0; p < num_pictures; ++p) {
        const std::string object_class = "c" + std::to_string(c);
        const std::string instance = object_class + "_" + std::to_string(i);
        const std::string name = instance + "_" + std::to_string(p);
        set.items.push_back(
            {name + ".png", name + "_mask.png", object_class, instance, "unknown", "CC0-1.0"});
      }
    }
  }
  return set;
}

std::map<std::string, std::map<std::string, int>> CountByClass(const LabelledImageSet& set) {
  std::map<std::string, std::map<std::string, int>> counts;
  for (const LabelledImage& item : set.items) ++counts[item.object_class][item.split];
  return counts;
}

// Split of each instance; fails when an instance is in two.
std::map<std::string, std::string> SplitOfInstance(const LabelledImageSet& set) {
  std::map<std::string, std::string> splits;
  for (const LabelledImage& item : set.items) {
    EXPECT_EQ(splits.try_emplace(item.instance, item.split).first->second, item.split)
        << item.instance;
  }
  return splits;
}

TEST(AssignSplits, DividesViewsLikePictures) {
  LabelledImageSet images = MakeSet(3, 7, 4);
  ViewSet views{.root = images.root, .items = {}};
  for (const LabelledImage& item : images.items) {
    views.items.push_back({.image = item.image,
                           .object_mask = item.mask,
                           .object_class = item.object_class,
                           .instance = item.instance,
                           .split = item.split});
  }
  AssignSplits(images, {});
  AssignSplits(views, {});
  for (std::size_t i = 0; i < images.items.size(); ++i)
    EXPECT_EQ(views.items[i].split, images.items[i].split) << i;
}

TEST(AssignSplits, SpreadsEveryClassLikeTheWhole) {
  LabelledImageSet set = MakeSet(3, 10, 4);
  AssignSplits(set, {});
  SplitOfInstance(set);
  for (const auto& [name, counts] : CountByClass(set)) {
    EXPECT_EQ(counts.at("train"), 28) << name;
    EXPECT_EQ(counts.at("test"), 12) << name;
  }
}

// No split is more than a group of its due behind or before, at any seed.
TEST(AssignSplits, StaysWithinAGroupOfEachShare) {
  const SplitOptions base{.shares = {{"train", 0.55}, {"validation", 0.15}, {"test", 0.3}}};
  Rng rng(7);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    LabelledImageSet set{.root = "here", .items = {}};
    std::size_t largest = 0;
    for (int i = 0; i < 60; ++i) {
      const std::size_t size = 1 + rng.UniformInt(9);
      largest = std::max(largest, size);
      for (std::size_t p = 0; p < size; ++p) {
        set.items.push_back(
            {std::to_string(i) + "_" + std::to_string(p), "m", "c", std::to_string(i), "", ""});
      }
    }
    SplitOptions options = base;
    options.seed = seed;
    AssignSplits(set, options);
    SplitOfInstance(set);
    std::map<std::string, int> counts = CountByClass(set)["c"];
    for (const auto& [name, share] : options.shares) {
      EXPECT_LE(std::abs(counts[name] - share * static_cast<double>(set.items.size())),
                2.0 * static_cast<double>(largest))
          << name << " with seed " << seed;
    }
  }
}

TEST(AssignSplits, DependsOnTheSeedAndNotOnTheOrder) {
  LabelledImageSet set = MakeSet(2, 20, 2);
  AssignSplits(set, {});
  LabelledImageSet reversed = MakeSet(2, 20, 2);
  std::reverse(reversed.items.begin(), reversed.items.end());
  AssignSplits(reversed, {});
  EXPECT_EQ(SplitOfInstance(reversed), SplitOfInstance(set));
  LabelledImageSet other = MakeSet(2, 20, 2);
  AssignSplits(other, {.seed = 2});
  EXPECT_NE(SplitOfInstance(other), SplitOfInstance(set));
}

TEST(AssignSplits, KeepsClassesWholeWhenAsked) {
  LabelledImageSet set = MakeSet(10, 2, 3);
  AssignSplits(set, {.group = SplitGroup::kClass});
  int in_test = 0;
  for (const auto& [name, counts] : CountByClass(set)) {
    EXPECT_EQ(counts.size(), 1U) << name;
    in_test += counts.count("test") > 0 ? 1 : 0;
  }
  EXPECT_EQ(in_test, 3);
}

TEST(AssignSplits, DividesTheObjectsPicturesWhenAsked) {
  LabelledImageSet set = MakeSet(3, 4, 10);
  AssignSplits(set, {.shares = {{"train", 0.2}, {"test", 0.8}}, .group = SplitGroup::kPicture});
  for (const auto& [name, counts] : CountByClass(set)) EXPECT_EQ(counts.at("train"), 8) << name;
  std::map<std::string, std::set<std::string>> splits;
  for (const LabelledImage& item : set.items) splits[item.instance].insert(item.split);
  EXPECT_TRUE(std::any_of(
      splits.begin(), splits.end(), [](const auto& entry) { return entry.second.size() == 2; }));
}

TEST(AssignSplits, TakesAnInstanceOfTwoClassesForOne) {
  LabelledImageSet set = MakeSet(2, 5, 1);
  set.items.push_back({"z.png", "z_mask.png", "c1", "c0_3", "unknown", ""});
  AssignSplits(set, {});
  SplitOfInstance(set);
}

TEST(AssignSplits, NamesWhatIsWrong) {
  LabelledImageSet set = MakeSet(1, 1, 5);
  EXPECT_THROWS_MESSAGE(AssignSplits(set, {}),
                        Error,
                        HasSubstr("too few instances for a share of 0.3: split 'test' would be"));
  EXPECT_THROWS_MESSAGE(AssignSplits(set, {.shares = {}}), Error, HasSubstr("1 or more splits"));
  EXPECT_THROWS_MESSAGE(AssignSplits(set, {.shares = {{"a", 0.5}, {"a", 0.5}}}),
                        Error,
                        HasSubstr("the split 'a' is named twice"));
  EXPECT_THROWS_MESSAGE(AssignSplits(set, {.shares = {{"a", 0.5}, {"b", 0.4}}}),
                        Error,
                        HasSubstr("the sum of all shares is 0.9; it must be 1"));
  EXPECT_THROWS_MESSAGE(AssignSplits(set, {.shares = {{"a", std::nan("")}}}),
                        Error,
                        HasSubstr("the share of 'a' is nan; it must be in (0, 1]"));
  EXPECT_THROWS_MESSAGE(
      AssignSplits(set, {.shares = {{"", 1.0}}}), Error, HasSubstr("a split without a name"));
}

}  // namespace
}  // namespace handcraft::datasets
