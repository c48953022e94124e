// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>

namespace handcraft::svm {

/// From where on a sample is taken for none of the classes.
struct Rejection {
  double threshold = 0.0;          ///< a margin below it is rejected
  double false_rejection = 0.0;    ///< share of known samples that are rejected
  double false_acceptance = 0.0;   ///< share of novel samples that are not
  double balanced_accuracy = 0.0;  ///< 1 − the mean of the two
};

/// The threshold with the largest balanced accuracy between margins of samples of known classes and
/// of novel objects, neither seen in training: those of CrossValidate, and of a model on objects of
/// no class. Thresholds lie halfway between neighbouring margins; of equally good ones it is the
/// lowest, which rejects fewest known samples. O(n log n); deterministic.
/// Throws Error(kBadInput) when either list is empty or holds a number that is not finite.
[[nodiscard]] Rejection CalibrateRejection(std::span<const double> known_margins,
                                           std::span<const double> novel_margins);

}  // namespace handcraft::svm
