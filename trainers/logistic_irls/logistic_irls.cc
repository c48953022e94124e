// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/logistic_irls.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lib/core/binary_labels.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/linear_algebra/single_threaded_blas.h"
#include "trainers/logistic_irls/column_moments.h"
#include "trainers/logistic_irls/downhill_step.h"
#include "trainers/logistic_irls/hessian_factor.h"
#include "trainers/logistic_irls/hessian_policy.h"
#include "trainers/logistic_irls/newton_descent.h"
#include "trainers/logistic_irls/objective.h"
#include "trainers/logistic_irls/sketched_descent.h"

namespace handcraft::logistic {
namespace {

// Mean square change of the scores that a further Newton step would bring: at the end 1e-11 in
// the root, so that weights have converged and not the deviance alone.
constexpr double kFinalMeanSquareChange = 1e-22;
// Standard errors need W at the optimum: this bounds its relative error.
constexpr double kLargestChangeForStandardErrors = 1e-5;

template <class T>
void CheckInput(const DesignMatrix<T>& X, std::span<const std::uint8_t> labels) {
  HC_CHECK(X.stride >= X.num_features, X.stride, X.num_features);
  HC_CHECK(labels.size() == X.num_samples, labels.size(), X.num_samples);
  if (X.num_samples == 0 || X.num_features == 0) {
    throw Error(
        {.reason = fmt::format(
             "the design matrix is empty: {} samples, {} features", X.num_samples, X.num_features),
         .remedy = "give at least one sample of each class and one feature"});
  }
  static_cast<void>(CountPositive(labels));
}

// The model with an intercept alone, where a descent starts that is not told where.
Eigen::VectorXd NullModel(const Objective& objective) {
  Eigen::VectorXd theta =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(objective.NumFeatures()) + 1);
  const auto positive = static_cast<double>(objective.NumPositive());
  theta[theta.size() - 1] =
      std::log(positive / (static_cast<double>(objective.NumRows()) - positive));
  return theta;
}

// The options' weights as those of standardised features: s_j w_j and b + Σ w_j m_j.
Eigen::VectorXd InitialModel(const Options& options, const ColumnMoments& moments) {
  const auto p = static_cast<Eigen::Index>(options.initial_weights.size());
  Eigen::VectorXd theta(p + 1);
  theta[p] = options.initial_intercept;
  for (Eigen::Index j = 0; j < p; ++j) {
    const auto k = static_cast<std::size_t>(j);
    theta[j] = options.initial_weights[k] * moments.scale[k];
    theta[p] += options.initial_weights[k] * moments.mean[k];
  }
  HC_CHECK(theta.allFinite(), p);
  return theta;
}

// One training run: the stages share what they find out here.
class Training {
 public:
  Training(const Objective::AnyDesignMatrix& X,
           std::span<const std::uint8_t> labels,
           const ColumnMoments& moments,
           const Options& options)
      : moments_(moments),
        options_(options),
        objective_(X, labels, moments, options.ridge, options.num_threads),
        policy_(objective_, options.hessian_precision),
        newton_(objective_, policy_) {}

  Result Run();

 private:
  [[nodiscard]] std::size_t SketchSize() const;
  [[nodiscard]] DescentEnd Descend();
  [[nodiscard]] bool SketchedEnds(std::size_t size, std::optional<HessianFactor>& factor);
  void Count(const DescentReport& report);
  void Describe(DescentEnd end);
  void FillStandardErrors(const HessianFactor& factor);
  void FillWeights();

