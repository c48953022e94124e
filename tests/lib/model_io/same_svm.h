// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include "lib/model_io/svm_models.h"

namespace handcraft::testing {

/// Expects every number of two models to be the same.
inline void ExpectSame(const model_io::SvmModel& a, const model_io::SvmModel& b) {
  EXPECT_EQ(a.similarity.type, b.similarity.type);
  EXPECT_EQ(a.similarity.degree, b.similarity.degree);
  EXPECT_EQ(a.similarity.gamma, b.similarity.gamma);
  EXPECT_EQ(a.similarity.coef0, b.similarity.coef0);
  EXPECT_EQ(a.scheme, b.scheme);
  EXPECT_EQ(a.num_classes, b.num_classes);
  EXPECT_EQ(a.feature_mean, b.feature_mean);
  EXPECT_EQ(a.feature_scale, b.feature_scale);
  EXPECT_EQ(a.support_vectors, b.support_vectors);
  EXPECT_EQ(a.single_precision, b.single_precision);
  EXPECT_EQ(a.support_classes, b.support_classes);
  EXPECT_EQ(a.machine_begins, b.machine_begins);
  EXPECT_EQ(a.machine_supports, b.machine_supports);
  EXPECT_EQ(a.dual_coefficients, b.dual_coefficients);
  EXPECT_EQ(a.intercepts, b.intercepts);
  EXPECT_EQ(a.rejection_threshold, b.rejection_threshold);
}

}  // namespace handcraft::testing
