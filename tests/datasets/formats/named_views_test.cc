// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/named_views.h"

#include <array>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

constexpr std::array<std::string_view, 1> kColumns = {"note"};

class NamedViewsTest : public ::testing::Test {
 protected:
  NamedViewsTest() {
    WriteFileAtomically(folder_ / "views.csv",
                        "image,class,instance,angle_deg\na.png,mug,mug_0,30\nb.png,mug,mug_1,\n");
    WriteFileAtomically(folder_ / "beside.csv", "note\nfirst\n");
  }

  TemporaryDirectory folder_;
};

TEST_F(NamedViewsTest, FindsAViewByItsImage) {
  const NamedViews views(folder_.path());
  CsvRows rows(folder_ / "beside.csv", kColumns);
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(views.Find(rows, "a.png", "mug", "mug_0").angle_deg, 30.0);
  EXPECT_FALSE(views.Find(rows, "b.png", "mug", "mug_1").angle_deg.has_value());
  EXPECT_EQ(views.Find(rows, "b.png", "mug", "mug_1").line, 3U);
}

TEST_F(NamedViewsTest, RefusesWhatDoesNotFit) {
  const NamedViews views(folder_.path());
  CsvRows rows(folder_ / "beside.csv", kColumns);
  ASSERT_TRUE(rows.Next());
  const auto find = [&](std::string_view image, std::string_view name, std::string_view instance) {
    static_cast<void>(views.Find(rows, image, name, instance));
  };
  EXPECT_THROWS_MESSAGE(find("c.png", "mug", "mug_0"),
                        Error,
                        HasSubstr("beside.csv:2: the view 'c.png' is no image of views.csv"));
  EXPECT_THROWS_MESSAGE(find("a.png", "cup", "mug_0"),
                        Error,
                        HasSubstr("beside.csv:2: class 'cup'; views.csv has 'mug'"));
  EXPECT_THROWS_MESSAGE(
      find("b.png", "mug", "mug_0"),
      Error,
      HasSubstr("instance 'mug_0'; views.csv has 'mug_1' for this view on line 3"));
}

TEST_F(NamedViewsTest, NamesWhatIsWrongWithTheViews) {
  WriteFileAtomically(folder_ / "views.csv", "image,class,instance,angle_deg\na.png,mug,mug_0,x\n");
  EXPECT_THROWS_MESSAGE(
      NamedViews(folder_.path()), Error, HasSubstr("views.csv:2: column 'angle_deg': 'x' where"));
  EXPECT_THROWS_MESSAGE(NamedViews("no/such"), Error, HasSubstr("views.csv: cannot open"));
}

}  // namespace
}  // namespace handcraft::datasets
