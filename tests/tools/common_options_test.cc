// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/common_options.h"

#include <sstream>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;

// An application with the shared options and one required positional, as `evaluate` has them.
struct Parsed {
  std::uint64_t seed = 1;
  int num_threads = 0;
  std::string json;
  std::string model;

  explicit Parsed(const std::string& line) {
    CLI::App app;
    AddSeedOption(app, seed);
    AddThreadsOption(app, num_threads);
    AddJsonFileOption(app, json);
    app.add_option("MODEL", model)->required();
    app.parse(line);
  }
};

TEST(JsonFileOption, IsOffFileOrStandardOutput) {
  EXPECT_EQ(Parsed("m").json, "");
  EXPECT_EQ(Parsed("m --json").json, "-");
  EXPECT_EQ(Parsed("m --json -").json, "-");
  EXPECT_EQ(Parsed("m --json f").json, "f");
  EXPECT_EQ(Parsed("m --json=f").json, "f");
}

TEST(JsonFileOption, LeavesRequiredArgumentsAlone) {
  EXPECT_EQ(Parsed("--json m").json, "-");
  EXPECT_EQ(Parsed("--json m").model, "m");
}

TEST(ThreadsOption, IsTheMachineUnlessGiven) {
  EXPECT_GE(Parsed("m").num_threads, 1);
  EXPECT_EQ(Parsed("m --threads 3").num_threads, 3);
  EXPECT_THROW(Parsed("m --threads 0"), CLI::ValidationError);
}

TEST(SeedOption, TakesAllOf64Bits) {
  EXPECT_EQ(Parsed("m --seed 18446744073709551615").seed, ~std::uint64_t{0});
  EXPECT_THROW(Parsed("m --seed -1"), CLI::ParseError);
  EXPECT_THROW(Parsed("m --seed x"), CLI::ParseError);
}

TEST(WriteJson, GoesWhereTheOptionSays) {
  const TemporaryDirectory folder;
  std::ostringstream out;
  std::ostringstream err;
  const Console console{out, err};
  WriteJson(console, "", "{}");
  EXPECT_EQ(out.str(), "");
  WriteJson(console, "-", "{}");
  EXPECT_EQ(out.str(), "{}\n");
  WriteJson(console, (folder / "f").string(), "{}\n");
  EXPECT_EQ(ReadTextFile(folder / "f"), "{}\n");
}

TEST(RequireWritable, SaysBeforehandWhatIsWrong) {
  const TemporaryDirectory folder;
  RequireWritable("");
  RequireWritable("name_in_the_current_folder");
  RequireWritable(folder / "f");
  EXPECT_THROWS_MESSAGE(
      RequireWritable(folder.path()), Error, HasSubstr("cannot write: this is a folder"));
  EXPECT_THROWS_MESSAGE(
      RequireWritable(folder / "no/f"), Error, HasSubstr("cannot write: there is no folder "));
  EXPECT_FALSE(std::filesystem::exists(folder / "f"));
}

TEST(GivenOptions, NamesThoseOfTheGroup) {
  int top = 1;
  CLI::App app;
  app.add_option("--top", top)->group(kPictureGroup);
  app.add_option("--radius", top)->group(kPictureGroup);
  app.add_option("--seed", top);
  app.parse("--seed 3 --radius 1");
  EXPECT_THAT(GivenOptions(app, kPictureGroup), ::testing::ElementsAre("--radius"));
  RefusePictureOptions({});
  EXPECT_THROWS_MESSAGE(
      RefusePictureOptions({"--radius"}), Error, HasSubstr("--radius is about pictures"));
}

TEST(FilesOf, AreWhatAViewSetListsAndMayStandBesideIt) {
  datasets::ViewSet set{.root = "r", .items = {}};
  set.items.push_back({.image = "i.png",
                       .object_mask = "m.png",
                       .object_class = "c",
                       .instance = "1",
                       .split = "train",
                       .depth = "d.png"});
  EXPECT_THAT(
      FilesOf(set),
      ::testing::ElementsAre(
          "r/views.csv", "r/demonstrations.csv", "r/holds.csv", "r/i.png", "r/m.png", "r/d.png"));
}

TEST(FilesOf, AreManifestPicturesAndMasks) {
  datasets::LabelledImageSet set{.root = "r", .items = {}};
  set.items.emplace_back();
  set.items.back().image = "i.png";
  set.items.back().mask = "m.png";
  EXPECT_THAT(FilesOf(set), ::testing::ElementsAre("r/manifest.csv", "r/i.png", "r/m.png"));
}

TEST(SetExample, EndsTheHelp) {
  CLI::App app;
  SetExample(app, "handcraft do it");
  EXPECT_THAT(app.help(), HasSubstr("Example:\n  handcraft do it"));
}

}  // namespace
}  // namespace handcraft::tools
