// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/omissions.h"

#include <string>
#include <vector>

#include "tests/support/expect_throws_message.h"

namespace handcraft::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> TextsOf(const std::vector<Fault>& notes) {
  std::vector<std::string> texts;
  texts.reserve(notes.size());
  for (const Fault& note : notes) {
    EXPECT_EQ(note.gravity, Gravity::kNote);
    texts.push_back(note.path + ": " + note.reason);
  }
  return texts;
}

TEST(Omissions, CountsThoseOfOneReasonAndNamesTheFirst) {
  Omissions omissions;
  EXPECT_THAT(omissions.Notes(), IsEmpty());
  omissions.LeaveOut("b.png", "no mask");
  omissions.GoWithout("d.png", "its cloud", "no mask");
  omissions.LeaveOut("a.png", "no mask");
  omissions.LeaveOut("c.txt", "no picture");
  omissions.LeaveOut("e.png", "no mask");
  EXPECT_THAT(TextsOf(omissions.Notes()),
              ElementsAre("b.png: left out, the first of 3: no mask",
                          "d.png: imported without its cloud: no mask",
                          "c.txt: left out: no picture"));
}

TEST(Omissions, TellsOfWhatSomeHave) {
  Omissions omissions;
  omissions.GoWithoutWhatOthersHave({"a", "b"}, 2, "its cloud", "no depth");
  omissions.GoWithoutWhatOthersHave({}, 2, "its angle", "no pose");
  EXPECT_THAT(omissions.Notes(), IsEmpty());
  omissions.GoWithoutWhatOthersHave({"a", "b"}, 3, "its cloud", "no depth");
  EXPECT_THAT(TextsOf(omissions.Notes()),
              ElementsAre("a: imported without its cloud, the first of 2: no depth"));
}

TEST(Omissions, RefusesWhenNoPictureIsLeft) {
  Omissions omissions;
  omissions.LeaveOut("a.png", "no mask");
  SourceSet source;
  EXPECT_THROWS_MESSAGE(
      (omissions.Conclude(source, {.path = "tree", .reason = "no pair", .remedy = "see"}), 0),
      Error,
      HasSubstr("tree: no pair; a.png: left out: no mask (see)"));
  source.pictures.emplace_back();
  omissions.Conclude(source, {.reason = "no pair"});
  EXPECT_THAT(TextsOf(source.notes), ElementsAre("a.png: left out: no mask"));
}

}  // namespace
}  // namespace handcraft::datasets
