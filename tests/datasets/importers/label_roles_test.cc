// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/label_roles.h"

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;

TEST(LabelRoles, GiveTheValueOfALabel) {
  const LabelRoles roles{.good = {"handle", "rim"}, .bad = {"blade"}, .dont_care = {"blur"}};
  roles.Validate();
  EXPECT_EQ(roles.ValueOf("rim"), kMaskGood);
  EXPECT_EQ(roles.ValueOf("blade"), kMaskBad);
  EXPECT_EQ(roles.ValueOf("blur"), kMaskDontCare);
  EXPECT_EQ(roles.ValueOf("Rim"), std::nullopt);
  EXPECT_EQ(LabelRoles().ValueOf("good"), kMaskGood);
}

TEST(LabelRoles, RefuseALabelWithTwoRoles) {
  for (const LabelRoles& roles : {LabelRoles{.good = {"a"}, .bad = {"a"}},
                                  LabelRoles{.good = {"a"}, .dont_care = {"b", "a"}},
                                  LabelRoles{.bad = {"a"}, .dont_care = {"a"}}}) {
    EXPECT_THROWS_MESSAGE(
        (roles.Validate(), 0), Error, HasSubstr("the label 'a' has two roles; it must be one"));
  }
}

TEST(LabelRoles, MustBeAmongTheLabels) {
  const LabelRoles roles{.good = {"handle"}, .dont_care = {"blur"}};
  roles.RequireAmong({"handle", "blur", "other"}, "set");
  EXPECT_THROWS_MESSAGE((roles.RequireAmong({"handle", "Blur"}, "set"), 0),
                        Error,
                        HasSubstr("set: nothing is labelled 'blur'; there are: 'Blur', 'handle'"));
  EXPECT_THROWS_MESSAGE((roles.RequireAmong({}, "set"), 0), Error, HasSubstr("there are: none"));
  std::set<std::string> many;
  for (int i = 0; i < 50; ++i) many.insert(std::to_string(i));
  EXPECT_THROWS_MESSAGE((roles.RequireAmong(many, "set"), 0), Error, HasSubstr(", and 20 more"));
}

}  // namespace
}  // namespace handcraft::datasets
