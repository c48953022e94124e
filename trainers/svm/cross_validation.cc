// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/cross_validation.h"

#include <algorithm>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/core/parallel.h"
#include "lib/features/class_vote.h"
#include "trainers/svm/machine.h"

namespace handcraft::svm {
namespace {

// The samples of each fold, ascending; folds in the order of their numbers.
std::vector<std::vector<std::size_t>> SamplesOfFolds(const Samples& samples,
                                                     std::span<const std::uint32_t> folds) {
  std::map<std::uint32_t, std::vector<std::size_t>> by_number;
  for (std::size_t i = 0; i < samples.NumSamples(); ++i) {
    by_number[folds[samples.rows[i]]].push_back(i);
  }
  std::vector<std::vector<std::size_t>> members;
  members.reserve(by_number.size());
  for (auto& [number, fold] : by_number) {
    std::vector<std::size_t> counts(samples.NumClasses(), 0);
    for (const std::size_t i : fold) ++counts[samples.ClassOf(i)];
    for (std::size_t c = 0; c < counts.size(); ++c) {
      if (counts[c] < samples.class_begins[c + 1] - samples.class_begins[c]) continue;
      throw Error(
          {.kind = Error::Kind::kBadInput,
           .reason = fmt::format("fold {} holds all {} samples of class {} (counted from 0): "
                                 "nothing is left to learn the class from",
                                 number,
                                 counts[c],
                                 c),
           .remedy = "give more samples of the class, or other folds"});
    }
    members.push_back(std::move(fold));
  }
  return members;
}

// What one machine says about every sample when it has not seen the sample's fold.
struct HeldOutValues {
  std::vector<double> values;
  std::size_t num_machines = 0;
  std::size_t iterations = 0;
  bool converged = true;
};

HeldOutValues ValuesOf(const MachineProblem& problem,
                       const SampleMatrix& gram,
                       const std::vector<std::vector<std::size_t>>& folds,
                       const Options& options) {
  HeldOutValues held_out;
  held_out.values.resize(gram.size);
  const auto train = [&](std::span<const std::uint8_t> left_out) {
    Machine machine = problem.Train(options.penalty, options.smo, left_out);
    ++held_out.num_machines;
    held_out.iterations += machine.iterations;
    held_out.converged = held_out.converged && machine.converged;
    return machine;
  };
  const Machine whole = train({});
  std::vector<std::uint8_t> is_member(gram.size, 0);
  for (const std::size_t i : problem.Members()) is_member[i] = 1;
  std::vector<std::uint8_t> left_out(gram.size, 0);
  for (const std::vector<std::size_t>& fold : folds) {
    const bool touched =
        std::any_of(fold.begin(), fold.end(), [&](auto i) { return is_member[i] != 0; });
    Machine without;
    if (touched) {
      for (const std::size_t i : fold) left_out[i] = 1;
      without = train(left_out);
      for (const std::size_t i : fold) left_out[i] = 0;
    }
    for (const std::size_t i : fold) {
      held_out.values[i] = DecisionValue(touched ? without : whole, gram.Row(i));
    }
  }
  return held_out;
}

}  // namespace

std::vector<std::uint32_t> LeaveOneOutFolds(std::size_t num_samples) {
  std::vector<std::uint32_t> folds(num_samples);
  std::iota(folds.begin(), folds.end(), 0U);
  return folds;
}

std::vector<std::uint32_t> StratifiedFolds(std::span<const std::uint32_t> classes,
                                           std::size_t num_folds) {
  std::map<std::uint32_t, std::size_t> counts;
  for (const std::uint32_t c : classes) ++counts[c];
  std::size_t fewest = classes.size();
  for (const auto& [c, count] : counts) fewest = std::min(fewest, count);
  RequireOption(num_folds >= 2 && num_folds <= fewest,
                "the number of folds",
                num_folds,
                fmt::format("from 2 to {}, the rows of the smallest class", fewest));
  std::map<std::uint32_t, std::size_t> next;
  std::vector<std::uint32_t> folds;
  folds.reserve(classes.size());
  for (const std::uint32_t c : classes) {
    folds.push_back(static_cast<std::uint32_t>(next[c]++ % num_folds));
  }
  return folds;
}

CrossValidation CrossValidate(const SampleMatrix& gram,
                              const Samples& samples,
                              std::span<const std::uint32_t> folds,
                              const Options& options) {
  options.Validate();
  const std::size_t n = samples.NumSamples();
  HC_CHECK(folds.size() == n && gram.size == n, folds.size(), gram.size, n);
  const std::vector<std::vector<std::size_t>> fold_samples = SamplesOfFolds(samples, folds);
  std::vector<HeldOutValues> machines(features::NumMachines(options.scheme, samples.NumClasses()));
  ParallelFor(machines.size(), options.num_threads, [&](std::size_t m) {
    machines[m] =
        ValuesOf(MachineProblem(gram, samples, options.scheme, m), gram, fold_samples, options);
  });
  CrossValidation validation{.predicted = std::vector<std::uint32_t>(n),
                             .margins = std::vector<double>(n)};
  for (const HeldOutValues& machine : machines) {
    validation.num_machines += machine.num_machines;
    validation.iterations += machine.iterations;
    validation.converged = validation.converged && machine.converged;
  }
  std::vector<double> values(machines.size());
  std::vector<std::int32_t> votes(samples.NumClasses());
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t m = 0; m < machines.size(); ++m) values[m] = machines[m].values[i];
    const features::ClassVote vote = features::VoteForClass(options.scheme, values, votes);
    validation.predicted[samples.rows[i]] = static_cast<std::uint32_t>(vote.winner);
    validation.margins[samples.rows[i]] = vote.margin;
    validation.num_correct += vote.winner == samples.ClassOf(i) ? 1 : 0;
  }
  validation.accuracy = static_cast<double>(validation.num_correct) / static_cast<double>(n);
  return validation;
}

}  // namespace handcraft::svm
