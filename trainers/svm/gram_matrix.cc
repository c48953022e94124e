// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/gram_matrix.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <type_traits>

#include <fmt/format.h>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/parallel.h"

namespace handcraft::svm {
namespace {

// Numbers of a block of rows: half of a second-level cache of 1 MiB.
constexpr std::size_t kBlockNumbers = std::size_t{1} << 16;

[[noreturn]] void ThrowNotFinite(std::size_t row, std::size_t column, double value) {
  throw Error({.kind = Error::Kind::kBadInput,
               .reason = fmt::format(
                   "row {}, column {} (counted from 0) is {}: a feature must be a finite number",
                   row,
                   column,
                   value),
               .remedy = "leave the row out or repair the feature"});
}

void GroupByClass(std::span<const std::uint32_t> classes, Samples& samples) {
  const std::uint32_t last =
      classes.empty() ? 0 : *std::max_element(classes.begin(), classes.end());
  if (last == 0) {
    throw Error(
        {.kind = Error::Kind::kBadInput,
         .reason = fmt::format("all {} samples are of one class: there is nothing to tell apart",
                               classes.size()),
         .remedy = "add samples of another class"});
  }
  HC_CHECK(last < classes.size(), last, classes.size());
  samples.class_begins.assign(std::size_t{last} + 2, 0);
  for (const std::uint32_t c : classes) ++samples.class_begins[c + 1];
  for (std::size_t c = 0; c <= last; ++c) {
    if (samples.class_begins[c + 1] == 0) {
      throw Error({.kind = Error::Kind::kBadInput,
                   .reason = fmt::format("class {} (counted from 0) has no samples", c),
                   .remedy = "leave the class out"});
    }
    samples.class_begins[c + 1] += samples.class_begins[c];
  }
  samples.rows.resize(classes.size());
  std::iota(samples.rows.begin(), samples.rows.end(), std::size_t{0});
  std::stable_sort(samples.rows.begin(), samples.rows.end(), [classes](auto a, auto b) {
    return classes[a] < classes[b];
  });
}

}  // namespace

std::size_t Samples::ClassOf(std::size_t sample) const noexcept {
  const auto next = std::upper_bound(class_begins.begin(), class_begins.end(), sample);
  return static_cast<std::size_t>(next - class_begins.begin()) - 1;
}

template <class T>
Normaliser FitNormaliser(const DesignMatrix<T>& X) {
  const auto n = static_cast<double>(X.num_samples);
  Normaliser normaliser{.mean = std::vector<double>(X.num_features, 0.0),
                        .scale = std::vector<double>(X.num_features, 0.0)};
  for (std::size_t i = 0; i < X.num_samples; ++i) {
    for (std::size_t j = 0; j < X.num_features; ++j) {
      const auto value = static_cast<double>(X.Row(i)[j]);
      if (!std::isfinite(value)) ThrowNotFinite(i, j, value);
      normaliser.mean[j] += value / n;
    }
  }
  for (std::size_t i = 0; i < X.num_samples; ++i) {
    for (std::size_t j = 0; j < X.num_features; ++j) {
      const double apart = static_cast<double>(X.Row(i)[j]) - normaliser.mean[j];
      normaliser.scale[j] += apart * apart / n;
    }
  }
  for (std::size_t j = 0; j < X.num_features; ++j) {
    // What is left of a constant column is the rounding of its mean.
    const double scale = std::sqrt(normaliser.scale[j]);
    normaliser.scale[j] = scale > 1e-12 * std::abs(normaliser.mean[j]) ? scale : 1.0;
  }
  return normaliser;
}

template <class T>
Samples PrepareSamples(const DesignMatrix<T>& X,
                       std::span<const std::uint32_t> classes,
                       const Normaliser& normaliser) {
  HC_CHECK(classes.size() == X.num_samples, classes.size(), X.num_samples);
  HC_CHECK(normaliser.mean.size() == normaliser.scale.size() &&
               (normaliser.mean.empty() || normaliser.mean.size() == X.num_features),
           normaliser.mean.size(),
           normaliser.scale.size(),
           X.num_features);
  if (X.num_features == 0) {
    throw Error({.kind = Error::Kind::kBadInput, .reason = "the samples have no features"});
  }
  Samples samples;
  samples.num_features = X.num_features;
  samples.stride = features::PaddedLength(X.num_features);
  samples.single_precision = std::is_same_v<T, float>;
  GroupByClass(classes, samples);
  samples.values.assign(samples.NumSamples() * samples.stride, 0.0);
  for (std::size_t i = 0; i < samples.NumSamples(); ++i) {
    const T* row = X.Row(samples.rows[i]);
    double* sample = samples.values.data() + i * samples.stride;
    for (std::size_t j = 0; j < X.num_features; ++j) {
      auto value = static_cast<double>(row[j]);
      if (!normaliser.mean.empty()) value = (value - normaliser.mean[j]) / normaliser.scale[j];
      sample[j] = static_cast<double>(static_cast<T>(value));
      if (!std::isfinite(sample[j])) ThrowNotFinite(samples.rows[i], j, sample[j]);
    }
  }
  return samples;
}

template Normaliser FitNormaliser(const DesignMatrix<float>&);
template Normaliser FitNormaliser(const DesignMatrix<double>&);
template Samples PrepareSamples(const DesignMatrix<float>&,
                                std::span<const std::uint32_t>,
                                const Normaliser&);
template Samples PrepareSamples(const DesignMatrix<double>&,
                                std::span<const std::uint32_t>,
                                const Normaliser&);

SampleMatrix ComputeInnerProducts(const Samples& samples,
                                  int num_threads,
                                  const Progress& progress) {
  const std::size_t n = samples.NumSamples();
  if (n > kMaxMatrixBytes / sizeof(double) / n) {
    throw Error(
        {.kind = Error::Kind::kBadInput,
         .reason = fmt::format("{} samples make a kernel matrix of {:.1f} GiB; {:.1f} GiB is "
                               "the most",
                               n,
                               std::pow(static_cast<double>(n), 2) * 8 / (1 << 30),
                               static_cast<double>(kMaxMatrixBytes) / (1 << 30)),
         .remedy = "draw fewer samples, or train a linear model"});
  }
  Report(progress, "kernel matrix", 0, 1);
  SampleMatrix products{.values = std::vector<double>(n * n), .size = n};
  const std::size_t block =
      std::clamp(kBlockNumbers / samples.stride / 4 * 4, std::size_t{4}, std::size_t{256});
  const std::size_t num_blocks = (n + block - 1) / block;
  // The block on and those below the diagonal; what is above is a copy.
  ParallelFor(num_blocks, num_threads, [&](std::size_t column) {
    const std::size_t begin = column * block;
    const std::size_t end = std::min(n, begin + block);
    const double* data = samples.values.data();
    features::InnerProductTable({data + begin * samples.stride, n - begin, samples.stride},
                                {data + begin * samples.stride, end - begin, samples.stride},
                                products.values.data() + begin * n + begin,
                                n);
  });
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) products.values[k * n + i] = products.values[i * n + k];
  }
  Report(progress, "kernel matrix", 1, 1);
  return products;
}

SampleMatrix ComputeGram(const SampleMatrix& inner_products,
                         const features::Similarity& similarity,
                         const Samples& samples,
                         int num_threads) {
  const std::size_t n = inner_products.size;
  SampleMatrix gram{.values = std::vector<double>(n * n), .size = n};
  ParallelFor(n, num_threads, [&](std::size_t i) {
    const double* products = inner_products.Row(i);
    double* row = gram.values.data() + i * n;
    for (std::size_t k = 0; k < n; ++k) {
      row[k] = similarity(products[k], products[i], inner_products.Row(k)[k]);
      if (std::isfinite(row[k])) continue;
      throw Error(
          {.kind = Error::Kind::kBadInput,
           .reason = fmt::format("the kernel value of rows {} and {} (counted from 0) is {}",
                                 samples.rows[i],
                                 samples.rows[k],
                                 row[k]),
           .remedy = "standardise the features, or take a smaller gamma or degree"});
    }
  });
  return gram;
}

}  // namespace handcraft::svm
