// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "datasets/formats/demonstration_set.h"
#include "datasets/view_folds.h"
#include "lib/core/error.h"
#include "tests/experiments/view_studies/small_views.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using handcraft::testing::MakeSmallViews;
using handcraft::testing::TemporaryDirectory;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ProvideViews, ReadsAFolder) {
  const TemporaryDirectory folder;
  const datasets::ViewSet made = MakeSmallViews(folder / "set", 1);
  const datasets::ViewSet set =
      ProvideViews({.folder = (folder / "set").string()}, folder / "made", 1, {});
  EXPECT_EQ(datasets::Fingerprint(set), datasets::Fingerprint(made));
  EXPECT_FALSE(std::filesystem::exists(folder / "made"));
  EXPECT_THROW(static_cast<void>(ProvideViews({.folder = "missing"}, folder / "made", 1, {})),
               Error);
}

TEST(ProvideViews, TakesOneSplitOfAFolder) {
  const TemporaryDirectory folder;
  datasets::ViewSet made = MakeSmallViews(folder / "set", 1);
  for (datasets::ObjectView& view : made.items) view.split = "train";
  made.items.back().split = "test";
  datasets::WriteViews(made);
  ViewSource source{.folder = (folder / "set").string(), .split = "test"};
  EXPECT_THAT(ProvideViews(source, folder / "made", 1, {}).items, ElementsAre(made.items.back()));
  source.split = "tset";
  EXPECT_THROWS_MESSAGE(static_cast<void>(ProvideViews(source, folder / "made", 1, {})),
                        Error,
                        HasSubstr("views.csv: no view is of the split \"tset\""));
}

TEST(ProvideViews, MakesDemonstrationSetsWhereTheyAreAskedFor) {
  const TemporaryDirectory folder;
  const datasets::ViewSet set = ProvideViews({.families = {synthetic::Family::kRegrasp},
                                              .sensor = synthetic::CloudSensor::kPerfect,
                                              .num_views = 1,
                                              .num_poses = 1},
                                             folder / "made",
                                             2,
                                             {});
  EXPECT_EQ(set.items.size(), 4U);
  EXPECT_EQ(datasets::ReadDemonstrationSet(set.root).items.size(), 4U);
}

TEST(OnlyFirstClasses, KeepsTheViewsOfSo) {
  const TemporaryDirectory folder;
  const datasets::ViewSet set = MakeSmallViews(folder / "set", 2);
  EXPECT_EQ(OnlyFirstClasses(set, 0).items.size(), 8U);
  EXPECT_THAT(datasets::ClassesOf(OnlyFirstClasses(set, 2)).names,
              ElementsAre("water_bottle", "spray_bottle"));
  EXPECT_THROWS_MESSAGE(static_cast<void>(OnlyFirstClasses(set, 5)),
                        Error,
                        HasSubstr("num_classes is 5, and there are 4 classes"));
}

}  // namespace
}  // namespace handcraft::experiments
