// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/cornell_cloud.h"

#include <string>
#include <utility>
#include <vector>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;

// A cloud of a picture of 3 × 2.
OrganisedCloud Read(const std::string& text) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "pcd0100.txt", text);
  return ReadCornellCloud(folder / "pcd0100.txt", 3, 2);
}

// As the original files begin.
std::string Header(int num_points) {
  const std::string number = std::to_string(num_points);
  return "# .PCD v.7 - Point Cloud Data file format\nFIELDS x y z rgb index\nSIZE 4 4 4 4 4\n"
         "TYPE F F F F U\nCOUNT 1 1 1 1 1\nWIDTH " +
         number + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + number + "\nDATA ascii\n";
}

TEST(ReadCornellCloud, PutsPointsAtTheirPixels) {
  const OrganisedCloud cloud =
      Read(Header(3) + "1924.064 -647.111 -119.4176 0 5\r\n1.5 2 3 2.3e-38 1\nnan nan nan 0 2\n");
  EXPECT_EQ(cloud.width, 3);
  EXPECT_EQ(cloud.height, 2);
  EXPECT_TRUE(cloud.At(2, 1).isApprox(Eigen::Vector3f(1.924064F, -0.647111F, -0.1194176F), 1e-6F));
  EXPECT_TRUE(cloud.At(1, 0).isApprox(Eigen::Vector3f(0.0015F, 0.002F, 0.003F), 1e-6F));
  EXPECT_FALSE(IsMeasured(cloud.At(2, 0))) << "NaN";
  EXPECT_FALSE(IsMeasured(cloud.At(0, 0))) << "no line";
  EXPECT_TRUE(cloud.base_from_camera.isApprox(Eigen::Isometry3f::Identity()));
}

TEST(ReadCornellCloud, NamesTheLineOfAFault) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {Header(1) + "1 2 3 0 6\n", ":11: the pixel 6 of a picture of 6"},
      {Header(2) + "1 2 3 0 4\n1 2 3 0 4\n", ":12: the pixel 4 is there twice"},
      {Header(1) + "1 2 3 0\n", ":11: '1 2 3 0' where x y z rgb index is due"},
      {Header(1) + "1 2 3 0 1 1\n", ":11: '1 2 3 0 1 1' where"},
      {Header(1) + "1 two 3 0 1\n", "'1 two 3 0 1' where"},
      {Header(1) + "1 2 3 0 -1\n", "'1 2 3 0 -1' where"},
      {Header(2) + "1 2 3 0 1\n", "1 points; the header says 2"},
      {Header(0) + "1 2 3 0 1\n", "1 points; the header says 0"},
      {"FIELDS x y z\nPOINTS 1\nDATA ascii\n1 2 3\n", ":3: no line 'FIELDS x y z rgb index'"},
      {"FIELDS x y z rgb index\nDATA ascii\n", ":2: no line 'POINTS'"},
      {"FIELDS x y z rgb index\nPOINTS 1\nDATA binary\n", "'DATA binary'; text is due"},
      {"", "no line 'DATA ascii': not a cloud of the Cornell data"},
      {"a picture\nor so\n", ":2: no line 'DATA ascii'"}};
  for (const auto& [text, message] : cases) {
    EXPECT_THROWS_MESSAGE(Read(text), Error, HasSubstr(message));
  }
}

}  // namespace
}  // namespace handcraft::datasets
