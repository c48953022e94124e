// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/console.h"

#include <limits>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace handcraft::tools {
namespace {

TEST(Console, WarnsOnTheErrorStreamAlone) {
  std::ostringstream out;
  std::ostringstream err;
  Console{out, err}.Warn("mind the gap");
  EXPECT_EQ(out.str(), "");
  EXPECT_EQ(err.str(), "handcraft: warning: mind the gap\n");
}

TEST(Console, WarnsOnOneLine) {
  std::ostringstream out;
  std::ostringstream err;
  Console{out, err}.Warn("a\nb.png");
  EXPECT_EQ(err.str(), "handcraft: warning: a\\nb.png\n");
}

TEST(Console, PrintsJsonInTheOrderGiven) {
  std::ostringstream out;
  std::ostringstream err;
  Console{out, err}.Print({{"z", 1}, {"a", "x"}});
  EXPECT_EQ(out.str(), "{\n  \"z\": 1,\n  \"a\": \"x\"\n}\n");
  EXPECT_EQ(err.str(), "");
}

TEST(Console, PrintsValidJsonForNanAndForeignBytes) {
  std::ostringstream out;
  std::ostringstream err;
  Console{out, err}.Print({{"nan", std::numeric_limits<double>::quiet_NaN()}, {"s", "a\xff"}});
  const auto json = nlohmann::json::parse(out.str());
  EXPECT_TRUE(json["nan"].is_null());
  EXPECT_EQ(json["s"], "a\uFFFD");
}

}  // namespace
}  // namespace handcraft::tools
