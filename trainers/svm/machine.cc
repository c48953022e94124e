// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/machine.h"

#include <algorithm>
#include <numeric>

namespace handcraft::svm {
namespace {

struct Pair {
  std::size_t first;
  std::size_t second;
};

Pair PairOf(std::size_t machine) noexcept {
  std::size_t second = 1;
  while (features::PairIndex(0, second + 1) <= machine) ++second;
  return {.first = machine - features::PairIndex(0, second), .second = second};
}

void AddRange(std::size_t begin, std::size_t end, std::vector<std::size_t>& members) {
  for (std::size_t i = begin; i < end; ++i) members.push_back(i);
}

}  // namespace

double DecisionValue(const Machine& machine, const double* gram_row) noexcept {
  double value = machine.intercept;
  for (std::size_t k = 0; k < machine.support.size(); ++k) {
    value += machine.coefficients[k] * gram_row[machine.support[k]];
  }
  return value;
}

MachineProblem::MachineProblem(const SampleMatrix& gram,
                               const Samples& samples,
                               features::ClassScheme scheme,
                               std::size_t machine) {
  const std::vector<std::size_t>& begins = samples.class_begins;
  const bool by_pairs =
      scheme == features::ClassScheme::kOneAgainstOne || samples.NumClasses() == 2;
  std::size_t positive = machine;
  if (by_pairs) {
    const Pair pair = PairOf(machine);
    positive = pair.first;
    AddRange(begins[pair.first], begins[pair.first + 1], members_);
    AddRange(begins[pair.second], begins[pair.second + 1], members_);
  } else {
    AddRange(0, samples.NumSamples(), members_);
  }
  y_.reserve(members_.size());
  for (const std::size_t i : members_) {
    y_.push_back(i >= begins[positive] && i < begins[positive + 1] ? 1.0 : -1.0);
  }
  if (members_.back() - members_.front() + 1 == members_.size()) {
    view_ = gram.View(members_.front(), members_.back() + 1);
    return;
  }
  gathered_.reserve(members_.size() * members_.size());
  for (const std::size_t i : members_) {
    for (const std::size_t k : members_) gathered_.push_back(gram.Row(i)[k]);
  }
  view_ = {.data = gathered_.data(), .size = members_.size(), .stride = members_.size()};
}

Machine MachineProblem::Train(double penalty,
                              const SmoOptions& options,
                              std::span<const std::uint8_t> left_out) const {
  std::vector<double> limits(members_.size(), penalty);
  for (std::size_t k = 0; k < members_.size() && !left_out.empty(); ++k) {
    if (left_out[members_[k]] != 0) limits[k] = 0.0;
  }
  const SmoResult solution = SolveDual(view_, y_, limits, options);
  Machine machine{.support = {},
                  .coefficients = {},
                  .intercept = solution.intercept,
                  .iterations = solution.iterations,
                  .violation = solution.violation,
                  .converged = solution.converged};
  for (std::size_t k = 0; k < members_.size(); ++k) {
    if (solution.coefficients[k] == 0.0) continue;
    machine.support.push_back(members_[k]);
    machine.coefficients.push_back(solution.coefficients[k]);
  }
  return machine;
}

}  // namespace handcraft::svm
