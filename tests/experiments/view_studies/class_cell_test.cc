// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/class_cell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

// Six views of four objects, made once.
const datasets::ViewSet& SmallTurntable() {
  static const TemporaryDirectory kFolder;
  static const datasets::ViewSet kSet = MakeSmallViews(kFolder / "set", 6);
  return kSet;
}

ViewCell CellOf(std::initializer_list<Setting> list) {
  ViewCell cell{.id = "cell", .method = "cell", .factors = {}, .settings = {}};
  cell.settings.classes.descriptor.grid_size = 10;
  for (const Setting& setting : list) ApplyViewSetting(setting, cell.settings);
  return cell;
}

// A study in which one class is right for drills.
ViewStudy Accepting(const std::string& name) {
  ViewStudy study;
  study.associations["drill"] = {name};
  return study;
}

TEST(TellClasses, LeavesEachViewOut) {
  const ViewCellResult result = TellClasses({}, CellOf({}), SmallTurntable(), nullptr, 2, {});
  EXPECT_THAT(result.answers.columns,
              ElementsAre("water_bottle", "spray_bottle", "coffee_can", "drill"));
  ASSERT_EQ(result.groups.size(), 5U);
  EXPECT_EQ(result.groups[4].name, "all");
  EXPECT_EQ(result.groups[4].num_views, 24U);
  EXPECT_GE(result.groups[4].num_right, 18U) << "objects this different are told apart";
  for (std::size_t row = 0; row < 4; ++row) EXPECT_EQ(result.groups[row].num_views, 6U);
  // Threads change nothing.
  const ViewCellResult again = TellClasses({}, CellOf({}), SmallTurntable(), nullptr, 1, {});
  EXPECT_EQ(again.answers.counts, result.answers.counts);
}

// What was learnt is known again, whatever each class is called right for.
TEST(TellClasses, ClassifiesOtherViewsByTheRuntime) {
  const ViewCellResult result = TellClasses(
      Accepting("coffee_can"), CellOf({{"C", "100"}}), SmallTurntable(), &SmallTurntable(), 1, {});
  EXPECT_EQ(result.groups[0].num_right, 6U);
  EXPECT_EQ(result.groups[3].num_right, 0U) << "drills are drills, but a can was asked for";
  EXPECT_EQ(result.answers.counts[3][3], 6U);
}

TEST(TellClasses, CanBeAskedForFewerClasses) {
  const ViewCellResult result =
      TellClasses({}, CellOf({{"num_classes", "2"}}), SmallTurntable(), nullptr, 1, {});
  EXPECT_EQ(result.groups.back().num_views, 12U);
  EXPECT_THROWS_MESSAGE(static_cast<void>(TellClasses(
                            {}, CellOf({{"num_classes", "5"}}), SmallTurntable(), nullptr, 1, {})),
                        Error,
                        HasSubstr("num_classes is 5, and there are 4 classes"));
}

// The first two classes are learnt, and all four asked about: cans and drills are none of them.
TEST(TellClasses, RejectsByWhatOtherObjectsTell) {
  ViewStudy study;
  study.associations["coffee_can"] = {"none of these"};
  study.associations["drill"] = {"none of these"};
  const ViewCell all = CellOf({{"num_classes", "2"}, {"C", "100"}});
  const ViewCellResult kept = TellClasses(study, all, SmallTurntable(), &SmallTurntable(), 1, {});
  EXPECT_EQ(kept.groups.back().num_right, 12U) << "what was learnt, and nothing else";
  ASSERT_FALSE(kept.rejection.empty());
  EXPECT_EQ(kept.rejection.back().num_kept, 24U);
  EXPECT_EQ(kept.rejection.back().num_right, 12U);
  const ViewCellResult result =
      TellClasses(study,
                  CellOf({{"num_classes", "2"}, {"C", "100"}, {"rejection", "calibrated"}}),
                  SmallTurntable(),
                  &SmallTurntable(),
                  1,
                  {});
  EXPECT_EQ(result.answers.columns.back(), "none of these");
  EXPECT_GT(result.groups.back().num_right, 16U);
  std::size_t num_novel_rejected = 0;
  for (std::size_t row = 2; row < 4; ++row) num_novel_rejected += result.answers.counts[row].back();
  EXPECT_GT(num_novel_rejected, 6U);
  EXPECT_EQ(result.rejection, kept.rejection);
}

TEST(TellClasses, RefusesToCalibrateOnNothing) {
  const ViewCell cell = CellOf({{"rejection", "calibrated"}});
  EXPECT_THROWS_MESSAGE(static_cast<void>(TellClasses({}, cell, SmallTurntable(), nullptr, 1, {})),
                        Error,
                        HasSubstr("there is no [data.test]"));
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(TellClasses({}, cell, SmallTurntable(), &SmallTurntable(), 1, {})),
      Error,
      HasSubstr("without \"water_bottle\" no novel object is left"));
}

TEST(TellClasses, RefusesAnAssociationWithNoClass) {
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(
          TellClasses(Accepting("saw"), CellOf({}), SmallTurntable(), &SmallTurntable(), 1, {})),
      Error,
      HasSubstr("saw"));
}

}  // namespace
}  // namespace handcraft::experiments
