// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/view_set.h"
#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

// A manifest alone: pictures are not opened.
void WriteSet(const TemporaryDirectory& folder) {
  std::string text = "image,mask,class,instance,split,licence,depth,note\n";
  for (int i = 0; i < 10; ++i) {
    std::ostringstream row;
    row << i << ".png," << i << "_m.png,mug,mug" << i << ",old,MIT,d" << i << ".png,\"a, " << i
        << "\"\n";
    text += row.str();
  }
  WriteFileAtomically(folder / "manifest.csv", text);
}

TEST(DataSplit, RewritesTheSplitsAndNothingElse) {
  const TemporaryDirectory folder;
  WriteSet(folder);
  const datasets::LabelledImageSet before = datasets::ReadLabelledImageSet(folder.path());
  const Outcome outcome = RunLine("data split " + folder.path().string() +
                                  " --share train=0.6 --share my=test=0.4 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["splits"][0]["name"], "my=test");
  EXPECT_EQ(json["splits"][0]["num_images"], 4);
  EXPECT_EQ(json["splits"][1]["num_instances"], 6);
  const datasets::LabelledImageSet after = datasets::ReadLabelledImageSet(folder.path());
  EXPECT_EQ(after.Only("train").items.size(), 6U);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(after.items[i].image, before.items[i].image);
    EXPECT_EQ(after.items[i].others, before.items[i].others);
  }
}

TEST(DataSplit, DividesViewSets) {
  const TemporaryDirectory folder;
  std::string text = "image,object_mask,cloud,class,instance,angle_deg,split,licence,note\n";
  for (int i = 0; i < 12; ++i) {
    const std::string number = std::to_string(i);
    text.append(number).append(".png,m.png,,mug,mug").append(std::to_string(i / 3));
    text.append(",").append(number).append(",old,MIT,\"n, ").append(number).append("\"\n");
  }
  WriteFileAtomically(folder / "views.csv", text);
  const Outcome outcome =
      RunLine("data split " + folder.path().string() + " --share a=0.5 --share b=0.5 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["splits"][0]["num_images"], 6);
  EXPECT_EQ(json["splits"][0]["num_instances"], 2);
  const datasets::ViewSet set = datasets::ReadViewSet(folder.path());  // no instance in two splits
  const std::string after = ReadTextFile(folder / "views.csv");
  EXPECT_THAT(after,
              HasSubstr("11.png,m.png,,mug,mug3,11," + set.items[11].split + ",MIT,\"n, 11\""));
  EXPECT_THAT(after, ::testing::Not(HasSubstr("old")));
}

TEST(DataSplit, ShowsWhatItWouldDo) {
  const TemporaryDirectory folder;
  WriteSet(folder);
  const std::string before = ReadTextFile(folder / "manifest.csv");
  const Outcome outcome = RunLine("data split " + folder.path().string() + " --dry-run");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Not written"));
  EXPECT_EQ(ReadTextFile(folder / "manifest.csv"), before);
}

TEST(DataSplit, NamesWhatIsWrong) {
  const TemporaryDirectory folder;
  WriteSet(folder);
  const std::string before = ReadTextFile(folder / "manifest.csv");
  const std::string line = "data split " + folder.path().string();
  const auto error_of = [&](const std::string& options) {
    const Outcome outcome = RunLine(line + options);
    EXPECT_NE(outcome.code, 0) << options;
    return outcome.err;
  };
  EXPECT_THAT(error_of(" --share train"), HasSubstr("NAME=SHARE is due"));
  EXPECT_THAT(error_of(" --share =1"), HasSubstr("NAME=SHARE is due"));
  EXPECT_THAT(error_of(" --share train=half"), HasSubstr("'half' is not a number"));
  EXPECT_THAT(error_of(" --share train=0.5"), HasSubstr("the sum of all shares is 0.5"));
  EXPECT_THAT(error_of(" --by class"), HasSubstr("too few classes"));
  EXPECT_THAT(error_of(" --by picture"), HasSubstr("--by"));
  EXPECT_EQ(ReadTextFile(folder / "manifest.csv"), before) << "nothing was written";
}

}  // namespace
}  // namespace handcraft::tools
