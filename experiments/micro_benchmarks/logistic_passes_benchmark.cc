// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// The passes over the design matrix that training a logistic regression is made of.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "lib/core/rng.h"
#include "lib/linear_algebra/single_threaded_blas.h"
#include "trainers/logistic_irls/column_moments.h"
#include "trainers/logistic_irls/hessian_factor.h"
#include "trainers/logistic_irls/objective.h"

namespace handcraft::logistic {
namespace {

constexpr std::size_t kNumRows = 16384;

// Normal features, labels by turns: no pass takes a shorter way for any data.
std::vector<float> RandomValues(std::size_t count) {
  Rng rng = Rng::Stream(1, "micro_benchmarks.logistic");
  std::vector<float> values(count);
  for (float& value : values) value = static_cast<float>(rng.Normal());
  return values;
}

std::vector<std::uint8_t> LabelsByTurns() {
  std::vector<std::uint8_t> labels(kNumRows);
  for (std::size_t i = 0; i < kNumRows; ++i) labels[i] = i % 2;
  return labels;
}

class Problem {
 public:
  explicit Problem(std::size_t num_features)
      : num_features_(num_features), values_(RandomValues(kNumRows * num_features)) {
    objective_.Evaluate(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(num_features) + 1), point_);
  }
  [[nodiscard]] DesignMatrix<float> X() const {
    return {.data = values_.data(),
            .num_samples = kNumRows,
            .num_features = num_features_,
            .stride = num_features_};
  }
  [[nodiscard]] const Objective& objective() const { return objective_; }
  [[nodiscard]] Point& point() { return point_; }
  [[nodiscard]] double NumElements() const { return static_cast<double>(values_.size()); }

 private:
  std::size_t num_features_;
  std::vector<float> values_;
  std::vector<std::uint8_t> labels_ = LabelsByTurns();
  ColumnMoments moments_ = ComputeColumnMoments(X(), 1);
  Objective objective_{X(), labels_, moments_, 0.0, 1};
  Point point_;
  SingleThreadedBlas single_threaded_blas_;
};

benchmark::Counter Rate(const benchmark::State& state, double amount) {
  return {amount * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate};
}

void FindMoments(benchmark::State& state) {
  const Problem problem(static_cast<std::size_t>(state.range(0)));
  for (auto iteration : state) benchmark::DoNotOptimize(ComputeColumnMoments(problem.X(), 1));
  state.counters["bytes_per_second"] = Rate(state, 4.0 * problem.NumElements());
}
BENCHMARK(FindMoments)->Arg(54)->Arg(500)->Unit(benchmark::kMillisecond);

void ValueAndGradient(benchmark::State& state) {
  Problem problem(static_cast<std::size_t>(state.range(0)));
  const Eigen::VectorXd theta = 0.01 * Eigen::VectorXd::Ones(state.range(0) + 1);
  for (auto iteration : state) problem.objective().Evaluate(theta, problem.point());
  state.counters["bytes_per_second"] = Rate(state, 4.0 * problem.NumElements());
}
BENCHMARK(ValueAndGradient)->Arg(54)->Arg(500)->Unit(benchmark::kMillisecond);

void Leverages(benchmark::State& state) {
  const Problem problem(static_cast<std::size_t>(state.range(0)));
  const Eigen::MatrixXd map = Eigen::MatrixXd::Ones(state.range(0) + 1, 8);
  for (auto iteration : state) benchmark::DoNotOptimize(problem.objective().SquaredNorms(map));
  state.counters["bytes_per_second"] = Rate(state, 4.0 * problem.NumElements());
}
BENCHMARK(Leverages)->Arg(54)->Arg(500)->Unit(benchmark::kMillisecond);

template <class Number>
void FormHessian(benchmark::State& state) {
  Problem problem(static_cast<std::size_t>(state.range(0)));
  for (auto iteration : state) {
    benchmark::DoNotOptimize(problem.objective().Hessian<Number>(problem.point()));
  }
  const auto size = static_cast<double>(state.range(0) + 1);
  state.counters["flops"] = Rate(state, double{kNumRows} * size * (size + 1.0));
}
BENCHMARK_TEMPLATE(FormHessian, float)->Arg(54)->Arg(500)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(FormHessian, double)->Arg(54)->Arg(500)->Unit(benchmark::kMillisecond);

void FactorAndSolve(benchmark::State& state) {
  Problem problem(static_cast<std::size_t>(state.range(0)));
  const Eigen::MatrixXd hessian = problem.objective().Hessian<double>(problem.point());
  for (auto iteration : state) {
    benchmark::DoNotOptimize(HessianFactor::Make(hessian, {})->Solve(problem.point().gradient));
  }
}
BENCHMARK(FactorAndSolve)->Arg(54)->Arg(500)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace handcraft::logistic
