// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/rectangle_list.h"

#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

TEST(WriteRectangles, WritesALineARectangle) {
  const testing::TemporaryDirectory folder;
  const GraspRectangle level = {{{1, 2}, {3, 2}, {3, 4}, {1, 4}}};
  const GraspRectangle fine = {{{0.1, -2.5}, {3, 2}, {3, 4}, {1e-7, 1e6}}};
  WriteRectangles(folder.path(),
                  {{.image = "images/a,b.png", .rectangles = {{level}, {fine}}},
                   {.image = "images/none.png", .rectangles = {}},
                   {.image = "images/c.png", .rectangles = {{fine}, {}}}});
  EXPECT_EQ(ReadTextFile(folder / "rectangles.csv"),
            "image,good,u1_px,v1_px,u2_px,v2_px,u3_px,v3_px,u4_px,v4_px\n"
            "\"images/a,b.png\",1,1,2,3,2,3,4,1,4\n"
            "\"images/a,b.png\",0,0.1,-2.5,3,2,3,4,1e-07,1e+06\n"
            "images/c.png,1,0.1,-2.5,3,2,3,4,1e-07,1e+06\n");
}

}  // namespace
}  // namespace handcraft::datasets
