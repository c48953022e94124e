// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/features/class_vote.h"
#include "trainers/svm/gram_matrix.h"
#include "trainers/svm/smo.h"

namespace handcraft::svm {

/// A trained two-class machine: f(x) = intercept + Σ_k coefficients[k] · K(x_support[k], x).
struct Machine {
  std::vector<std::size_t> support = {};  ///< numbers of samples, ascending
  std::vector<double> coefficients = {};  ///< none is 0
  double intercept = 0.0;
  std::size_t iterations = 0;
  double violation = 0.0;
  bool converged = false;
};

/// The decision value of a sample whose row of the Gram matrix this is.
[[nodiscard]] double DecisionValue(const Machine& machine, const double* gram_row) noexcept;

/// The two-class problem of one machine, whose part of the Gram matrix is gathered once for all the
/// folds that are left out of it.
class MachineProblem {
 public:
  /// One against one: machine features::PairIndex(a, b), positive for a; one against all: class
  /// against rest. `gram` and `samples` outlive this object.
  MachineProblem(const SampleMatrix& gram,
                 const Samples& samples,
                 features::ClassScheme scheme,
                 std::size_t machine);

  /// The samples it is trained on: of the pair's first class, then of its second; or all.
  [[nodiscard]] std::span<const std::size_t> Members() const noexcept { return members_; }

  /// Trains it on the members whose byte in `left_out` (one a sample; empty: none) is 0, each with
  /// the limit `penalty`. Bit for bit what training on those samples alone gives.
  [[nodiscard]] Machine Train(double penalty,
                              const SmoOptions& options,
                              std::span<const std::uint8_t> left_out = {}) const;

 private:
  std::vector<std::size_t> members_ = {};
  std::vector<double> y_ = {};
  std::vector<double> gathered_ = {};  // empty when the members lie side by side in the Gram matrix
  KernelView view_;
};

}  // namespace handcraft::svm
