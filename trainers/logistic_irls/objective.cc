// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/objective.h"

#include <cblas.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "lib/core/check.h"
#include "lib/core/parallel.h"
#include "trainers/logistic_irls/row_kernels.h"

namespace handcraft::logistic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Rows a call of syrk multiplies: enough to fill BLAS's own blocking, little enough for the cache.
constexpr std::size_t kBlockRows = 384;

// Rows that SquaredNorms standardises at a time: 128 kB at 500 features.
constexpr std::size_t kMeasuredRows = 64;

// Accumulators of the Hessian: a number that depends on the problem alone. Eight feed eight
// threads; fewer when they would weigh more than an eighth of X in single precision, or cost more
// than the products.
std::size_t NumSlices(std::size_t num_rows, std::size_t num_samples, std::size_t num_features) {
  constexpr std::size_t kMinBlocks = 10;
  return std::clamp<std::size_t>(
      std::min(num_samples / (16 * (num_features + 1)), num_rows / (kMinBlocks * kBlockRows)),
      1,
      8);
}

void AddSelfProduct(int size, int rows, const float* block, int stride, float* sum) {
  cblas_ssyrk(CblasColMajor, CblasLower, CblasNoTrans, size, rows, 1, block, stride, 1, sum, size);
}
void AddSelfProduct(int size, int rows, const double* block, int stride, double* sum) {
  cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, size, rows, 1, block, stride, 1, sum, size);
}

void MultiplyTransposed(const Eigen::MatrixXf& a, const Eigen::MatrixXf& b, Eigen::MatrixXf& ab) {
  const auto rows = static_cast<int>(ab.rows());
  const auto size = static_cast<int>(a.rows());
  cblas_sgemm(CblasColMajor,
              CblasTrans,
              CblasNoTrans,
              rows,
              static_cast<int>(ab.cols()),
              size,
              1,
              a.data(),
              size,
              b.data(),
              size,
              0,
              ab.data(),
              rows);
}

// −log P(y | z), p − y and p(1 − p) from e = exp(−|z|), without cancellation at either end.
struct SampleTerms {
  double negative_log_likelihood;
  double residual;
};
SampleTerms TermsOf(double z, bool positive) {
  const double e = std::exp(-std::abs(z));
  const double margin = positive ? z : -z;
  const double p_wrong = (margin >= 0.0 ? e : 1.0) / (1.0 + e);
  return {std::log1p(e) - std::min(margin, 0.0), positive ? -p_wrong : p_wrong};
}

double RootOfWeight(double z) {
  const double e = std::exp(-std::abs(z));
  return std::sqrt(e) / (1.0 + e);
}

}  // namespace

double Point::GradientNorm(const std::vector<Eigen::Index>& held) const {
  Eigen::VectorXd free = gradient;
  free(held).setZero();
  return free.lpNorm<Eigen::Infinity>() / static_cast<double>(scores.size());
}

struct Objective::ChunkSums {
  std::vector<double> gradient;  // Σ (p − y)(x − mean), raw units
  double residual = 0.0;         // Σ (p − y)
  double negative_log_likelihood = 0.0;
  double smallest_margin = kInfinity;
};

Objective::Objective(AnyDesignMatrix X,
                     std::span<const std::uint8_t> labels,
                     const ColumnMoments& moments,
                     double ridge,
                     int num_threads)
    : X_(X),
      labels_(labels),
      moments_(moments),
      ridge_(ridge),
      num_threads_(num_threads),
      num_rows_(labels.size()),
      num_features_(moments.mean.size()) {
  inverse_scale_.reserve(num_features_);
  for (const double scale : moments.scale) inverse_scale_.push_back(1.0 / scale);
  for (std::size_t i = 0; i < num_rows_; ++i) num_positive_ += labels_[i];
}

