// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/fields.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft {
namespace {

struct SomeOptions {
  double ridge = 0.1;
  int rounds = -3;
  bool quick = true;
  std::string name = "a b";

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("ridge", ridge);
    visit("rounds", rounds);
    visit("quick", quick);
    visit("name", name);
  }
};

TEST(FieldsToText, ListsEveryFieldWithItsPrefix) {
  EXPECT_THAT(FieldsToText(SomeOptions{}, "train."),
              ::testing::ElementsAre(::testing::Pair("train.name", "a b"),
                                     ::testing::Pair("train.quick", "true"),
                                     ::testing::Pair("train.ridge", "0.1"),
                                     ::testing::Pair("train.rounds", "-3")));
}

TEST(NumberToText, ReadsBackAsTheSameNumber) {
  for (const double value : {1.0 / 3.0, 1e-300, -0.0, 6.02214076e23}) {
    EXPECT_EQ(std::stod(NumberToText(value)), value) << NumberToText(value);
  }
}

}  // namespace
}  // namespace handcraft
