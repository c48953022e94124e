// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/json_value.h"

#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

JsonValue Read(const std::string& text) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "a.json", text);
  return JsonValue::ReadFile(folder / "a.json");
}

TEST(JsonValue, ReadsEachType) {
  const JsonValue json =
      Read(R"({"text": "ü \" ,", "list": [1, 2.5, -3e2], "no": null, "inner": {"n": 3.0}})");
  EXPECT_EQ(json["text"].Text(), "ü \" ,");
  EXPECT_TRUE(json["text"].IsText());
  EXPECT_THAT(json["list"].Numbers(), ElementsAre(1.0, 2.5, -300.0));
  EXPECT_TRUE(json["list"].IsList());
  EXPECT_THAT(json["list"].Items(), SizeIs(3));
  EXPECT_DOUBLE_EQ(json["list"].Items()[1].Number(), 2.5);
  EXPECT_EQ(json["inner"]["n"].Integer(0, 3), 3);
  EXPECT_TRUE(json.Has("text"));
  EXPECT_FALSE(json.Has("no"));
  EXPECT_FALSE(json.Has("more"));
}

TEST(JsonValue, ListsMembersInTheOrderOfTheirKeys) {
  const auto members = Read(R"({"b": 1, "a": [2]})").Members();
  ASSERT_THAT(members, SizeIs(2));
  EXPECT_EQ(members[0].first, "a");
  EXPECT_THAT(members[0].second.Numbers(), ElementsAre(2.0));
  EXPECT_EQ(members[1].first, "b");
  EXPECT_THROWS_MESSAGE(members[1].second.Members(), Error, HasSubstr("at /b: 1; an object"));
}

TEST(JsonValue, OutlivesItsParent) {
  const JsonValue inner = Read(R"({"a": {"b": ["x"]}})")["a"]["b"].Items()[0];
  EXPECT_EQ(inner.Text(), "x");
}

TEST(JsonValue, NamesThePlaceAndWhatIsThere) {
  const JsonValue json = Read(R"({"a/b": [{"x~": "seven"}, 1.5, [1, "two"], true, 4e18]})");
  const JsonValue list = json["a/b"];
  EXPECT_THROWS_MESSAGE(list.Items()[0]["x~"].Number(),
                        Error,
                        AllOf(HasSubstr("a.json: at /a~1b/0/x~0: \"seven\"; a number is due")));
  EXPECT_THROWS_MESSAGE(list.Items()[1].Integer(0, 9),
                        Error,
                        HasSubstr("/1: 1.5; a whole number from 0 to 9 is due"));
  EXPECT_THROWS_MESSAGE(list.Items()[4].Integer(0, 9), Error, HasSubstr("4e+18; a whole number"));
  EXPECT_THROWS_MESSAGE(
      list.Items()[2].Numbers(), Error, HasSubstr("/a~1b/2/1: \"two\"; a number"));
  EXPECT_THROWS_MESSAGE(list.Items()[3].Text(), Error, HasSubstr("true; a text is due"));
  EXPECT_THROWS_MESSAGE(list.Text(), Error, HasSubstr("a list of 5; a text is due"));
  EXPECT_THROWS_MESSAGE(json.Items(), Error, HasSubstr("a.json: an object; a list is due"));
  EXPECT_THROWS_MESSAGE(json["c"], Error, HasSubstr("a.json: no member 'c'"));
  EXPECT_THROWS_MESSAGE(list["c"], Error, HasSubstr("a list of 5; an object is due"));
  EXPECT_THROWS_MESSAGE(list.Has("c"), Error, HasSubstr("an object is due"));
  EXPECT_THROWS_MESSAGE(
      Read("\"" + std::string(99, 'x') + "\"").Number(), Error, HasSubstr("xxx...; a number"));
}

TEST(JsonValue, RefusesWhatCannotBeParsed) {
  EXPECT_THROWS_MESSAGE(Read(""), Error, HasSubstr("the file is empty; JSON is due"));
  EXPECT_THROWS_MESSAGE(Read(R"({"a": [1, 2)"), Error, HasSubstr("this is not JSON"));
  EXPECT_THROWS_MESSAGE(Read("[1,]"), Error, HasSubstr("this is not JSON"));
  EXPECT_THROWS_MESSAGE(Read("[NaN]"), Error, HasSubstr("this is not JSON"));
  EXPECT_THROWS_MESSAGE(Read("[\"\xFF\"]"), Error, HasSubstr("this is not JSON"));
  EXPECT_THROWS_MESSAGE(Read("[1e999]"), Error, HasSubstr("a number is too large"));
  EXPECT_THROWS_MESSAGE(Read(std::string(100000, '[')), Error, HasSubstr("more than 100 levels"));
  EXPECT_THROWS_MESSAGE(JsonValue::ReadFile("no/such.json"), Error, HasSubstr("no/such.json"));
}

}  // namespace
}  // namespace handcraft::datasets
