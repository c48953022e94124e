// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/column_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::model_io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ColumnNames, ComeBackAsTheyWere) {
  ModelFile model;
  std::vector<std::uint8_t> joined = JoinColumnNames({"length_m", "größe", "a b"});
  model.tensors["column_names"] = {joined, {static_cast<std::int64_t>(joined.size())}};
  EXPECT_THAT(ColumnNamesOf(model), ElementsAre("length_m", "größe", "a b"));
}

TEST(ColumnNames, RefuseWhatCannotBeToldApartLater) {
  for (const std::string bad : {"", "two\nlines"}) {
    EXPECT_THROWS_MESSAGE(JoinColumnNames({"a", bad}),
                          Error,
                          HasSubstr("the name of column 2 is empty or has a line break"));
  }
  EXPECT_THROWS_MESSAGE(
      JoinColumnNames({"\xE9"}), Error, HasSubstr("the name of column 1 is not UTF-8"));
}

TEST(ColumnNames, AreNotThereInAModelOfPictures) {
  EXPECT_THROWS_MESSAGE(ColumnNamesOf(testing::SomeGraspPointModel("edges54")),
                        Error,
                        HasSubstr("give a model of kind logistic"));
}

}  // namespace
}  // namespace handcraft::model_io
