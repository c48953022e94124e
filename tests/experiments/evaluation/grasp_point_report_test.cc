// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <regex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/evaluation/grasp_point_evaluation.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/experiments/evaluation/edge_model.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class WriteEdgeReport : public ::testing::Test {
 protected:
  std::string Write() {
    const GraspPointEvaluation evaluation = EvaluateGraspPoints(model_.get(), set_, {});
    WriteHtmlReport(path_, evaluation, set_, model_.get());
    return ReadTextFile(path_);
  }

  testing::TemporaryDirectory folder_;
  std::filesystem::path path_ = folder_ / "report.html";
  datasets::LabelledImageSet set_ = testing::WriteEdgeSet(folder_.path());
  testing::ModelOwner model_ = testing::MakeEdgeModel();
};

TEST_F(WriteEdgeReport, ShowsEveryImageAndTheModel) {
  const std::string page = Write();
  for (const datasets::LabelledImage& item : set_.items) EXPECT_THAT(page, HasSubstr(item.image));
  EXPECT_THAT(page, HasSubstr("edge &lt;model&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("edge <model>")));
  EXPECT_THAT(page, HasSubstr("filters=edge_0,window=1,energy=abs"));
  EXPECT_THAT(page, HasSubstr("48.9 %"));  // 22 of 45
  EXPECT_THAT(page, HasSubstr("15 on don’t-care ground"));
  EXPECT_THAT(page, HasSubstr("no pixel above 0.9"));
}

TEST_F(WriteEdgeReport, NeedsNothingFromOutside) {
  const std::string page =
      std::regex_replace(Write(), std::regex("base64,[A-Za-z0-9+/=]*"), "base64,");
  for (const char* outside : {"http", "<script", "<link", "@import", "url(", "file:"}) {
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  }
}

TEST_F(WriteEdgeReport, WritesTheSameBytesTwice) { EXPECT_EQ(Write(), Write()); }

TEST_F(WriteEdgeReport, ShowsSixtyOfManyImages) {
  const std::vector<datasets::LabelledImage> five = set_.items;
  while (set_.items.size() < 65) set_.items.push_back(five[set_.items.size() % 5]);
  EXPECT_THAT(Write(), HasSubstr("Shown are 60 of 65 images"));
}

TEST_F(WriteEdgeReport, LeavesNothingBehindWhenItCannotWrite) {
  const GraspPointEvaluation evaluation = EvaluateGraspPoints(model_.get(), set_, {});
  const std::filesystem::path missing = folder_ / "none" / "report.html";
  EXPECT_THROWS_MESSAGE(WriteHtmlReport(missing, evaluation, set_, model_.get()),
                        Error,
                        HasSubstr("none/report.html"));
  std::filesystem::remove(folder_ / "half.png");
  EXPECT_THROWS_MESSAGE(
      WriteHtmlReport(path_, evaluation, set_, model_.get()), Error, HasSubstr("half.png"));
  EXPECT_FALSE(std::filesystem::exists(path_));
}

}  // namespace
}  // namespace handcraft::experiments