  const ColumnMoments& moments_;
  const Options& options_;
  Objective objective_;
  HessianPolicy policy_;
  NewtonDescent newton_;
  Point point_;
  Result result_;
};

// Rows of a sketched Hessian: 0 when it could not pay, that is when it would need above a third of
// the samples to have twenty a weight.
std::size_t Training::SketchSize() const {
  constexpr std::size_t kMinRowsPerWeight = 20;
  const std::size_t num_rows = objective_.NumRows();
  const auto share =
      static_cast<std::size_t>(options_.warm_start_share * static_cast<double>(num_rows));
  const std::size_t wanted = std::max(share, kMinRowsPerWeight * (objective_.NumFeatures() + 1));
  return share == 0 || wanted > num_rows / 3 ? 0 : wanted;
}

void Training::Count(const DescentReport& report) {
  result_.summary.iterations += report.iterations;
  result_.summary.step_halvings += report.step_halvings;
  Report(options_.progress,
         "logistic regression",
         static_cast<std::size_t>(result_.summary.iterations),
         0);
}

// The first stage, down to where one Newton step is left. True when the classes turn out separated.
// `factor` becomes the Hessian's at point_ when it had to be formed for the rank.
bool Training::SketchedEnds(std::size_t size, std::optional<HessianFactor>& factor) {
  constexpr double kMeanSquareChange = 1e-15;
  constexpr int kMaxSteps = 60;
  SketchedDescent sketched(objective_, policy_, size, options_.seed);
  sketched.Start(point_);
  if (const std::vector<Eigen::Index> aliased = policy_.aliased(); !aliased.empty()) {
    factor = policy_.Start(point_);
    if (policy_.aliased() != aliased) return false;  // the sketch lacks rank that X has
  }
  const Goal goal{.mean_square_change = kMeanSquareChange,
                  .max_iterations = std::min(kMaxSteps, options_.max_iterations)};
  const DescentReport report = sketched.Run(goal, point_);
  Count(report);
  result_.summary.warm_start_iterations = report.iterations;
  if (report.iterations > 0) factor.reset();
  // The one Newton step that is left takes a Hessian that then serves the standard errors.
  if (report.end == DescentEnd::kReached && options_.standard_errors) policy_.InsistOnDouble();
  return report.end == DescentEnd::kCompletelySeparated;
}

DescentEnd Training::Descend() {
  std::optional<HessianFactor> factor;
  if (const std::size_t size = SketchSize(); size > 0) {
    if (SketchedEnds(size, factor)) return DescentEnd::kCompletelySeparated;
  } else {
    factor = policy_.Start(point_);
  }
  const Goal goal{.gradient_norm = options_.gradient_tolerance,
                  .relative_deviance = options_.relative_deviance_tolerance,
                  .mean_square_change = kFinalMeanSquareChange,
                  .max_iterations = options_.max_iterations - result_.summary.iterations};
  const DescentReport report = newton_.Run(goal, point_, std::move(factor));
  Count(report);
  return report.end;
}

std::string RankDeficientMessage(std::size_t num_aliased, std::size_t num_features) {
  return fmt::format(
      "{} of {} features are linear combinations of earlier ones or of the "
      "intercept: their weights are 0, the others are optimal; drop those "
      "features or set a ridge",
      num_aliased,
      num_features);
}

void Training::Describe(DescentEnd end) {
  Summary& summary = result_.summary;
  const auto set = [&](Termination termination, std::string message, std::string advice = {}) {
    summary.termination = termination;
    summary.message = std::move(message);
    summary.advice = std::move(advice);
  };
  switch (end) {
    case DescentEnd::kReached:
      if (summary.aliased_features.empty()) {
        return set(Termination::kConverged,
                   fmt::format("converged in {} Newton steps on all samples", summary.iterations));
      }
      return set(Termination::kRankDeficient,
                 RankDeficientMessage(summary.aliased_features.size(), objective_.NumFeatures()));
    case DescentEnd::kIterationLimit:
      return set(Termination::kIterationLimit,
                 fmt::format("not converged after {} Newton steps: gradient norm {:.3g} a sample",
                             summary.iterations,
                             summary.gradient_norm),
                 "raise max_iterations");
    case DescentEnd::kCompletelySeparated:
      return set(Termination::kSeparated,
                 "complete separation: a plane tells the classes apart without a mistake, so the "
                 "weights would grow for ever",
                 "set a ridge or add samples");
    case DescentEnd::kQuasiSeparated:
      return set(
          Termination::kSeparated,
          "quasi-complete separation: along some direction no sample loses and some gain, so "
          "weights would grow for ever",
          "set a ridge, or drop the features with huge weights");
    case DescentEnd::kNoDescent:
      return set(
          Termination::kNumericalFailure,
          fmt::format("no step lowers the deviance any more, at gradient norm {:.3g} a sample",
                      summary.gradient_norm),
          "set a ridge, or the Hessian's precision to double");
  }
}

// Standard errors from the inverse Hessian at the optimum (the observed information, plus ridge),
// in raw units. The raw intercept is b − Σ w_j m_j / s_j: a linear form of θ.
void Training::FillStandardErrors(const HessianFactor& factor) {
  const auto p = static_cast<Eigen::Index>(objective_.NumFeatures());
  const Eigen::VectorXd variance = factor.InverseDiagonal();
  Eigen::VectorXd intercept_form(p + 1);
  result_.standard_errors.resize(objective_.NumFeatures());
  for (Eigen::Index j = 0; j < p; ++j) {
    const auto k = static_cast<std::size_t>(j);
    result_.standard_errors[k] = std::sqrt(variance[j]) / moments_.scale[k];
    intercept_form[j] = -moments_.mean[k] / moments_.scale[k];
  }
  intercept_form[p] = 1.0;
  result_.intercept_standard_error = std::sqrt(factor.InverseForm(intercept_form));
}

// Folds the standardisation in: w_j / s_j and b − Σ w_j m_j / s_j.
void Training::FillWeights() {
  result_.feature_mean = moments_.mean;
  result_.feature_scale = moments_.scale;
  result_.weights.resize(objective_.NumFeatures());
  result_.intercept = point_.theta[static_cast<Eigen::Index>(objective_.NumFeatures())];
  for (std::size_t j = 0; j < result_.weights.size(); ++j) {
    result_.weights[j] = point_.theta[static_cast<Eigen::Index>(j)] / moments_.scale[j];
    result_.intercept -= result_.weights[j] * moments_.mean[j];
  }
}

Result Training::Run() {
  objective_.Evaluate(NullModel(objective_), point_);
  Summary& summary = result_.summary;
  summary.num_samples = objective_.NumRows();
  summary.num_positive = objective_.NumPositive();
  summary.null_deviance = point_.deviance;
  if (!options_.initial_weights.empty()) {
    objective_.Evaluate(InitialModel(options_, moments_), point_);
  }

  const DescentEnd end = Descend();
  for (const Eigen::Index column : policy_.aliased()) {
    summary.aliased_features.push_back(static_cast<std::size_t>(column));
  }
  summary.rank = objective_.NumFeatures() + 1 - summary.aliased_features.size();
  summary.fell_back_to_double = policy_.fell_back_to_double();
  summary.deviance = point_.deviance;
  summary.aic = summary.deviance + 2.0 * static_cast<double>(summary.rank);
  summary.gradient_norm = point_.GradientNorm(policy_.aliased());
  summary.reciprocal_condition = newton_.reciprocal_condition();
  Describe(end);
  FillWeights();
  if (end == DescentEnd::kReached && options_.standard_errors) {
    if (const auto factor = newton_.ExactFactor(point_, kLargestChangeForStandardErrors)) {
      summary.reciprocal_condition = factor->reciprocal_condition();
      FillStandardErrors(*factor);
    }
  }
  return std::move(result_);
}

}  // namespace

