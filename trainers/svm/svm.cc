// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/svm.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/core/parallel.h"
#include "trainers/svm/gram_matrix.h"
#include "trainers/svm/machine.h"

namespace handcraft::svm {
namespace {

using model_io::SvmModel;

// Machines first_machine, first_machine + 1, …, each by itself.
std::vector<Machine> TrainMachines(const SampleMatrix& gram,
                                   const Samples& samples,
                                   std::size_t first_machine,
                                   const Options& options) {
  const std::size_t end = features::NumMachines(options.scheme, samples.NumClasses());
  std::vector<Machine> machines(end - first_machine);
  Report(options.progress, "machines", 0, machines.size());
  ParallelFor(machines.size(), options.num_threads, [&](std::size_t m) {
    const MachineProblem problem(gram, samples, options.scheme, first_machine + m);
    machines[m] = problem.Train(options.penalty, options.smo);
  });
  Report(options.progress, "machines", machines.size(), machines.size());
  return machines;
}

// Appends machines to a model; samples that it knows already as support vectors are not stored
// again.
class ModelBuilder {
 public:
  ModelBuilder(const Samples& samples, SvmModel& model) : samples_(samples), model_(model) {
    if (model_.machine_begins.empty()) model_.machine_begins.push_back(0);
    for (std::size_t v = 0; v < model_.NumSupportVectors(); ++v) {
      known_.emplace(KeyOf(model_.support_classes[v],
                           std::span(model_.support_vectors)
                               .subspan(v * model_.NumFeatures(), model_.NumFeatures())),
                     static_cast<std::int32_t>(v));
    }
  }

  void Append(const std::vector<Machine>& machines) {
    std::vector<std::size_t> supports;
    for (const Machine& machine : machines) {
      supports.insert(supports.end(), machine.support.begin(), machine.support.end());
    }
    std::sort(supports.begin(), supports.end());
    supports.erase(std::unique(supports.begin(), supports.end()), supports.end());
    std::map<std::size_t, std::int32_t> places;
    for (const std::size_t sample : supports) places[sample] = PlaceOf(sample);
    for (const Machine& machine : machines) {
      std::vector<std::pair<std::int32_t, double>> entries;
      for (std::size_t k = 0; k < machine.support.size(); ++k) {
        entries.emplace_back(places.at(machine.support[k]), machine.coefficients[k]);
      }
      std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
        return a.first < b.first;
      });
      for (const auto& [place, coefficient] : entries) {
        model_.machine_supports.push_back(place);
        model_.dual_coefficients.push_back(coefficient);
      }
      model_.machine_begins.push_back(static_cast<std::int32_t>(model_.machine_supports.size()));
      model_.intercepts.push_back(machine.intercept);
    }
  }

 private:
  using Key = std::pair<std::int32_t, std::vector<double>>;
  static Key KeyOf(std::int32_t label, std::span<const double> row) {
    return {label, {row.begin(), row.end()}};
  }

  // Samples that are equal in every feature keep a row each within one call, as in libsvm.
  std::int32_t PlaceOf(std::size_t sample) {
    const auto label = static_cast<std::int32_t>(samples_.ClassOf(sample));
    const std::span<const double> row = samples_.Sample(sample);
    if (const auto found = known_.find(KeyOf(label, row)); found != known_.end()) {
      return found->second;
    }
    model_.support_vectors.insert(model_.support_vectors.end(), row.begin(), row.end());
    model_.support_classes.push_back(label);
    return static_cast<std::int32_t>(model_.support_classes.size()) - 1;
  }

  const Samples& samples_;
  SvmModel& model_;
  std::map<Key, std::int32_t> known_;
};

Summary Summarise(const std::vector<Machine>& machines,
                  const Samples& samples,
                  const SvmModel& model,
                  const Options& options) {
  Summary summary{.termination = Termination::kConverged,
                  .message = {},
                  .num_samples = samples.NumSamples(),
                  .num_classes = model.num_classes,
                  .num_machines = machines.size(),
                  .num_support_vectors = model.NumSupportVectors()};
  std::size_t num_stopped = 0;
  for (const Machine& machine : machines) {
    summary.iterations += machine.iterations;
    summary.violation = std::max(summary.violation, machine.violation);
    num_stopped += machine.converged ? 0 : 1;
  }
  if (num_stopped > 0) summary.termination = Termination::kIterationLimit;
  summary.message =
      num_stopped == 0
          ? fmt::format("converged in {} iterations", summary.iterations)
          : fmt::format(
                "{} of {} machines did not converge in {} iterations; the largest violation "
                "is {:.3g}",
                num_stopped,
                machines.size(),
                options.smo.max_iterations,
                summary.violation);
  return summary;
}

