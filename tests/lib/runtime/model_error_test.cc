// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/model_error.h"

#include <string>

#include <gtest/gtest.h>

#include "lib/runtime/result.h"

namespace handcraft::runtime {
namespace {

TEST(MakeError, FormatsTheMessage) {
  const ModelError error = MakeError(HC_ERROR_FORMAT, 12, "found %d, expected %s", 3, "four");
  EXPECT_EQ(error.status, HC_ERROR_FORMAT);
  EXPECT_EQ(error.byte_offset, 12U);
  EXPECT_STREQ(error.message, "found 3, expected four");
}

TEST(MakeError, CutsALongMessageAndEndsIt) {
  const ModelError error = MakeError(HC_ERROR_FILE, 0, "%s", std::string(500, 'x').c_str());
  EXPECT_EQ(std::string(error.message), std::string(sizeof error.message - 1, 'x'));
}

TEST(Printable, KeepsPlainText) { EXPECT_STREQ(Printable("hc.kind 1").c_str(), "hc.kind 1"); }

TEST(Printable, HidesBytesThatCouldUpsetATerminal) {
  EXPECT_STREQ(Printable("a\x1B[2J\n\xC3\xA9").c_str(), "a?[2J???");
}

TEST(Printable, CutsLongText) {
  EXPECT_EQ(Printable(std::string(40, 'x')).c_str(), std::string(40, 'x'));
  EXPECT_EQ(Printable(std::string(41, 'x')).c_str(), std::string(40, 'x') + "...");
}

TEST(Result, HoldsAValueOrAnError) {
  const Result<std::string> value = std::string("v");
  EXPECT_TRUE(value.has_value());
  EXPECT_EQ(*value, "v");
  EXPECT_EQ(value->size(), 1U);

  const Result<std::string> error = MakeError(HC_ERROR_KIND, 1, "no");
  EXPECT_FALSE(error.has_value());
  EXPECT_FALSE(static_cast<bool>(error));
  EXPECT_EQ(error.error().status, HC_ERROR_KIND);
}

}  // namespace
}  // namespace handcraft::runtime
