// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// Expects `statement` to throw `ExceptionType` whose what() matches the gmock matcher, so that the
/// text people read is tested as well:
///   EXPECT_THROWS_MESSAGE(ReadFile("no"), Error, HasSubstr("No such file"));
#define EXPECT_THROWS_MESSAGE(statement, ExceptionType, matcher)              \
  do {                                                                        \
    std::string hc_message = "(nothing was thrown)";                          \
    bool hc_thrown = false;                                                   \
    try {                                                                     \
      static_cast<void>(statement);                                           \
    } catch (const ExceptionType& hc_exception) {                             \
      hc_thrown = true;                                                       \
      hc_message = hc_exception.what();                                       \
    }                                                                         \
    EXPECT_TRUE(hc_thrown) << "expected " #ExceptionType " from " #statement; \
    if (hc_thrown) {                                                          \
      EXPECT_THAT(hc_message, matcher);                                       \
    }                                                                         \
  } while (false)
