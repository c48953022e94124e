// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// The trainer against R's glm and scikit-learn, on the tables of tests/data/trainers (see the
// scripts there). Six digits are asked for; deviances agree to rounding.

#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "tests/trainers/logistic_irls/problem.h"
#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::logistic {
namespace {

std::string ReadData(const std::string& name) {
  return ReadTextFile(std::string(HANDCRAFT_SOURCE_DIR) + "/tests/data/trainers/" + name);
}

std::vector<std::string> Split(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

Problem<double> ReadProblem(const std::string& name) {
  std::istringstream lines(ReadData("logistic_" + name + ".csv"));
  std::string line;
  std::getline(lines, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    rows.emplace_back();
    for (const std::string& word : Split(line)) rows.back().push_back(std::stod(word));
  }
  return ProblemOf(rows);
}

struct Term {
  double estimate;
  double standard_error;
};
using Reference = std::map<std::string, Term>;

// NA becomes not-a-number.
Reference ReadReference(const std::string& file) {
  std::istringstream lines(ReadData(file));
  std::string line;
  std::getline(lines, line);
  Reference reference;
  const auto number = [](const std::string& word) {
    return word == "NA" ? std::nan("") : std::stod(word);
  };
  while (std::getline(lines, line)) {
    const std::vector<std::string> words = Split(line);
    reference[words[0]] = {number(words[1]), number(words[2])};
  }
  return reference;
}

void ExpectRelative(double actual, double expected, double tolerance, const std::string& what) {
  EXPECT_NEAR(actual, expected, tolerance * std::abs(expected)) << what;
}

class GlmReference : public ::testing::TestWithParam<const char*> {};

TEST_P(GlmReference, AgreesWithRToSixDigits) {
  const std::string name = GetParam();
  const Problem<double> problem = ReadProblem(name);
  const Reference glm = ReadReference("logistic_" + name + "_glm.csv");
  const Result result = TrainLogistic(problem.X(), problem.labels, {});
  const Summary& summary = result.summary;
  EXPECT_LE(summary.gradient_norm, 1e-9);
  ExpectRelative(result.intercept, glm.at("(Intercept)").estimate, 1e-6, "intercept");
  ExpectRelative(
      result.intercept_standard_error, glm.at("(Intercept)").standard_error, 1e-6, "its error");
  std::size_t num_aliased = 0;
  for (std::size_t j = 0; j < problem.num_features; ++j) {
    const std::string term = "x" + std::to_string(j);
    if (std::isnan(glm.at(term).estimate)) {
      ++num_aliased;
      EXPECT_EQ(result.weights[j], 0.0) << term;
      EXPECT_TRUE(std::isnan(result.standard_errors[j])) << term;
      continue;
    }
    ExpectRelative(result.weights[j], glm.at(term).estimate, 1e-6, term);
    ExpectRelative(result.standard_errors[j], glm.at(term).standard_error, 1e-6, term + " error");
  }
  EXPECT_EQ(summary.aliased_features.size(), num_aliased);
  EXPECT_EQ(summary.termination,
            num_aliased == 0 ? Termination::kConverged : Termination::kRankDeficient);
  ExpectRelative(summary.deviance, glm.at("deviance").estimate, 1e-12, "deviance");
  ExpectRelative(summary.null_deviance, glm.at("null_deviance").estimate, 1e-12, "null deviance");
  ExpectRelative(summary.aic, glm.at("aic").estimate, 1e-12, "aic");
}

INSTANTIATE_TEST_SUITE_P(
    Tables,
    GlmReference,
    ::testing::Values("iris", "breast_w", "heart", "collinear", "decades", "aliased"),
    [](const auto& parameter) { return std::string(parameter.param); });

class RidgeReference : public ::testing::TestWithParam<const char*> {};

TEST_P(RidgeReference, AgreesWithScikitLearnToSixDigits) {
  const std::string name = GetParam();
  const Problem<double> problem = ReadProblem(name);
  const Reference reference = ReadReference("logistic_" + name + "_ridge.csv");
  const Result result = TrainLogistic(problem.X(), problem.labels, {.ridge = 2.0});
  EXPECT_EQ(result.summary.termination, Termination::kConverged);
  double intercept = result.intercept;  // back to standardised features
  for (std::size_t j = 0; j < problem.num_features; ++j) {
    intercept += result.weights[j] * result.feature_mean[j];
    const std::string term = "x" + std::to_string(j);
    ExpectRelative(
        result.weights[j] * result.feature_scale[j], reference.at(term).estimate, 1e-6, term);
  }
  ExpectRelative(intercept, reference.at("(Intercept)").estimate, 1e-6, "intercept");
}

INSTANTIATE_TEST_SUITE_P(Tables,
                         RidgeReference,
                         ::testing::Values("iris", "heart", "collinear"),
                         [](const auto& parameter) { return std::string(parameter.param); });

}  // namespace
}  // namespace handcraft::logistic
