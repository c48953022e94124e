// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/demonstration_set.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "lib/core/sha256.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using testing::TemporaryDirectory;

constexpr const char* kHeader =
    "class,instance,view,angle_deg,frame,end_effector,x_m,y_m,z_m,qx,qy,qz,qw\n";
constexpr const char* kViews =
    "image,object_mask,cloud,class,instance,angle_deg,split,licence\n"
    "images/mug_030.png,m.png,,mug,mug_0,30,train,CC0-1.0\n"
    "images/drill.png,m2.png,,drill,drill_0,,train,CC0-1.0\n";

// Reads these rows beside two views: a mug at 30° and a drill at an angle that nobody knows.
DemonstrationSet ReadRows(const std::string& rows, const std::string& header = kHeader) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "views.csv", kViews);
  WriteFileAtomically(folder / "demonstrations.csv", header + rows);
  return ReadDemonstrationSet(folder.path());
}

// A sound row with one piece of it replaced.
std::string RowWith(const std::string& piece, const std::string& other) {
  std::string row = "mug,mug_0,images/mug_030.png,30,base,grasp_centre,0.1,-0.2,0.3,0,0.6,0,0.8\n";
  const std::size_t at = row.find(piece);
  EXPECT_NE(at, std::string::npos);
  return row.replace(at, piece.size(), other);
}

std::vector<Demonstration> DrawDemonstrations(std::size_t count) {
  std::vector<Demonstration> items;
  Rng rng = Rng::Stream(1, "demonstrations");
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Quaterniond rotation;
    rotation.coeffs() = Eigen::Vector4d(rng.Normal(), rng.Normal(), rng.Normal(), rng.Normal());
    Demonstration item;
    item.object_class = i % 2 == 0 ? "mug" : "drill";
    item.instance = item.object_class + "_0";
    item.view = i % 2 == 0 ? "images/mug_030.png" : "images/drill.png";
    if (i % 2 == 0) item.angle_deg = 30.0;
    item.pose.position_m = {rng.Normal(), rng.Normal(), rng.Normal()};
    item.pose.rotation = rotation.normalized();
    items.push_back(item);
  }
  return items;
}

TEST(ReadDemonstrationSet, ReadsARow) {
  const DemonstrationSet set = ReadRows(RowWith("mug", "mug"));
  ASSERT_THAT(set.items, SizeIs(1));
  const Demonstration& item = set.items[0];
  EXPECT_EQ(item.object_class, "mug");
  EXPECT_EQ(item.instance, "mug_0");
  EXPECT_EQ(item.view, "images/mug_030.png");
  EXPECT_EQ(item.angle_deg, 30.0);
  EXPECT_EQ(item.pose.position_m, Eigen::Vector3d(0.1, -0.2, 0.3));
  EXPECT_EQ(item.pose.rotation.coeffs(), Eigen::Vector4d(0.0, 0.6, 0.0, 0.8));
}

TEST(ReadDemonstrationSet, TakesColumnsInAnyOrderAndViewsWithoutAnAngle) {
  const DemonstrationSet set =
      ReadRows("a note,1,0,0,0,0,0,0,grasp_centre,base,,images/drill.png,drill_0,drill\r\n",
               "note,qw,qz,qy,qx,z_m,y_m,x_m,end_effector,frame,angle_deg,view,instance,class\r\n");
  ASSERT_THAT(set.items, SizeIs(1));
  EXPECT_FALSE(set.items[0].angle_deg.has_value());
  EXPECT_EQ(set.items[0].pose.rotation.w(), 1.0);
}

TEST(ReadDemonstrationSet, NamesTheLineOfWhatIsWrong) {
  const auto expect = [](const std::string& row, const std::string& message) {
    EXPECT_THROWS_MESSAGE(ReadRows(RowWith("mug", "mug") + row),
                          Error,
                          HasSubstr("demonstrations.csv:3: " + message));
  };
  expect(RowWith("0.8", "0.9"), "the quaternion has length 1.08");
  expect(RowWith("0.1", "nan"), "column 'x_m': 'nan' is not a finite number");
  expect(RowWith("0.6", ""), "column 'qy': nothing where a number is due");
  expect(RowWith(",base", ",camera"), "frame 'camera'; 'base' is due");
  expect(RowWith("grasp_centre", "wrist"), "end_effector 'wrist'; 'grasp_centre' is due");
  expect(RowWith("mug_030.png", "mug_040.png"),
         "the view 'images/mug_040.png' is no image of views.csv beside it");
  expect(RowWith("mug_0,", "mug_1,"),
         "instance 'mug_1'; views.csv has 'mug_0' for this view on line 2");
  expect(RowWith("mug,", "cup,"), "class 'cup'; views.csv has 'mug'");
  expect(RowWith(",30,", ",40,"), "angle_deg '40'; views.csv has '30'");
  expect(RowWith(",30,", ",,"), "angle_deg ''; views.csv has '30'");
  expect(RowWith("mug,", ","), "no class given");
  expect("mug\n", "1 fields; the first line has 13");
  expect("\"mug", "a quote is opened and never closed");
}

