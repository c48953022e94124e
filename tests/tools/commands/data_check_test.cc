// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "lib/core/file.h"
#include "lib/perception/image_io.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunArgs;

TEST(DataCheck, FindsNoFaultInAGoodSet) {
  const TemporaryDirectory folder;
  testing::WriteImageSet(folder / "set");
  const Outcome outcome = RunArgs({"data", "check", (folder / "set").string()});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "OK: 6 images and masks, no fault\n");
  EXPECT_EQ(outcome.err, "");
}

TEST(DataCheck, NamesEachFault) {
  const TemporaryDirectory folder;
  testing::WriteImageSet(folder / "set");
  std::filesystem::remove(folder / "set/p0.png");
  WriteFileAtomically(folder / "set/p1.png", "not a picture");
  perception::WritePng(folder / "set/p2.mask.png", Image(10, 10, 1, 255));
  const Outcome outcome = RunArgs({"data", "check", (folder / "set").string()});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("p0.png: "), HasSubstr("p1.png: "), HasSubstr("p2.mask.png: ")));
  EXPECT_THAT(outcome.err, HasSubstr("3 faults in 6 images"));
}

TEST(DataCheck, ListsFaultsForMachines) {
  const TemporaryDirectory folder;
  testing::WriteImageSet(folder / "set");
  std::filesystem::remove(folder / "set/p0.png");
  const Outcome outcome = RunArgs({"data", "check", (folder / "set").string(), "--json"});
  EXPECT_EQ(outcome.code, 3);
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json["faults"].size(), 1U);
  EXPECT_EQ(json["faults"][0]["path"], "p0.png");
}

TEST(DataCheck, RefusesAFolderWithoutManifest) {
  const TemporaryDirectory folder;
  const Outcome outcome = RunArgs({"data", "check", folder.path().string()});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("manifest.csv"));
}

}  // namespace
}  // namespace handcraft::tools
