// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/core/design_matrix.h"
#include "lib/model_io/svm_model.h"
#include "trainers/svm/cross_validation.h"
#include "trainers/svm/svm.h"

namespace handcraft::svm {

/// The margin (features::ClassVote) of every row of X, raw numbers in the columns of the model, to
/// rounding that of the runtime. A row with a number that is not finite has a margin that is not.
/// Memory: X and the support vectors once more in double. The number of threads changes no bit.
/// Throws Error(kUsage) when X has other columns.
template <class T>
[[nodiscard]] std::vector<double> MarginsOf(const model_io::SvmModel& model,
                                            const DesignMatrix<T>& X,
                                            int num_threads = 1);
extern template std::vector<double> MarginsOf(const model_io::SvmModel&,
                                              const DesignMatrix<float>&,
                                              int);
extern template std::vector<double> MarginsOf(const model_io::SvmModel&,
                                              const DesignMatrix<double>&,
                                              int);

/// CrossValidate of rows with the normaliser, kernel and scheme of a model; of `options` the
/// penalty, the solver's and the threads are read. Throws as PrepareSamples, ComputeInnerProducts
/// and ComputeGram do besides.
template <class T>
[[nodiscard]] CrossValidation CrossValidateLike(const model_io::SvmModel& model,
                                                const DesignMatrix<T>& X,
                                                std::span<const std::uint32_t> classes,
                                                std::span<const std::uint32_t> folds,
                                                const Options& options);
extern template CrossValidation CrossValidateLike(const model_io::SvmModel&,
                                                  const DesignMatrix<float>&,
                                                  std::span<const std::uint32_t>,
                                                  std::span<const std::uint32_t>,
                                                  const Options&);
extern template CrossValidation CrossValidateLike(const model_io::SvmModel&,
                                                  const DesignMatrix<double>&,
                                                  std::span<const std::uint32_t>,
                                                  std::span<const std::uint32_t>,
                                                  const Options&);

}  // namespace handcraft::svm
