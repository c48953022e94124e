// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/logistic_options.h"

#include <gmock/gmock.h>

namespace handcraft::tools {
namespace {

logistic::Options Parse(const std::string& line) {
  CLI::App app;
  logistic::Options options;
  AddLogisticOptions(app, options);
  app.parse(line);
  return options;
}

TEST(LogisticOptions, KeepTheTrainersDefaults) {
  const logistic::Options defaults;
  const logistic::Options options = Parse("");
  EXPECT_EQ(options.ridge, defaults.ridge);
  EXPECT_EQ(options.max_iterations, defaults.max_iterations);
  EXPECT_EQ(options.gradient_tolerance, defaults.gradient_tolerance);
  EXPECT_EQ(options.warm_start_share, defaults.warm_start_share);
  EXPECT_EQ(options.hessian_precision, defaults.hessian_precision);
}

TEST(LogisticOptions, AreTaken) {
  const logistic::Options options = Parse(
      "--ridge 0.5 --max-iterations 7 --gradient-tolerance 1e-6 --warm-start 0 --hessian double");
  EXPECT_EQ(options.ridge, 0.5);
  EXPECT_EQ(options.max_iterations, 7);
  EXPECT_EQ(options.gradient_tolerance, 1e-6);
  EXPECT_EQ(options.warm_start_share, 0.0);
  EXPECT_EQ(options.hessian_precision, logistic::HessianPrecision::kDouble);
}

TEST(LogisticOptions, RefuseAnUnknownPrecision) {
  EXPECT_THROW(Parse("--hessian half"), CLI::ValidationError);
}

}  // namespace
}  // namespace handcraft::tools
