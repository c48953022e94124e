// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/demonstration_set.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"
#include "tests/datasets/small_view_set.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunArgs;

using DataCheck = testing::ImageSetTest;

TEST_F(DataCheck, FindsNoFaultInAGoodSet) {
  const Outcome outcome = RunArgs({"data", "check", set_.string()});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "OK: 6 images and masks, no fault\n");
  EXPECT_EQ(outcome.err, "");
}

TEST_F(DataCheck, NamesEachFault) {
  std::filesystem::remove(set_ / "p0.png");
  WriteFileAtomically(set_ / "p1.png", "not a picture");
  perception::WritePng(set_ / "p2_mask.png", Image(10, 10, 1, 255));
  const Outcome outcome = RunArgs({"data", "check", set_.string()});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("p0.png: "), HasSubstr("p1.png: "), HasSubstr("p2_mask.png: ")));
  EXPECT_THAT(outcome.err, HasSubstr("3 faults in 6 images"));
  EXPECT_THAT(outcome.out, HasSubstr("PPM is due (convert it, for example to PNG)\n"));
}

TEST_F(DataCheck, NotesWhatIsLegal) {
  const Image mask = perception::ReadImage(set_ / "p2_mask.png");
  perception::WritePng(set_ / "p2_mask.png", Image(mask.width(), mask.height(), 1, 0));
  const Outcome outcome = RunArgs({"data", "check", set_.string()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "p2_mask.png: note: no good pixel (255): training draws nothing from the picture\n"
            "OK: 6 images and masks, no fault, 1 note\n");
  const auto json = nlohmann::json::parse(RunArgs({"data", "check", set_.string(), "--json"}).out);
  EXPECT_EQ(json["faults"].size(), 0U);
  ASSERT_EQ(json["notes"].size(), 1U);
  EXPECT_EQ(json["notes"][0]["path"], "p2_mask.png");
}

TEST_F(DataCheck, ListsFaultsForMachines) {
  std::filesystem::remove(set_ / "p0.png");
  const Outcome outcome = RunArgs({"data", "check", set_.string(), "--json"});
  EXPECT_EQ(outcome.code, 3);
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json["faults"].size(), 1U);
  EXPECT_EQ(json["faults"][0]["path"], "p0.png");
}

TEST_F(DataCheck, RefusesAFolderWithoutManifest) {
  const Outcome outcome = RunArgs({"data", "check", folder_.path().string()});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("manifest.csv"));
}

TEST_F(DataCheck, ChecksViewSets) {
  const std::filesystem::path root = folder_ / "views";
  std::filesystem::create_directory(root);
  datasets::WriteViews(handcraft::testing::MakeViewSet(root));
  EXPECT_THAT(RunArgs({"data", "check", root.string()}).out, HasSubstr("OK: 3 images and masks"));
  std::filesystem::remove(root / "a.pcd");
  const Outcome outcome = RunArgs({"data", "check", root.string()});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.out, HasSubstr("a.pcd: "));
  EXPECT_THAT(outcome.err, HasSubstr("1 fault in 3 images"));
}

TEST_F(DataCheck, NamesTheLinesOfPoses) {
  const std::filesystem::path root = folder_ / "shown";
  std::filesystem::create_directory(root);
  datasets::WriteViews(handcraft::testing::MakeViewSet(root));
  const datasets::Demonstration pose{
      .object_class = "can", .instance = "can_0", .view = "c.png", .angle_deg = 22.5, .pose = {}};
  datasets::WriteDemonstrations({.root = root, .items = {pose}});
  EXPECT_EQ(RunArgs({"data", "check", root.string()}).out,
            "OK: 3 images and masks, 1 demonstrations, no fault\n");
  datasets::WriteDemonstrations({.root = root, .items = {pose, pose}});
  const Outcome outcome = RunArgs({"data", "check", root.string()});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.out, "demonstrations.csv:3: the same row as on line 2\n");
  EXPECT_THAT(outcome.err, HasSubstr("1 fault in 3 images, 2 demonstrations"));
  const auto json = nlohmann::json::parse(RunArgs({"data", "check", root.string(), "--json"}).out);
  EXPECT_EQ(json["num_demonstrations"], 2);
  EXPECT_EQ(json["faults"][0]["line"], 3);
  EXPECT_EQ(json["faults"][0]["path"], "demonstrations.csv");
}

}  // namespace
}  // namespace handcraft::tools