// The Gram matrix of the samples, the machines from first_machine on, and the model they end.
Result Finish(const Samples& samples,
              std::size_t first_machine,
              const Options& options,
              SvmModel model) {
  const SampleMatrix gram =
      ComputeGram(ComputeInnerProducts(samples, options.num_threads, options.progress),
                  model.similarity,
                  samples,
                  options.num_threads);
  const std::vector<Machine> machines = TrainMachines(gram, samples, first_machine, options);
  Result result{.model = std::move(model), .summary = {}};
  ModelBuilder(samples, result.model).Append(machines);
  result.model.num_classes = samples.NumClasses();
  result.summary = Summarise(machines, samples, result.model, options);
  return result;
}

}  // namespace

std::string_view NameOf(features::ClassScheme scheme) noexcept {
  return scheme == features::ClassScheme::kOneAgainstOne ? "one_against_one" : "one_against_all";
}

std::string_view NameOf(Termination termination) noexcept {
  switch (termination) {
    case Termination::kNotRun:
      return "not_run";
    case Termination::kConverged:
      return "converged";
    case Termination::kIterationLimit:
      return "iteration_limit";
  }
  return "unknown";
}

void Options::Validate() const {
  const std::string name = "svm::Options.";
  RequireOption(degree >= 1, name + "degree", degree, "at least 1");
  RequireOption(gamma >= 0.0 && std::isfinite(gamma),
                name + "gamma",
                gamma,
                "above 0, or 0 for 1 / num_features");
  RequireOption(coef0 >= 0.0 && std::isfinite(coef0), name + "coef0", coef0, "at least 0");
  RequireOption(penalty > 0.0 && std::isfinite(penalty), name + "penalty", penalty, "above 0");
  RequireOption(num_threads >= 1, name + "num_threads", num_threads, ">= 1");
  smo.Validate();
}

features::Similarity Options::SimilarityFor(std::size_t num_features) const noexcept {
  return {.type = kernel,
          .degree = degree,
          .gamma = gamma > 0.0 ? gamma : 1.0 / static_cast<double>(num_features),
          .coef0 = coef0};
}

template <class T>
Result TrainSvm(const DesignMatrix<T>& X,
                std::span<const std::uint32_t> classes,
                const Options& options) {
  options.Validate();
  const Normaliser normaliser = options.standardize ? FitNormaliser(X) : Normaliser{};
  const Samples samples = PrepareSamples(X, classes, normaliser);
  SvmModel model{.similarity = options.SimilarityFor(X.num_features),
                 .scheme = options.scheme,
                 .feature_mean = normaliser.mean,
                 .feature_scale = normaliser.scale,
                 .single_precision = samples.single_precision};
  model.feature_mean.resize(X.num_features, 0.0);
  model.feature_scale.resize(X.num_features, 1.0);
  return Finish(samples, 0, options, std::move(model));
}

template <class T>
Result AddClass(const SvmModel& model,
                const DesignMatrix<T>& X,
                std::span<const std::uint32_t> classes,
                const Options& options) {
  Options used = options;
  used.scheme = features::ClassScheme::kOneAgainstOne;
  used.Validate();
  if (model.scheme != features::ClassScheme::kOneAgainstOne) {
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = "a class is added to a one-against-one model; this one is one against all",
         .remedy = "train it again with all classes"});
  }
  if (model.NumFeatures() != X.num_features) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = fmt::format("the model has {} features and the new samples {}",
                                       model.NumFeatures(),
                                       X.num_features)});
  }
  HC_CHECK(model.single_precision == (sizeof(T) == sizeof(float)), model.single_precision);
  const Samples samples =
      PrepareSamples(X, classes, {.mean = model.feature_mean, .scale = model.feature_scale});
  if (samples.NumClasses() != model.num_classes + 1) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = fmt::format("{} classes were given; the model's {} and the new one were "
                                       "expected",
                                       samples.NumClasses(),
                                       model.num_classes)});
  }
  SvmModel grown = model;
  grown.rejection_threshold.reset();
  return Finish(samples, model.NumMachines(), used, std::move(grown));
}

template Result TrainSvm(const DesignMatrix<float>&,
                         std::span<const std::uint32_t>,
                         const Options&);
template Result TrainSvm(const DesignMatrix<double>&,
                         std::span<const std::uint32_t>,
                         const Options&);
template Result AddClass(const SvmModel&,
                         const DesignMatrix<float>&,
                         std::span<const std::uint32_t>,
                         const Options&);
template Result AddClass(const SvmModel&,
                         const DesignMatrix<double>&,
                         std::span<const std::uint32_t>,
                         const Options&);

}  // namespace handcraft::svm
