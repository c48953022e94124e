// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/cell_training.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "datasets/grasp_point_samples.h"
#include "lib/core/design_matrix.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/model_io/linear_models.h"
#include "lib/model_io/model_writer.h"
#include "trainers/lda/lda.h"
#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::experiments {
namespace {

class Stopwatch {
 public:
  [[nodiscard]] double Seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

// The share of the instances is taken here only where the study does not divide by itself.
datasets::SamplingOptions SamplingOf(const CellSettings& settings,
                                     StudySplit split,
                                     std::uint64_t seed,
                                     int num_threads) {
  return {.num_samples = settings.samples,
          .bad_per_good = settings.bad_per_good,
          .image_share = split == StudySplit::kManifest ? settings.training_share : 1.0,
          .seed = seed,
          .num_threads = num_threads};
}

std::size_t NumImages(const std::vector<datasets::PixelSample>& sorted) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    count += i == 0 || sorted[i].image != sorted[i - 1].image ? 1 : 0;
  }
  return count;
}

// The samples of all sets, one below the other.
struct DrawnSamples {
  std::size_t num_images = 0;
  datasets::GraspPointSamples samples = {};
};
DrawnSamples DrawFrom(std::span<const datasets::LabelledImageSet> sets,
                      const features::FeatureSpec& spec,
                      const datasets::SamplingOptions& sampling) {
  DrawnSamples all;
  for (std::size_t k = 0; k < sets.size(); ++k) {
    datasets::SamplingOptions of_set = sampling;
    const bool takes_one_more = k < sampling.num_samples % sets.size();
    of_set.num_samples = sampling.num_samples / sets.size() + (takes_one_more ? 1 : 0);
    const std::vector<datasets::PixelSample> drawn = datasets::DrawSamples(sets[k], of_set);
    all.num_images += NumImages(drawn);
    datasets::GraspPointSamples samples =
        datasets::ComputeSampleFeatures(sets[k], drawn, spec, of_set);
    if (sets.size() == 1) {
      all.samples = std::move(samples);
      break;
    }
    all.samples.num_features = samples.num_features;
    all.samples.features.insert(
        all.samples.features.end(), samples.features.begin(), samples.features.end());
    all.samples.labels.insert(
        all.samples.labels.end(), samples.labels.begin(), samples.labels.end());
  }
  return all;
}

std::string FingerprintOf(std::span<const datasets::LabelledImageSet> sets) {
  std::vector<std::string> fingerprints;
  fingerprints.reserve(sets.size());
  for (const datasets::LabelledImageSet& set : sets) {
    fingerprints.push_back(datasets::Fingerprint(set));
  }
  return fmt::format("{}", fmt::join(fingerprints, "+"));
}

// Weights however they were found.
struct Fit {
  model_io::LinearModel model = {};
  std::string algorithm = {};
  std::string termination = {};
  double deviance = 0.0;
  std::size_t num_positive = 0;
  FieldTexts options = {};
};

template <class Result>
Fit FitOf(const Result& result) {
  return {.model = {.weights = result.weights,
                    .intercept = result.intercept,
                    .feature_mean = result.feature_mean,
                    .feature_scale = result.feature_scale},
          .termination = std::string(NameOf(result.summary.termination)),
          .deviance = result.summary.deviance,
          .num_positive = result.summary.num_positive};
}

Fit FitLogistic(const DesignMatrix<float>& X,
                std::span<const std::uint8_t> labels,
                const CellSettings& settings,
                std::uint64_t seed,
                int num_threads) {
  const logistic::Options options{
      .ridge = settings.ridge, .standard_errors = false, .num_threads = num_threads, .seed = seed};
  Fit fit = FitOf(logistic::TrainLogistic<float>(X, labels, options));
  fit.algorithm = "logistic_irls";
  fit.options = FieldsToText(options, "irls.");
  return fit;
}

Fit FitLda(const DesignMatrix<float>& X,
           std::span<const std::uint8_t> labels,
           const CellSettings& settings,
           int num_threads) {
  const lda::Options options{.shrinkage_rule = settings.shrinkage_rule,
                             .shrinkage = settings.shrinkage,
                             .positive_prior = settings.prior,
                             .num_threads = num_threads};
  const lda::Result result = lda::TrainLda<float>(X, labels, options);
  if (result.weights.empty()) {
    throw Error({.kind = Error::Kind::kNoResult,
                 .reason = "linear discriminant analysis: " + result.summary.message,
                 .remedy = "set shrinkage = \"auto\", or take other features or more samples"});
  }
  Fit fit = FitOf(result);
  fit.algorithm = "lda";
  fit.options = FieldsToText(options, "lda.");
  return fit;
}

std::vector<std::uint8_t> ModelBytes(const features::FeatureSpec& spec,
                                     const Fit& fit,
                                     std::size_t num_samples,
                                     std::span<const datasets::LabelledImageSet> sets,
                                     const FieldTexts& hyper_parameters) {
  return model_io::Serialise(model_io::MakeGraspPointModel(
      spec,
      fit.model,
      {.name = "study_cell",
       .task = "grasp_point",
       .licence = fmt::format("trained on pictures under: {}",
                              fmt::join(datasets::LicencesOf(sets.front()), "; ")),
       .algorithm = fit.algorithm,
       .data_fingerprint = FingerprintOf(sets),
       .class_counts =
           fmt::format("0: {}, 1: {}", num_samples - fit.num_positive, fit.num_positive),
       .hyper_parameters = hyper_parameters}));
}

}  // namespace

CellTraining TrainCell(std::span<const datasets::LabelledImageSet> sets,
                       const CellSettings& settings,
                       StudySplit split,
                       std::uint64_t seed,
                       int num_threads) {
  const features::FeatureSpec spec = SpecOf(settings);
  const datasets::SamplingOptions sampling = SamplingOf(settings, split, seed, num_threads);
  const Stopwatch features_watch;
  const DrawnSamples drawn = DrawFrom(sets, spec, sampling);
  const datasets::GraspPointSamples& samples = drawn.samples;
  CellTraining training{.num_images = drawn.num_images,
                        .num_samples = samples.num_samples(),
                        .num_features = samples.num_features,
                        .features_time_s = features_watch.Seconds()};
  const DesignMatrix<float> X{.data = samples.features.data(),
                              .num_samples = samples.num_samples(),
                              .num_features = samples.num_features,
                              .stride = samples.num_features};
  const Stopwatch training_watch;
  const Fit fit = settings.classifier == Classifier::kLda
                      ? FitLda(X, samples.labels, settings, num_threads)
                      : FitLogistic(X, samples.labels, settings, seed, num_threads);
  training.training_time_s = training_watch.Seconds();
  training.termination = fit.termination;
  training.log_loss = fit.deviance / (2.0 * static_cast<double>(samples.num_samples()));
  FieldTexts hyper_parameters = FieldsToText(sampling, "sampling.");
  hyper_parameters.insert(fit.options.begin(), fit.options.end());
  training.model = ModelBytes(spec, fit, samples.num_samples(), sets, hyper_parameters);
  return training;
}

}  // namespace handcraft::experiments
