// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/margins.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "lib/core/error.h"
#include "lib/core/parallel.h"
#include "lib/features/class_vote.h"
#include "lib/features/inner_products.h"
#include "trainers/svm/gram_matrix.h"

namespace handcraft::svm {
namespace {

using features::PaddedRows;
using model_io::SvmModel;

// Rows as the kernel sees them, filled up with zeros.
struct PaddedSamples {
  PaddedSamples(std::size_t num_rows, std::size_t num_features)
      : stride(features::PaddedLength(num_features)), values(num_rows * stride) {}

  [[nodiscard]] PaddedRows<double> Rows() const noexcept {
    return {values.data(), values.size() / stride, stride};
  }

  std::size_t stride;
  std::vector<double> values;
};

template <class T>
PaddedSamples Normalise(const SvmModel& model, const DesignMatrix<T>& X) {
  PaddedSamples samples(X.num_samples, X.num_features);
  for (std::size_t i = 0; i < X.num_samples; ++i) {
    const T* const row = X.Row(i);
    double* const sample = samples.values.data() + i * samples.stride;
    for (std::size_t j = 0; j < X.num_features; ++j) {
      const double value =
          (static_cast<double>(row[j]) - model.feature_mean[j]) / model.feature_scale[j];
      sample[j] = model.single_precision ? static_cast<double>(static_cast<float>(value)) : value;
    }
  }
  return samples;
}

PaddedSamples SupportVectorsOf(const SvmModel& model) {
  const std::size_t p = model.NumFeatures();
  PaddedSamples support(model.NumSupportVectors(), p);
  for (std::size_t v = 0; v < model.NumSupportVectors(); ++v) {
    std::copy_n(
        model.support_vectors.data() + v * p, p, support.values.data() + v * support.stride);
  }
  return support;
}

double SquaredNorm(const double* sample, std::size_t stride) {
  double squared = 0.0;
  features::InnerProducts(PaddedRows<double>{sample, 1, stride}, sample, {&squared, 1});
  return squared;
}

// `kernels`: that of each support vector with the sample.
double Vote(const SvmModel& model, std::span<const double> kernels) {
  std::vector<double> values(model.intercepts);
  for (std::size_t m = 0; m < values.size(); ++m) {
    const auto end = static_cast<std::size_t>(model.machine_begins[m + 1]);
    for (auto k = static_cast<std::size_t>(model.machine_begins[m]); k < end; ++k) {
      values[m] +=
          model.dual_coefficients[k] * kernels[static_cast<std::size_t>(model.machine_supports[k])];
    }
    if (!std::isfinite(values[m])) return std::numeric_limits<double>::quiet_NaN();
  }
  std::vector<std::int32_t> votes(model.num_classes);
  return features::VoteForClass(model.scheme, values, votes).margin;
}

}  // namespace

template <class T>
std::vector<double> MarginsOf(const SvmModel& model, const DesignMatrix<T>& X, int num_threads) {
  if (X.num_features != model.NumFeatures()) {
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = fmt::format(
             "the samples have {} features and the model {}", X.num_features, model.NumFeatures()),
         .remedy = "describe them as those of the model were"});
  }
  const PaddedSamples samples = Normalise(model, X);
  const PaddedSamples support = SupportVectorsOf(model);
  const PaddedRows<double> vectors = support.Rows();
  std::vector<double> squared_norms(vectors.num_rows);
  for (std::size_t v = 0; v < squared_norms.size(); ++v) {
    squared_norms[v] = SquaredNorm(vectors.Row(v), vectors.stride);
  }
  std::vector<double> margins(X.num_samples);
  ParallelFor(margins.size(), num_threads, [&](std::size_t i) {
    const double* const sample = samples.Rows().Row(i);
    const double squared_norm = SquaredNorm(sample, samples.stride);
    std::vector<double> kernels(vectors.num_rows);
    features::InnerProducts(vectors, sample, kernels);
    for (std::size_t v = 0; v < kernels.size(); ++v) {
      kernels[v] = model.similarity(kernels[v], squared_norm, squared_norms[v]);
    }
    margins[i] = Vote(model, kernels);
  });
  return margins;
}

template std::vector<double> MarginsOf(const SvmModel&, const DesignMatrix<float>&, int);
template std::vector<double> MarginsOf(const SvmModel&, const DesignMatrix<double>&, int);

template <class T>
CrossValidation CrossValidateLike(const SvmModel& model,
                                  const DesignMatrix<T>& X,
                                  std::span<const std::uint32_t> classes,
                                  std::span<const std::uint32_t> folds,
                                  const Options& options) {
  Options used = options;
  used.scheme = model.scheme;
  const Samples samples =
      PrepareSamples(X, classes, {.mean = model.feature_mean, .scale = model.feature_scale});
  return CrossValidate(ComputeGram(ComputeInnerProducts(samples, used.num_threads, used.progress),
                                   model.similarity,
                                   samples,
                                   used.num_threads),
                       samples,
                       folds,
                       used);
}

template CrossValidation CrossValidateLike(const model_io::SvmModel&,
                                           const DesignMatrix<float>&,
                                           std::span<const std::uint32_t>,
                                           std::span<const std::uint32_t>,
                                           const Options&);
template CrossValidation CrossValidateLike(const model_io::SvmModel&,
                                           const DesignMatrix<double>&,
                                           std::span<const std::uint32_t>,
                                           std::span<const std::uint32_t>,
                                           const Options&);

}  // namespace handcraft::svm