template <class T>
void Objective::EvaluateChunk(const DesignMatrix<T>& X,
                              std::span<const double> factors,
                              std::size_t begin,
                              Point& point,
                              ChunkSums& sums) const {
  const std::size_t end = std::min(begin + RowsPerChunk(num_rows_), num_rows_);
  const ColumnScaling scaling{num_features_, moments_.mean.data(), factors.data()};
  const double intercept = point.theta[static_cast<Eigen::Index>(num_features_)];
  sums.gradient.assign(num_features_, 0.0);
  for (std::size_t i = begin; i < end; i += kTileRows) {
    const std::size_t count = std::min(kTileRows, end - i);
    RowTile<T> tile;
    for (std::size_t k = 0; k < kTileRows; ++k) tile[k] = X.Row(i + std::min(k, count - 1));
    double scores[kTileRows];
    double residuals[kTileRows] = {};
    ComputeScores(tile, scaling, scores);
    for (std::size_t k = 0; k < count; ++k) {
      const double z = scores[k] + intercept;
      const bool positive = labels_[i + k] != 0;
      const SampleTerms terms = TermsOf(z, positive);
      point.scores[i + k] = z;
      residuals[k] = terms.residual;
      sums.residual += terms.residual;
      sums.negative_log_likelihood += terms.negative_log_likelihood;
      sums.smallest_margin = std::min(sums.smallest_margin, positive ? z : -z);
    }
    AddWeightedRows(tile, scaling, residuals, sums.gradient.data());
  }
}

void Objective::Evaluate(const Eigen::VectorXd& theta, Point& point) const {
  const auto p = static_cast<Eigen::Index>(num_features_);
  HC_CHECK(theta.size() == p + 1, theta.size(), p);
  point.theta = theta;
  point.scores.resize(num_rows_);
  std::vector<double> factors(num_features_);
  for (std::size_t j = 0; j < num_features_; ++j) {
    factors[j] = theta[static_cast<Eigen::Index>(j)] * inverse_scale_[j];
  }
  const std::size_t rows_per_chunk = RowsPerChunk(num_rows_);
  std::vector<ChunkSums> chunks((num_rows_ + rows_per_chunk - 1) / rows_per_chunk);
  ParallelFor(chunks.size(), num_threads_, [&](std::size_t c) {
    std::visit(
        [&](const auto& X) { EvaluateChunk(X, factors, c * rows_per_chunk, point, chunks[c]); },
        X_);
  });

  double negative_log_likelihood = 0.0;
  point.smallest_margin = kInfinity;
  point.gradient = Eigen::VectorXd::Zero(p + 1);
  for (const ChunkSums& chunk : chunks) {
    negative_log_likelihood += chunk.negative_log_likelihood;
    point.smallest_margin = std::min(point.smallest_margin, chunk.smallest_margin);
    point.gradient.head(p) += Eigen::Map<const Eigen::VectorXd>(chunk.gradient.data(), p);
    point.gradient[p] += chunk.residual;
  }
  point.gradient.head(p).array() *= Eigen::Map<const Eigen::ArrayXd>(inverse_scale_.data(), p);
  point.gradient.head(p) += ridge_ * theta.head(p);
  point.deviance = 2.0 * negative_log_likelihood;
  point.value = negative_log_likelihood + 0.5 * ridge_ * theta.head(p).squaredNorm();
}

// Adds √w-scaled standardised rows [begin, end), of the sample or of all, block by block.
template <class T, class Number>
void Objective::AddSlice(const DesignMatrix<T>& X,
                         const Point& point,
                         const RowSample* sample,
                         std::size_t begin,
                         std::size_t end,
                         Number* accumulator) const {
  const ColumnScaling scaling{num_features_, moments_.mean.data(), inverse_scale_.data()};
  const std::size_t size = num_features_ + 1;
  const std::size_t stride = (size + 7) / 8 * 8;  // whole cache lines
  std::vector<Number> block(std::min(kBlockRows, end - begin) * stride);
  for (std::size_t first = begin; first < end; first += kBlockRows) {
    const std::size_t count = std::min(kBlockRows, end - first);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t row = sample == nullptr ? first + i : sample->rows[first + i];
      double root = RootOfWeight(point.scores[row]);
      if (sample != nullptr) root *= std::sqrt(sample->weights[first + i]);
      Number* out = block.data() + i * stride;
      StandardiseRow(X.Row(row), scaling, root, out);
      out[num_features_] = static_cast<Number>(root);
    }
    AddSelfProduct(static_cast<int>(size),
                   static_cast<int>(count),
                   block.data(),
                   static_cast<int>(stride),
                   accumulator);
  }
}

