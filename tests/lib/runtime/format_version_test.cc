// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/format_version.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::runtime {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(CheckFormatVersion, TakesThisMajorNumber) {
  EXPECT_FALSE(CheckFormatVersion("1.0", ""));
  EXPECT_FALSE(CheckFormatVersion("1.7", ""));
  EXPECT_FALSE(CheckFormatVersion("1.12", "  "));
}

TEST(CheckFormatVersion, NamesBothVersionsAndTheFix) {
  const auto newer = CheckFormatVersion("3.1", "");
  ASSERT_TRUE(newer);
  EXPECT_EQ(newer->status, HC_ERROR_VERSION);
  EXPECT_THAT(newer->message,
              AllOf(HasSubstr("has format 3.1"),
                    HasSubstr(std::string("Handcraft ") + hc_version() + " reads format 1.0"),
                    HasSubstr("install a newer Handcraft runtime")));

  const auto older = CheckFormatVersion("0.9", "");
  ASSERT_TRUE(older);
  EXPECT_EQ(older->status, HC_ERROR_VERSION);
  EXPECT_THAT(older->message, HasSubstr("train the model again"));
}

TEST(CheckFormatVersion, RefusesWhatIsNoVersion) {
  for (const std::string_view text : {"",
                                      "1",
                                      "1.",
                                      ".1",
                                      "01.0",
                                      "1.00",
                                      "1.0.0",
                                      "-1.0",
                                      "1.x",
                                      " 1.0",
                                      "1,0",
                                      "99999999999.0"}) {
    const auto error = CheckFormatVersion(text, "");
    ASSERT_TRUE(error) << text;
    EXPECT_EQ(error->status, HC_ERROR_FORMAT) << text;
    EXPECT_THAT(error->message, HasSubstr("hc.format")) << text;
  }
}

TEST(CheckFormatVersion, NamesAFeatureItDoesNotKnow) {
  const auto error = CheckFormatVersion("1.4", " sparse_weights other");
  ASSERT_TRUE(error);
  EXPECT_EQ(error->status, HC_ERROR_VERSION);
  EXPECT_THAT(error->message, HasSubstr("requires 'sparse_weights', which Handcraft"));
}

}  // namespace
}  // namespace handcraft::runtime
