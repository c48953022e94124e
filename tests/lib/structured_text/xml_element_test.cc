// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/structured_text/xml_element.h"

#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

XmlElement Read(const std::string& text) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "a.xml", text);
  return XmlElement::ReadFile(folder / "a.xml");
}

TEST(XmlElement, ReadsElementsTextAndAttributes) {
  const XmlElement root = Read(
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<!-- note -->\n"
      "<a x='1.5' n=\"-3\" t=\"ü &lt;&#65;&gt;\"><b>one</b><c/>text<b> two &amp; </b></a>");
  EXPECT_EQ(root.Name(), "a");
  EXPECT_TRUE(root.Has("x"));
  EXPECT_FALSE(root.Has("y"));
  EXPECT_DOUBLE_EQ(root.Number("x"), 1.5);
  EXPECT_EQ(root.Integer("n", -3, 0), -3);
  EXPECT_EQ(root.Attribute("t"), "ü <A>");
  ASSERT_THAT(root.Children(), SizeIs(3));
  ASSERT_THAT(root.Children("b"), SizeIs(2));
  EXPECT_EQ(root.Children("b")[0].Text(), "one");
  EXPECT_EQ(root.Children("b")[1].Text(), " two & ");
  EXPECT_EQ(root.Children("c")[0].Text(), "");
}

TEST(XmlElement, OutlivesItsParent) {
  const XmlElement inner = Read("<a><b><c>x</c></b></a>").Children()[0].Children()[0];
  EXPECT_EQ(inner.Text(), "x");
}

TEST(XmlElement, NamesTheLineAndWhatIsThere) {
  const XmlElement element = Read("<a>\n<b n='7' x='1e999' w='wide'/>\n</a>").Children()[0];
  EXPECT_THROWS_MESSAGE(element.Attribute("z"), Error, HasSubstr("a.xml:2: <b>: no attribute 'z'"));
  EXPECT_THROWS_MESSAGE(element.Number("w"), Error, HasSubstr("w is 'wide'; a number is due"));
  EXPECT_THROWS_MESSAGE(element.Number("x"), Error, HasSubstr("x is '1e999'"));
  EXPECT_THROWS_MESSAGE(
      element.Integer("n", 8, 9), Error, HasSubstr("n is '7'; a whole number from 8 to 9 is due"));
  EXPECT_THROWS_MESSAGE(element.Integer("w", 0, 9), Error, HasSubstr("w is 'wide'"));
  EXPECT_THROWS_MESSAGE(
      element.Fail("wrong", "mend it"), Error, HasSubstr("a.xml:2: <b>: wrong (mend it)"));
}

TEST(XmlElement, RefusesWhatIsNotXml) {
  for (const std::string text : {"<a>\n<b>\n</a>", "<a", "{\"a\": 1}", "<a b=1/>", "<a><!--"}) {
    EXPECT_THROWS_MESSAGE(Read(text), Error, HasSubstr("this is not XML"));
  }
  EXPECT_THROWS_MESSAGE(Read("<a>\n<b>\n</a>"), Error, HasSubstr("a.xml:"));
  EXPECT_THROWS_MESSAGE(Read(""), Error, HasSubstr("the file is empty"));
  EXPECT_THROWS_MESSAGE(Read("<!-- nothing -->"), Error, HasSubstr("no element in the file"));
  EXPECT_THROWS_MESSAGE(Read(std::string("<\0a\0/\0>\0", 8)),
                        Error,
                        AllOf(HasSubstr("at byte 1: a zero byte"), HasSubstr("UTF-8")));
}

// Adversaries: a tower of elements, and entities that would grow to gigabytes.
TEST(XmlElement, RefusesTowersAndExpandsNoEntities) {
  std::string tower;
  for (int i = 0; i < 100000; ++i) tower += "<a>";
  EXPECT_THROWS_MESSAGE(Read(tower), Error, HasSubstr("more than 100 levels"));
  const XmlElement bomb = Read(
      "<!DOCTYPE a [<!ENTITY l \"ha\"><!ENTITY m \"&l;&l;&l;&l;&l;&l;&l;&l;\">]>\n<a t='&m;'/>");
  EXPECT_EQ(bomb.Attribute("t"), "&m;");
}

}  // namespace
}  // namespace handcraft
