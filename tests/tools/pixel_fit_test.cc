// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/pixel_fit.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::Key;

class PixelFitTest : public ::testing::Test {
 protected:
  // Two features: the first tells the label, not without mistakes.
  static datasets::GraspPointSamples Draw() {
    Rng rng(3);
    datasets::GraspPointSamples samples;
    samples.num_features = 2;
    for (int i = 0; i < 400; ++i) {
      const auto label = static_cast<std::uint8_t>(i % 2);
      samples.features.push_back(static_cast<float>(label + rng.Normal()));
      samples.features.push_back(static_cast<float>(rng.Normal()));
      samples.labels.push_back(label);
    }
    return samples;
  }

  std::ostringstream out_;
  std::ostringstream err_;
  const Console console_{out_, err_};
  const std::vector<std::string> names_ = {"a", "b"};
};

TEST_F(PixelFitTest, OfBothMethodsIsAModelOfOneForm) {
  for (const FitMethod method : {FitMethod::kLogistic, FitMethod::kLda}) {
    PixelFitOptions options;
    options.method = method;
    const PixelFit fit = FitPixels(Draw(), names_, options, {.num_threads = 2}, console_);
    EXPECT_EQ(fit.algorithm, method == FitMethod::kLda ? "lda" : "logistic_irls");
    EXPECT_EQ(fit.num_samples, 400U);
    EXPECT_EQ(fit.num_positive, 200U);
    EXPECT_NEAR(fit.model.weights[0], 1.0, 0.3);  // the true log odds are x − 1/2
    EXPECT_NEAR(fit.model.intercept, -0.5, 0.3);
    EXPECT_LT(fit.deviance, fit.null_deviance);
    EXPECT_EQ(fit.metrics.at("train.num_samples"), "400");
    EXPECT_FALSE(fit.json.at("message").get<std::string>().empty());
    EXPECT_THAT(
        fit.hyper_parameters,
        ::testing::Contains(Key(method == FitMethod::kLda ? "lda.shrinkage" : "irls.ridge")));
  }
}

TEST_F(PixelFitTest, RefusesWhatGivesNoModel) {
  datasets::GraspPointSamples samples = Draw();
  for (std::size_t i = 0; i < 400; ++i) samples.features[2 * i + 1] = samples.features[2 * i];
  PixelFitOptions options;
  options.method = FitMethod::kLda;
  EXPECT_THROWS_MESSAGE(
      FitPixels(samples, names_, options, {}, console_), Error, HasSubstr("give --shrinkage auto"));
}

TEST(PixelFitOptionsTest, AreReadAndThoseOfTheOtherMethodRefused) {
  const auto parse = [](const std::string& line) {
    CLI::App app;
    PixelFitOptions options;
    AddPixelFitOptions(app, options);
    app.parse(line);
    RefuseOptionsOfOtherMethods(app, options);
    return options;
  };
  EXPECT_EQ(parse("").method, FitMethod::kLogistic);
  EXPECT_EQ(parse("--ridge 2").logistic.ridge, 2.0);
  const PixelFitOptions lda = parse("--method lda --prior 0.3");
  EXPECT_EQ(lda.method, FitMethod::kLda);
  EXPECT_EQ(lda.lda.positive_prior, 0.3);
  EXPECT_THROWS_MESSAGE(
      parse("--method lda --ridge 1"), Error, HasSubstr("--ridge is not read with --method lda"));
  EXPECT_THROWS_MESSAGE(
      parse("--prior 0.3"), Error, HasSubstr("--prior is not read with --method logistic"));
  EXPECT_THROW(parse("--method svm"), CLI::ValidationError);
}

}  // namespace
}  // namespace handcraft::tools
