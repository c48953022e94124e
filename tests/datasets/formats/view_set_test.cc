// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/view_set.h"

#include <string>
#include <utility>
#include <vector>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "tests/datasets/small_view_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using testing::MakeViewSet;
using testing::TemporaryDirectory;

constexpr std::string_view kHeader =
    "image,object_mask,cloud,class,instance,angle_deg,split,licence";

class ViewSetTest : public ::testing::Test {
 protected:
  // Reads a list of one line below the usual first line.
  [[nodiscard]] ViewSet ReadRow(const std::string& row, const std::string& columns = "") const {
    WriteFileAtomically(folder_ / "views.csv", std::string(kHeader) + columns + "\n" + row + "\n");
    return ReadViewSet(folder_.path());
  }
  void ExpectRefused(const std::string& row,
                     const std::string& message,
                     const std::string& columns = "") const {
    EXPECT_THROWS_MESSAGE(ReadRow(row, columns), Error, HasSubstr(message));
  }

  TemporaryDirectory folder_;
};

TEST_F(ViewSetTest, ReadsBackWhatItWrote) {
  ViewSet set = MakeViewSet(folder_.path());
  set.items[0].depth = "depth/a, b.png";
  set.items[2].symmetry = "half_turn";
  WriteViews(set);
  EXPECT_EQ(ReadTextFile(folder_ / "views.csv"),
            std::string(kHeader) +
                ",depth,symmetry\n"
                "a.png,a_mask.png,a.pcd,mug,mug_0,22.5,train,CC0-1.0,\"depth/a, b.png\",\n"
                "b.png,b_mask.png,,mug,mug_0,,train,CC0-1.0,,\n"
                "c.png,c_mask.png,c.pcd,can,can_0,22.5,test,CC0-1.0,,half_turn\n");
  const ViewSet read = ReadViewSet(folder_.path());
  ASSERT_EQ(read.items.size(), 3U);
  EXPECT_EQ(read.items[0].depth, "depth/a, b.png");
  EXPECT_EQ(read.items[1].angle_deg, std::nullopt);
  EXPECT_EQ(read.items[2].angle_deg, 22.5);
  EXPECT_EQ(read.items[2].symmetry, "half_turn");
  EXPECT_EQ(Fingerprint(read), Fingerprint(set));
}

TEST_F(ViewSetTest, TakesColumnsInAnyOrderAndPassesOverOthers) {
  WriteFileAtomically(folder_ / "views.csv",
                      "licence,note,split,angle_deg,instance,class,cloud,object_mask,image\r\n"
                      ",new,train,0,mug_0,mug,,m.png,i.png\r\n");
  const ViewSet set = ReadViewSet(folder_.path());
  ASSERT_EQ(set.items.size(), 1U);
  EXPECT_EQ(set.items[0].image, "i.png");
  EXPECT_EQ(set.items[0].object_class, "mug");
  EXPECT_EQ(set.items[0].angle_deg, 0.0);
  EXPECT_EQ(set.items[0].scene, "");
}