std::string_view NameOf(Termination termination) noexcept {
  switch (termination) {
    case Termination::kNotRun:
      return "not_run";
    case Termination::kConverged:
      return "converged";
    case Termination::kIterationLimit:
      return "iteration_limit";
    case Termination::kSeparated:
      return "separated";
    case Termination::kRankDeficient:
      return "rank_deficient";
    case Termination::kNumericalFailure:
      return "numerical_failure";
  }
  return "unknown";
}

std::string_view NameOf(HessianPrecision precision) noexcept {
  switch (precision) {
    case HessianPrecision::kAuto:
      return "auto";
    case HessianPrecision::kSingle:
      return "single";
    case HessianPrecision::kDouble:
      return "double";
  }
  return "unknown";
}

void Options::Validate() const {
  const std::string name = "logistic::Options.";
  RequireOption(
      ridge >= 0.0 && std::isfinite(ridge), name + "ridge", ridge, "a finite number >= 0");
  RequireOption(max_iterations >= 1, name + "max_iterations", max_iterations, ">= 1");
  RequireOption(gradient_tolerance > 0.0, name + "gradient_tolerance", gradient_tolerance, "> 0");
  RequireOption(relative_deviance_tolerance > 0.0,
                name + "relative_deviance_tolerance",
                relative_deviance_tolerance,
                "> 0");
  RequireOption(warm_start_share >= 0.0 && warm_start_share < 1.0,
                name + "warm_start_share",
                warm_start_share,
                "in [0, 1)");
  RequireOption(num_threads >= 1, name + "num_threads", num_threads, ">= 1");
}

template <class T>
Result TrainLogistic(const DesignMatrix<T>& X,
                     std::span<const std::uint8_t> labels,
                     const Options& options) {
  options.Validate();
  CheckInput(X, labels);
  HC_CHECK(options.initial_weights.empty() || options.initial_weights.size() == X.num_features,
           options.initial_weights.size(),
           X.num_features);
  const SingleThreadedBlas single_threaded_blas;
  const ColumnMoments moments = ComputeColumnMoments(X, options.num_threads);
  const Objective::AnyDesignMatrix any = X;
  return Training(any, labels, moments, options).Run();
}

template Result TrainLogistic(const DesignMatrix<float>&,
                              std::span<const std::uint8_t>,
                              const Options&);
template Result TrainLogistic(const DesignMatrix<double>&,
                              std::span<const std::uint8_t>,
                              const Options&);

}  // namespace handcraft::logistic
