// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "trainers/svm/gram_matrix.h"
#include "trainers/svm/svm.h"

namespace handcraft::svm {

/// What models say about samples that they were trained without.
struct CrossValidation {
  std::vector<std::uint32_t> predicted = {};  ///< a class for each row of X
  std::vector<double> margins = {};           ///< features::ClassVote.margin of each row
  std::size_t num_correct = 0;
  double accuracy = 0.0;         ///< num_correct / rows
  std::size_t num_machines = 0;  ///< that were trained
  std::size_t iterations = 0;    ///< of all of them
  bool converged = true;         ///< all of them
};

/// A fold for each of `num_samples` rows: every row is a fold of its own.
[[nodiscard]] std::vector<std::uint32_t> LeaveOneOutFolds(std::size_t num_samples);

/// `num_folds` folds that each hold the same share of every class, or differ by one row: the i-th
/// row of a class is in fold i modulo num_folds. Throws Error(kUsage) unless num_folds is at least
/// 2 and no more than the rows of the smallest class.
[[nodiscard]] std::vector<std::uint32_t> StratifiedFolds(std::span<const std::uint32_t> classes,
                                                         std::size_t num_folds);

/// Predicts each fold by a model of the other folds, over one Gram matrix. A machine is trained
/// again only for the folds that hold samples of its classes: leaving one of n classes' samples out
/// trains n − 1 pairs, and the others are those of all samples. Every machine is, bit for bit, the
/// one that training on the fold's complement gives (the normaliser apart, which is that of all
/// samples).
///
/// `folds`: the fold of each row of X, in any numbering; put rows of one object into one fold.
/// `gram` is that of `samples`. Memory: a decision value a machine and row. The number of threads
/// changes no bit. Throws Error(kBadInput) when a fold holds a whole class.
[[nodiscard]] CrossValidation CrossValidate(const SampleMatrix& gram,
                                            const Samples& samples,
                                            std::span<const std::uint32_t> folds,
                                            const Options& options);

}  // namespace handcraft::svm
