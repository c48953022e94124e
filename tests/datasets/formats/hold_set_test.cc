// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/hold_set.h"

#include <algorithm>
#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using testing::TemporaryDirectory;

constexpr const char* kHeader =
    "class,instance,view,frame,end_effector,"
    "right_x_m,right_y_m,right_z_m,right_qx,right_qy,right_qz,right_qw,"
    "left_x_m,left_y_m,left_z_m,left_qx,left_qy,left_qz,left_qw\n";
constexpr const char* kViews = "image,class,instance,angle_deg\ndrill.png,drill,drill_0,\n";
constexpr const char* kRow =
    "drill,drill_0,drill.png,base,grasp_centre,0.1,-0.2,0.3,0,0.6,0,0.8,0.4,-0.5,0.6,1,0,0,0\n";

HoldSet ReadRows(const std::string& rows) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "views.csv", kViews);
  WriteFileAtomically(folder / "holds.csv", kHeader + rows);
  return ReadHoldSet(folder.path());
}

// The row with one piece of it replaced.
std::string RowWith(const std::string& piece, const std::string& other) {
  std::string row = kRow;
  const std::size_t at = row.find(piece);
  EXPECT_NE(at, std::string::npos);
  return row.replace(at, piece.size(), other);
}

TEST(ReadHoldSet, ReadsARow) {
  const HoldSet set = ReadRows(kRow);
  ASSERT_THAT(set.items, SizeIs(1));
  EXPECT_EQ(set.items[0].view, "drill.png");
  EXPECT_EQ(set.items[0].right.position_m, Eigen::Vector3d(0.1, -0.2, 0.3));
  EXPECT_EQ(set.items[0].right.rotation.coeffs(), Eigen::Vector4d(0.0, 0.6, 0.0, 0.8));
  EXPECT_EQ(set.items[0].left.position_m, Eigen::Vector3d(0.4, -0.5, 0.6));
  EXPECT_EQ(set.items[0].left.rotation.coeffs(), Eigen::Vector4d(1.0, 0.0, 0.0, 0.0));
}

TEST(ReadHoldSet, NamesTheLineOfWhatIsWrong) {
  const auto expect = [](const std::string& row, const std::string& message) {
    EXPECT_THROWS_MESSAGE(ReadRows(kRow + row), Error, HasSubstr("holds.csv:3: " + message));
  };
  expect(RowWith("0.6,1,", "0.6,1.5,"), "the quaternion has length 1.5");
  expect(RowWith("-0.5", "inf"), "column 'left_y_m': 'inf' is not a finite number");
  expect(RowWith("-0.5", "-500"), "column 'left_y_m': -500 m is out of a robot's reach");
  expect(RowWith("0.1", ""), "column 'right_x_m': nothing where a number is due");
  expect(RowWith("base", "world"), "frame 'world'; 'base' is due");
  expect(RowWith("drill.png", "mug.png"), "the view 'mug.png' is no image of views.csv beside it");
  expect(RowWith("drill_0", "drill_1"), "instance 'drill_1'; views.csv has 'drill_0'");
  expect("drill\n", "1 fields; the first line has 19");
}

TEST(ReadHoldSet, SaysWhatIsMissing) {
  EXPECT_THROWS_MESSAGE(ReadRows(""), Error, HasSubstr("holds.csv: no hold is listed"));
  EXPECT_THROWS_MESSAGE(ReadHoldSet("no/such"), Error, HasSubstr("holds.csv: cannot open"));
}

TEST(CheckHolds, NamesEveryFaultyRow) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "views.csv", kViews);
  WriteFileAtomically(folder / "holds.csv", kHeader + RowWith("drill_0", "drill_1") + kRow + kRow);
  const RowFindings findings = CheckHolds(folder.path());
  EXPECT_EQ(findings.num_rows, 3U);
  ASSERT_THAT(findings.faults, SizeIs(2));
  EXPECT_EQ(findings.faults[0].line, 2U);
  EXPECT_THAT(findings.faults[0].reason, HasSubstr("instance 'drill_1'"));
  EXPECT_EQ(findings.faults[1].line, 4U);
  EXPECT_EQ(findings.faults[1].reason, "the same row as on line 3");
}

TEST(WriteHolds, ComesBackUnchanged) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "views.csv", kViews);
  HoldSet set{.root = folder.path(), .items = {}};
  Rng rng = Rng::Stream(1, "holds");
  for (int i = 0; i < 10; ++i) {
    Hold item{.object_class = "drill",
              .instance = "drill_0",
              .view = "drill.png",
              .right = {},
              .left = {}};
    item.right.position_m = {rng.Normal(), rng.Normal(), rng.Normal()};
    item.left.rotation.coeffs() =
        Eigen::Vector4d(rng.Normal(), rng.Normal(), rng.Normal(), rng.Normal()).normalized();
    set.items.push_back(item);
  }
  WriteHolds(set);
  const HoldSet read = ReadHoldSet(folder.path());
  ASSERT_EQ(read.items.size(), set.items.size());
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    EXPECT_EQ(read.items[i].right.position_m, set.items[i].right.position_m);
    EXPECT_EQ(read.items[i].left.rotation.coeffs(), set.items[i].left.rotation.coeffs());
  }
  EXPECT_EQ(Fingerprint(read), Fingerprint(set));
}

TEST(HoldFingerprint, DependsOnBothHandsAndNotOnTheOrder) {
  HoldSet set = ReadRows(std::string(kRow) + RowWith("0.1", "0.2"));
  const std::string fingerprint = Fingerprint(set);
  std::reverse(set.items.begin(), set.items.end());
  EXPECT_EQ(Fingerprint(set), fingerprint);
  set.items[0].left.position_m.x() += 1e-9;
  EXPECT_NE(Fingerprint(set), fingerprint);
  set.items[0].left.position_m.x() = 0.4;
  EXPECT_EQ(Fingerprint(set), fingerprint);
  set.items[0].right.rotation.w() += 1e-9;
  EXPECT_NE(Fingerprint(set), fingerprint);
}

}  // namespace
}  // namespace handcraft::datasets
