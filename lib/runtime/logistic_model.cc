// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/logistic_model.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "lib/runtime/content_reader.h"

namespace handcraft::runtime {
namespace {

// § 6.2: rows, one after another, and their probabilities.
struct SelfTest {
  std::vector<double> rows;
  std::vector<double> expected;
  double tolerance = 0.0;
};

bool ReadSelfTest(ContentReader& reader, std::uint64_t num_features, SelfTest& test) {
  if (!reader.Read("selftest.input", {kAnyLength, num_features}, test.rows) ||
      !reader.Read("selftest.output", {test.rows.size() / num_features}, test.expected) ||
      !reader.ReadOne("selftest.tolerance", test.tolerance)) {
    return false;
  }
  if (test.tolerance > 0.0 && test.tolerance <= 0.1) return true;
  return reader.Fail(MakeError(HC_ERROR_CONTENT,
                               reader.OffsetOf("selftest.tolerance"),
                               "the tensor 'selftest.tolerance' holds %g; above 0 and at most 0.1 "
                               "was expected",
                               test.tolerance));
}

std::optional<ModelError> RunSelfTest(const LogisticModel& model, const SelfTest& test) {
  const std::size_t num_features = model.weights.size();
  for (std::size_t i = 0; i < test.expected.size(); ++i) {
    const std::span<const double> row(&test.rows[i * num_features], num_features);
    const double found = model.Probability(row);
    // A NaN fails as well.
    if (std::fabs(found - test.expected[i]) <= test.tolerance) continue;
    return MakeError(HC_ERROR_SELF_TEST,
                     kNoOffset,
                     "the self-test gives %.17g for row %zu where the model stores %.17g; train it "
                     "again with this version of Handcraft",
                     found,
                     i,
                     test.expected[i]);
  }
  return std::nullopt;
}

}  // namespace

double LogisticModel::Probability(std::span<const double> row) const noexcept {
  double z = intercept;
  for (std::size_t i = 0; i < weights.size(); ++i) z += weights[i] * row[i];
  // The exponent is never positive, so that nothing overflows.
  const double e = std::exp(-std::fabs(z));
  return z >= 0.0 ? 1.0 / (1.0 + e) : e / (1.0 + e);
}

Result<LogisticModel> LoadLogisticModel(const ParsedModel& parsed) {
  ContentReader reader(parsed);
  LogisticModel model;
  SelfTest test;
  std::vector<std::string> names;  // for people and table readers
  const bool complete = reader.Read("weights", {kAnyLength}, model.weights) &&
                        reader.ReadOne("intercept", model.intercept) &&
                        reader.CheckNormaliser(model.weights.size()) &&
                        reader.ReadNames("column_names", model.weights.size(), "weights", names) &&
                        ReadSelfTest(reader, model.weights.size(), test) &&
                        reader.RefuseUnknownTensors();
  if (!complete) return reader.error();
  if (const std::optional<ModelError> error = RunSelfTest(model, test)) return *error;
  return model;
}

}  // namespace handcraft::runtime
