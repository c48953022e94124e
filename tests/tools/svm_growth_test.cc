// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/svm_growth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"
#include "tools/svm_options.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::RunLine;

const std::string kBreast = HANDCRAFT_SOURCE_DIR "/datasets/samples/tables/breast_w.csv";

TEST(SvmGrowthOptions, GoTogetherAndNotWithWhatTheModelAnswers) {
  const auto parse = [](const std::string& line) {
    CLI::App app;
    svm::Options svm;
    SvmGrowth growth;
    AddSvmOptions(app, svm);
    AddSvmGrowthOptions(app, "Model", growth);
    app.parse(line);
    return growth;
  };
  EXPECT_EQ(parse("--add-class cup --to m --C 10").new_class, "cup");
  EXPECT_THROW(parse("--add-class cup"), CLI::RequiresError);
  EXPECT_THROW(parse("--to m"), CLI::RequiresError);
  EXPECT_THROW(parse("--add-class cup --to m --kernel rbf"), CLI::ExcludesError);
  EXPECT_THROW(parse("--add-class cup --to m --standardize"), CLI::ExcludesError);
}

TEST(LabelsAmong, KeepsTheOrderOfTheModel) {
  EXPECT_THAT(LabelsAmong({"mug", "can", "cup"}, {"can", "cup", "mug", "can"}, "t.csv").values,
              ElementsAre(1U, 2U, 0U, 1U));
}

TEST(LabelsAmong, RefusesOtherLabelsAndMissingClasses) {
  EXPECT_THROWS_MESSAGE(static_cast<void>(LabelsAmong({"mug", "can"}, {"can", "pan"}, "t.csv")),
                        Error,
                        HasSubstr("t.csv: 'pan' is not one of the classes mug, can"));
  EXPECT_THROWS_MESSAGE(static_cast<void>(LabelsAmong({"mug", "can"}, {"can"}, "t.csv")),
                        Error,
                        HasSubstr("t.csv: no samples of the class 'mug'"));
}

TEST(GrowingSvm, KnowsWhatTheModelWasTrainedWith) {
  const TemporaryDirectory folder;
  const std::string model = (folder / "m").string();
  ASSERT_EQ(
      RunLine("train svm " + kBreast +
              " --label class --kernel poly --degree 2 --coef0 1 --standardize --out " + model)
          .code,
      0);
  const GrowingSvm growing = ReadGrowingSvm({.new_class = "neither", .model = model});
  EXPECT_EQ(growing.names.classes.back(), "neither");
  const svm::Options options = growing.OptionsOf({.kernel = features::SimilarityType::kRbf});
  EXPECT_EQ(options.kernel, features::SimilarityType::kPolynomial);
  EXPECT_EQ(options.degree, 2);
  EXPECT_EQ(options.coef0, 1.0);
  EXPECT_TRUE(options.standardize);
}

TEST(GrowingSvm, RefusesAClassThatIsThereAndOtherModels) {
  const TemporaryDirectory folder;
  const std::string model = (folder / "m").string();
  ASSERT_EQ(RunLine("train svm " + kBreast + " --label class --out " + model).code, 0);
  const std::string label = ReadGrowingSvm({.new_class = "x", .model = model}).names.classes[0];
  EXPECT_THROWS_MESSAGE(static_cast<void>(ReadGrowingSvm({.new_class = label, .model = model})),
                        Error,
                        HasSubstr("the model has the class '" + label + "' already"));
  ASSERT_EQ(RunLine("train logistic " + kBreast + " --label class --out " + model).code, 0);
  EXPECT_THROWS_MESSAGE(static_cast<void>(ReadGrowingSvm({.new_class = "x", .model = model})),
                        Error,
                        HasSubstr("not of kind svm"));
  EXPECT_THROW(static_cast<void>(ReadGrowingSvm({.new_class = "x", .model = "missing"})), Error);
}

}  // namespace
}  // namespace handcraft::tools
