// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/pixel_fit.h"

#include <utility>

#include <fmt/format.h>

#include "lib/core/error.h"
#include "tools/common_options.h"
#include "tools/lda_options.h"
#include "tools/logistic_options.h"
#include "tools/progress_bar.h"
#include "tools/training_outcome.h"

namespace handcraft::tools {
namespace {

DesignMatrix<float> MatrixOf(const datasets::GraspPointSamples& samples) {
  return {.data = samples.features.data(),
          .num_samples = samples.num_samples(),
          .num_features = samples.num_features,
          .stride = samples.num_features};
}

// What the summaries of both methods have.
template <class Summary>
void FillCommon(const Summary& summary, PixelFit& fit) {
  fit.num_samples = summary.num_samples;
  fit.num_positive = summary.num_positive;
  fit.deviance = summary.deviance;
  fit.null_deviance = summary.null_deviance;
  fit.metrics["train.num_samples"] = NumberToText(summary.num_samples);
  fit.metrics["train.deviance"] = NumberToText(summary.deviance);
  fit.metrics["train.null_deviance"] = NumberToText(summary.null_deviance);
  fit.metrics["train.termination"] = std::string(NameOf(summary.termination));
}

template <class Result>
model_io::LinearModel ModelOf(const Result& result) {
  return {.weights = result.weights,
          .intercept = result.intercept,
          .feature_mean = result.feature_mean,
          .feature_scale = result.feature_scale};
}

PixelFit FitLogistic(const datasets::GraspPointSamples& samples,
                     const std::vector<std::string>& feature_names,
                     logistic::Options options,
                     const Console& console) {
  const logistic::Result result = [&] {
    ProgressBar bar(console);
    options.progress = bar.Callback();
    return logistic::TrainLogistic(MatrixOf(samples), samples.labels, options);
  }();
  const logistic::Summary& summary = result.summary;
  RequireUsable(summary, feature_names, console);
  PixelFit fit{.model = ModelOf(result),
               .algorithm = "logistic_irls",
               .hyper_parameters = FieldsToText(options, "irls.")};
  FillCommon(summary, fit);
  fit.metrics["train.gradient_norm"] = NumberToText(summary.gradient_norm);
  fit.metrics["train.iterations"] = NumberToText(summary.iterations);
  fit.message = fmt::format("{}, gradient {:.1e} a sample", summary.message, summary.gradient_norm);
  fit.json = {{"gradient_norm", summary.gradient_norm},
              {"iterations", summary.iterations},
              {"termination", NameOf(summary.termination)},
              {"message", summary.message}};
  return fit;
}

PixelFit FitLda(const datasets::GraspPointSamples& samples,
                const std::vector<std::string>& feature_names,
                lda::Options options,
                const Console& console) {
  const lda::Result result = [&] {
    ProgressBar bar(console);
    options.progress = bar.Callback();
    return lda::TrainLda(MatrixOf(samples), samples.labels, options);
  }();
  const lda::Summary& summary = result.summary;
  RequireUsable(summary, feature_names, console);
  PixelFit fit{.model = ModelOf(result),
               .algorithm = "lda",
               .hyper_parameters = FieldsToText(options, "lda.")};
  FillCommon(summary, fit);
  fit.metrics["train.shrinkage"] = NumberToText(summary.shrinkage);
  fit.message = fmt::format("linear discriminant analysis, {}, reciprocal condition {:.1e}",
                            summary.message,
                            summary.reciprocal_condition);
  fit.json = {{"shrinkage", summary.shrinkage},
              {"positive_prior", summary.positive_prior},
              {"reciprocal_condition", summary.reciprocal_condition},
              {"termination", NameOf(summary.termination)},
              {"message", summary.message}};
  return fit;
}

}  // namespace

void AddPixelFitOptions(CLI::App& command, PixelFitOptions& options) {
  command
      .add_option_function<std::string>(
          "--method",
          [&options](const std::string& name) {
            options.method = name == "lda" ? FitMethod::kLda : FitMethod::kLogistic;
          },
          "logistic (regression) or lda (linear discriminant analysis): the model is of one kind")
      ->check(CLI::IsMember({"logistic", "lda"}))
      ->type_name("NAME")
      ->default_str("logistic");
  AddLogisticOptions(command, options.logistic);
  AddLdaOptions(command, options.lda);
}

void RefuseOptionsOfOtherMethods(const CLI::App& command, const PixelFitOptions& options) {
  const bool is_lda = options.method == FitMethod::kLda;
  const std::vector<std::string> given = GivenOptions(command, is_lda ? kLogisticGroup : kLdaGroup);
  if (given.empty()) return;
  throw Error({.kind = Error::Kind::kUsage,
               .reason = fmt::format(
                   "{} is not read with --method {}", given.front(), is_lda ? "lda" : "logistic")});
}

PixelFit FitPixels(const datasets::GraspPointSamples& samples,
                   const std::vector<std::string>& feature_names,
                   PixelFitOptions options,
                   const datasets::SamplingOptions& sampling,
                   const Console& console) {
  if (options.method == FitMethod::kLda) {
    options.lda.num_threads = sampling.num_threads;
    return FitLda(samples, feature_names, options.lda, console);
  }
  options.logistic.seed = sampling.seed;
  options.logistic.num_threads = sampling.num_threads;
  return FitLogistic(samples, feature_names, options.logistic, console);
}

}  // namespace handcraft::tools