TEST(ReadDemonstrationSet, SaysWhatIsMissing) {
  const TemporaryDirectory folder;
  const auto read = [&] { return ReadDemonstrationSet(folder.path()); };
  EXPECT_THROWS_MESSAGE(read(), Error, HasSubstr("not a demonstration set"));
  WriteFileAtomically(folder / "demonstrations.csv", "class,instance\n");
  EXPECT_THROWS_MESSAGE(read(), Error, HasSubstr("demonstrations.csv:1: no column 'view'"));
  WriteFileAtomically(folder / "demonstrations.csv", kHeader);
  EXPECT_THROWS_MESSAGE(read(), Error, HasSubstr("views.csv: cannot open"));
  WriteFileAtomically(folder / "views.csv", "");
  EXPECT_THROWS_MESSAGE(read(), Error, HasSubstr("views.csv: the file is empty"));
  WriteFileAtomically(folder / "views.csv", kViews);
  EXPECT_THROWS_MESSAGE(read(), Error, HasSubstr("demonstrations.csv: no pose is listed"));
  EXPECT_THROWS_MESSAGE(ReadDemonstrationSet("no/such"), Error, HasSubstr("No such file"));
}

TEST(CheckDemonstrations, NamesEveryFaultyRow) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "views.csv", kViews);
  const auto check = [&](const std::string& rows) {
    WriteFileAtomically(folder / "demonstrations.csv", kHeader + rows);
    std::string text;
    const RowFindings findings = CheckDemonstrations(folder.path());
    for (const Fault& fault : findings.faults)
      text += fault.path + ":" + std::to_string(fault.line.value_or(0)) + ": " + fault.reason + "|";
    return text + std::to_string(findings.num_rows);
  };
  const std::string sound = RowWith("mug", "mug");
  EXPECT_EQ(check(sound + RowWith("0.1", "0.2")), "2");
  EXPECT_EQ(check(RowWith("0.1", "inf") + sound + RowWith(",30,", ",40,") + RowWith("0.1", "0.10")),
            "demonstrations.csv:2: column 'x_m': 'inf' is not a finite number|"
            "demonstrations.csv:4: angle_deg '40'; views.csv has '30' for this view on line 2|"
            "demonstrations.csv:5: the same row as on line 3|4");
  EXPECT_EQ(check(""), "demonstrations.csv:1: no row is listed|0");
  std::filesystem::remove(folder / "views.csv");
  EXPECT_THAT(check(sound), HasSubstr("views.csv:0: cannot open"));
}

TEST(WriteDemonstrations, ComesBackUnchanged) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "views.csv", kViews);
  const DemonstrationSet set{.root = folder.path(), .items = DrawDemonstrations(20)};
  WriteDemonstrations(set);
  const DemonstrationSet read = ReadDemonstrationSet(folder.path());
  ASSERT_EQ(read.items.size(), set.items.size());
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    EXPECT_EQ(read.items[i].view, set.items[i].view);
    EXPECT_EQ(read.items[i].angle_deg, set.items[i].angle_deg);
    EXPECT_EQ(read.items[i].pose.position_m, set.items[i].pose.position_m);
    EXPECT_EQ(read.items[i].pose.rotation.coeffs(), set.items[i].pose.rotation.coeffs());
  }
  EXPECT_EQ(Fingerprint(read), Fingerprint(set));
}

TEST(WriteDemonstrations, QuotesNamesThatNeedIt) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "views.csv",
                      "image,class,instance,angle_deg\n\"a, \"\"b\"\".png\",größe,\"1\n2\",0\n");
  DemonstrationSet set{.root = folder.path(), .items = DrawDemonstrations(1)};
  set.items[0].object_class = "größe";
  set.items[0].instance = "1\n2";
  set.items[0].view = "a, \"b\".png";
  set.items[0].angle_deg = 0.0;
  WriteDemonstrations(set);
  EXPECT_EQ(Fingerprint(ReadDemonstrationSet(folder.path())), Fingerprint(set));
}

TEST(DemonstrationFingerprint, IsTheHashOfTheSortedRows) {
  const std::string first = RowWith("mug", "mug");
  const std::string second = RowWith("0.1", "0.05");
  Sha256 hash;
  hash.Update(second + first);
  EXPECT_EQ(Fingerprint(ReadRows(first + second)), hash.HexDigest());
}

TEST(DemonstrationFingerprint, DependsOnEveryColumnAndNotOnTheOrder) {
  DemonstrationSet set{.root = {}, .items = DrawDemonstrations(6)};
  const std::string fingerprint = Fingerprint(set);
  std::reverse(set.items.begin(), set.items.end());
  set.root = "elsewhere";
  EXPECT_EQ(Fingerprint(set), fingerprint);
  const std::vector<std::function<void(Demonstration&)>> changes = {
      [](Demonstration& item) { item.object_class += "x"; },
      [](Demonstration& item) { item.instance += "x"; },
      [](Demonstration& item) { item.view += "x"; },
      [](Demonstration& item) { item.angle_deg = 31.0; },
      [](Demonstration& item) { item.pose.position_m.y() += 1e-9; },
      [](Demonstration& item) { item.pose.rotation.w() += 1e-9; }};
  for (const auto& change : changes) {
    DemonstrationSet changed = set;
    change(changed.items[2]);
    EXPECT_NE(Fingerprint(changed), fingerprint);
  }
}

}  // namespace
}  // namespace handcraft::datasets
