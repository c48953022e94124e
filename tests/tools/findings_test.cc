// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/findings.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace handcraft::tools {
namespace {

const datasets::Fault kWhole = {.path = "a\nb.png", .reason = "is gone"};
const datasets::Fault kLine = {
    .path = "views.csv", .reason = "no class", .line = 3, .remedy = "name one"};

TEST(ToText, IsALineForPeople) {
  EXPECT_EQ(ToText(kWhole), "a\\nb.png: is gone");
  EXPECT_EQ(ToText(kLine, "note: "), "views.csv:3: note: no class (name one)");
}

TEST(ToJson, LeavesOutWhatIsNotKnown) {
  EXPECT_EQ(ToJson({kWhole, kLine}).dump(),
            R"([{"path":"a\nb.png","reason":"is gone"},)"
            R"({"path":"views.csv","line":3,"reason":"no class","remedy":"name one"}])");
  EXPECT_EQ(ToJson({}).dump(), "[]");
}

}  // namespace
}  // namespace handcraft::tools