template <class Number>
Eigen::MatrixXd Objective::Hessian(const Point& point, const RowSample* sample) const {
  HC_CHECK(point.scores.size() == num_rows_, point.scores.size(), num_rows_);
  using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
  const auto size = static_cast<Eigen::Index>(num_features_) + 1;
  const std::size_t num_rows = sample == nullptr ? num_rows_ : sample->rows.size();
  std::vector<Matrix> slices(NumSlices(num_rows, num_rows_, num_features_));
  ParallelFor(slices.size(), num_threads_, [&](std::size_t s) {
    slices[s] = Matrix::Zero(size, size);
    const std::size_t begin = num_rows * s / slices.size();
    const std::size_t end = num_rows * (s + 1) / slices.size();
    std::visit([&](const auto& X) { AddSlice(X, point, sample, begin, end, slices[s].data()); },
               X_);
  });
  Eigen::MatrixXd hessian;
  if constexpr (std::is_same_v<Number, double>) {
    hessian = std::move(slices[0]);
  } else {
    hessian = slices[0].template cast<double>();
  }
  for (std::size_t s = 1; s < slices.size(); ++s) {
    hessian += slices[s].template cast<double>();
    slices[s].resize(0, 0);
  }
  hessian.diagonal().head(size - 1).array() += ridge_;
  return hessian;
}

// Writes norms[i] for the rows of the chunk that begins at `begin`.
template <class T>
void Objective::MeasureChunk(const DesignMatrix<T>& X,
                             const Eigen::MatrixXf& map,
                             std::size_t begin,
                             std::span<double> norms) const {
  const ColumnScaling scaling{num_features_, moments_.mean.data(), inverse_scale_.data()};
  const Eigen::Index size = map.rows();
  Eigen::MatrixXf block(size, static_cast<Eigen::Index>(kMeasuredRows));  // a row of X a column
  Eigen::MatrixXf image(map.cols(), block.cols());
  const std::size_t end = std::min(begin + RowsPerChunk(num_rows_), num_rows_);
  for (std::size_t first = begin; first < end; first += kMeasuredRows) {
    const std::size_t count = std::min(kMeasuredRows, end - first);
    for (std::size_t k = 0; k < count; ++k) {
      float* out = block.col(static_cast<Eigen::Index>(k)).data();
      StandardiseRow(X.Row(first + k), scaling, 1.0, out);
      out[num_features_] = 1.0F;
    }
    MultiplyTransposed(map, block, image);
    for (std::size_t k = 0; k < count; ++k) {
      norms[first + k] = image.col(static_cast<Eigen::Index>(k)).squaredNorm();
    }
  }
}

std::vector<double> Objective::SquaredNorms(const Eigen::MatrixXd& map) const {
  HC_CHECK(map.rows() == static_cast<Eigen::Index>(num_features_) + 1, map.rows(), num_features_);
  const Eigen::MatrixXf narrow = map.cast<float>();
  std::vector<double> norms(num_rows_);
  const std::size_t rows_per_chunk = RowsPerChunk(num_rows_);
  ParallelFor((num_rows_ + rows_per_chunk - 1) / rows_per_chunk, num_threads_, [&](std::size_t c) {
    std::visit([&](const auto& X) { MeasureChunk(X, narrow, c * rows_per_chunk, norms); }, X_);
  });
  return norms;
}

Movement Objective::MovementBetween(const Point& from, const Point& to) const {
  Movement movement{.largest = 0.0, .smallest = kInfinity};
  for (std::size_t i = 0; i < num_rows_; ++i) {
    const double change = to.scores[i] - from.scores[i];
    movement.largest = std::max(movement.largest, std::abs(change));
    movement.smallest = std::min(movement.smallest, labels_[i] != 0 ? change : -change);
  }
  return movement;
}

template Eigen::MatrixXd Objective::Hessian<float>(const Point&, const RowSample*) const;
template Eigen::MatrixXd Objective::Hessian<double>(const Point&, const RowSample*) const;

}  // namespace handcraft::logistic
