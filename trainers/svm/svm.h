// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "lib/core/design_matrix.h"
#include "lib/core/progress.h"
#include "lib/features/class_vote.h"
#include "lib/features/similarity.h"
#include "lib/model_io/svm_model.h"
#include "trainers/svm/smo.h"

namespace handcraft::svm {

/// "one_against_one" or "one_against_all".
[[nodiscard]] std::string_view NameOf(features::ClassScheme scheme) noexcept;

struct Options {
  features::SimilarityType kernel = features::SimilarityType::kPolynomial;
  int degree = 3;        ///< of the polynomial, ≥ 1
  double gamma = 0.0;    ///< of polynomial and rbf, > 0; 0: 1 / num_features
  double coef0 = 0.0;    ///< of the polynomial, ≥ 0
  double penalty = 1.0;  ///< C > 0: the limit of every |dual coefficient|
  features::ClassScheme scheme = features::ClassScheme::kOneAgainstOne;
  bool standardize = false;  ///< features to mean 0 and standard deviation 1
  SmoOptions smo = {};
  int num_threads = 1;  ///< ≥ 1; changes no bit of the result
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  /// The kernel function for samples of so many features.
  [[nodiscard]] features::Similarity SimilarityFor(std::size_t num_features) const noexcept;

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("kernel", features::NameOf(kernel));
    visit("degree", degree);
    visit("gamma", gamma);
    visit("coef0", coef0);
    visit("penalty", penalty);
    visit("scheme", NameOf(scheme));
    visit("standardize", standardize);
    visit("tolerance", smo.tolerance);
    visit("max_iterations", smo.max_iterations);
  }
};

enum class Termination : std::uint8_t {
  kNotRun,
  kConverged,
  kIterationLimit,  ///< a machine did not reach the tolerance; its coefficients are the last ones
};
[[nodiscard]] std::string_view NameOf(Termination termination) noexcept;

struct Summary {
  Termination termination = Termination::kNotRun;
  std::string message = "the trainer was not called";
  std::size_t num_samples = 0;
  std::size_t num_classes = 0;
  std::size_t num_machines = 0;  ///< trained in this call
  std::size_t num_support_vectors = 0;
  std::size_t iterations = 0;  ///< of all machines together
  double violation = 0.0;      ///< the largest of a machine
};

struct Result {
  model_io::SvmModel model;
  Summary summary;
};

/// Support vector machines of several classes, one against one (Knerr et al. 1990; the
/// dissertation's choice, section 4.2.1) or one against all. `classes`: the class of each row of X,
/// from 0; every number up to the largest occurs. The Gram matrix is computed once and shared by
/// all machines.
///
/// The model's support vectors are in X's precision. Memory: X once more in double, two matrices of
/// num_samples² doubles (at most 2 GiB each), and one of a pair's samples a thread. Deterministic:
/// the number of threads changes no bit. Throws Error(kUsage) for options out of range,
/// Error(kBadInput) as PrepareSamples, ComputeInnerProducts and ComputeGram do. Reaching the limit
/// of iterations is a result, not an exception. Source: docs/methods/support_vector_machine.md.
template <class T>
[[nodiscard]] Result TrainSvm(const DesignMatrix<T>& X,
                              std::span<const std::uint32_t> classes,
                              const Options& options = {});

/// Adds class number model.num_classes to a one-against-one model by training its pairs alone. `X`
/// holds samples of all classes (of the old ones the training samples, or the model's support
/// vectors if there is nothing else). Normaliser, kernel and scheme are the model's, what `options`
/// says of them is not read; every array of the old model is, bit for bit, the beginning of the new
/// one's. A rejection threshold is dropped: it was set without the new class. Throws Error(kUsage)
/// for a model that is not one against one or has other features, else as TrainSvm.
template <class T>
[[nodiscard]] Result AddClass(const model_io::SvmModel& model,
                              const DesignMatrix<T>& X,
                              std::span<const std::uint32_t> classes,
                              const Options& options = {});

extern template Result TrainSvm(const DesignMatrix<float>&,
                                std::span<const std::uint32_t>,
                                const Options&);
extern template Result TrainSvm(const DesignMatrix<double>&,
                                std::span<const std::uint32_t>,
                                const Options&);
extern template Result AddClass(const model_io::SvmModel&,
                                const DesignMatrix<float>&,
                                std::span<const std::uint32_t>,
                                const Options&);
extern template Result AddClass(const model_io::SvmModel&,
                                const DesignMatrix<double>&,
                                std::span<const std::uint32_t>,
                                const Options&);

}  // namespace handcraft::svm