TEST_F(ViewSetTest, RefusesRowsThatBreakARule) {
  EXPECT_EQ(ReadRow("i.png,m.png,c.pcd,mug,mug_0,359.9,train,").items[0].angle_deg, 359.9);
  ExpectRefused(",m.png,,mug,mug_0,0,train,", "views.csv:2: no image given");
  ExpectRefused("i.png,,,mug,mug_0,0,train,", "no object_mask given");
  ExpectRefused("i.png,m.png,,,mug_0,0,train,", "no class given");
  ExpectRefused("i.png,m.png,,mug,,0,train,", "no instance given");
  ExpectRefused("i.png,m.png,,mug,mug_0,0,,", "no split given");
  ExpectRefused("i.png,m.png,,mug,mug_0,360,train,", "angle_deg 360; 0 or more and less than 360");
  ExpectRefused("i.png,m.png,,mug,mug_0,-10,train,", "angle_deg -10");
  ExpectRefused("i.png,m.png,,mug,mug_0,nan,train,", "is not a finite number");
  ExpectRefused("i.png,m.png,,mug,mug_0,left,train,", "'left' where a number is due");
  ExpectRefused("i.png,m.png,/c.pcd,mug,mug_0,0,train,", "the cloud '/c.pcd' lies outside");
  ExpectRefused("i.png,m.png,,mug,mug_0,0,train,,../d.png", "the depth '../d.png'", ",depth");
  ExpectRefused("i.png,m.png,,mug,mug_0,0,train,,oval", "symmetry 'oval'; none, half", ",symmetry");
  ExpectRefused("i.png,m.png,,mug", "4 fields; the first line has 8");
  const std::string row = "i.png,m.png,,mug,mug_0,0,train,";
  ExpectRefused(row + "\n" + row, "views.csv:3: the image 'i.png' stands on line 2 already");
  ExpectRefused(row + "\nj.png,m.png,,mug,mug_0,0,test,", "in split 'test' here and in 'train'");
}

TEST_F(ViewSetTest, RefusesFoldersWithoutViews) {
  EXPECT_THROWS_MESSAGE(ReadViewSet(folder_.path()), Error, HasSubstr("not a view set"));
  EXPECT_THROWS_MESSAGE(ReadViewSet(folder_ / "no"), Error, HasSubstr("No such file"));
  WriteFileAtomically(folder_ / "views.csv", std::string(kHeader) + "\n");
  EXPECT_THROWS_MESSAGE(ReadViewSet(folder_.path()), Error, HasSubstr("no view is listed"));
  WriteFileAtomically(folder_ / "views.csv", "image,cloud\n");
  EXPECT_THROWS_MESSAGE(
      ReadViewSet(folder_.path()), Error, HasSubstr("views.csv:1: no column 'object_mask'"));
}

TEST_F(ViewSetTest, ReadsAViewWithItsFilesChecked) {
  const ViewSet set = MakeViewSet(folder_.path());
  const LoadedView view = ReadView(set, 0);
  EXPECT_EQ(view.image.channels(), 3);
  EXPECT_EQ(view.object_mask.At(0, 0), kObject);
  ASSERT_TRUE(view.cloud.has_value());
  EXPECT_EQ(view.cloud->At(3, 0).x(), 0.03F);
  EXPECT_FALSE(ReadView(set, 1).cloud.has_value());
}

TEST_F(ViewSetTest, FingerprintIsTheHashOfTheDocumentedText) {
  ViewSet set = MakeViewSet(folder_.path());
  std::swap(set.items[0], set.items[2]);
  set.items.pop_back();
  const auto digest = [&](const char* name) { return Sha256Hex(ReadFile(folder_ / name)); };
  const auto line = [](const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : std::string(1, 0)) + part;
    return text + "\n";
  };
  const std::string b =
      line({"b.png", digest("b.png"), digest("b_mask.png"), "", "mug", "mug_0", "", "train"});
  const std::string c = line({"c.png",
                              digest("c.png"),
                              digest("c_mask.png"),
                              digest("c.pcd"),
                              "can",
                              "can_0",
                              "22.5",
                              "test"});
  Sha256 hash;
  hash.Update(b + c);
  EXPECT_EQ(Fingerprint(set), hash.HexDigest());
}

TEST_F(ViewSetTest, FingerprintFollowsTheDataAlone) {
  const ViewSet set = MakeViewSet(folder_.path());
  const std::string fingerprint = Fingerprint(set);
  ViewSet same = set;
  std::swap(same.items[0], same.items[2]);
  same.items[0].licence = "other";
  EXPECT_EQ(Fingerprint(same), fingerprint);
  ViewSet other = set;
  other.items[0].angle_deg = 22.6;
  EXPECT_NE(Fingerprint(other), fingerprint);
  other = set;
  other.items[0].cloud.clear();
  EXPECT_NE(Fingerprint(other), fingerprint);
}

}  // namespace
}  // namespace handcraft::datasets
