// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "lib/core/design_matrix.h"
#include "trainers/svm/cross_validation.h"
#include "trainers/svm/grid_search.h"
#include "trainers/svm/svm.h"

namespace handcraft::tools {

/// How a command fits a support vector machine to its samples.
struct SvmFitOptions {
  svm::Options svm = {};
  std::vector<std::string> search = {};  ///< NAME=VALUE,VALUE…; empty: the options as they are
  std::size_t num_folds = 0;             ///< of cross-validation; 0: none
};

/// AddSvmOptions, and --folds and --search.
void AddSvmFitOptions(CLI::App& command, SvmFitOptions& options);

/// The values of --search; what it does not name is as in `base`. Names: kernel, degree, gamma,
/// coef0, C. Throws Error(kUsage) for another name, one given twice, and a value that is none.
[[nodiscard]] svm::Grid ParseGrid(const std::vector<std::string>& search, const svm::Options& base);

struct SvmFit {
  svm::Result result = {};
  svm::Options options = {};                          ///< the best of those searched
  std::optional<svm::CrossValidation> held_out = {};  ///< of these options; none without folds
  std::size_t num_tried = 1;                          ///< combinations of options
};

/// Trains on all samples with the options that predict most samples rightly in cross-validation
/// (of equal ones the first), or with those given if there is nothing to search. Throws
/// Error(kUsage) for --search without --folds, Error(kNoResult) when a machine does not converge,
/// else as svm::TrainSvm and svm::SearchGridOfRows.
template <class T>
[[nodiscard]] SvmFit FitSvm(const DesignMatrix<T>& X,
                            std::span<const std::uint32_t> classes,
                            const SvmFitOptions& options);
extern template SvmFit FitSvm(const DesignMatrix<float>&,
                              std::span<const std::uint32_t>,
                              const SvmFitOptions&);
extern template SvmFit FitSvm(const DesignMatrix<double>&,
                              std::span<const std::uint32_t>,
                              const SvmFitOptions&);

}  // namespace handcraft::tools
