// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "trainers/logistic_irls/column_moments.h"
#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::logistic {

/// The objective at one place θ, with what the Hessian needs.
///
/// θ = (w_0 … w_{p−1}, intercept), on standardised features.
struct Point {
  Eigen::VectorXd theta;
  Eigen::VectorXd gradient;      ///< of the objective
  std::vector<double> scores;    ///< z_i, one a row
  double deviance = 0.0;         ///< −2 log-likelihood
  double value = 0.0;            ///< the objective
  double smallest_margin = 0.0;  ///< min_i (2 y_i − 1) z_i: > 0 when every sample is told right

  /// ‖∇‖∞ / num_rows, over all columns but those held at zero (ascending).
  [[nodiscard]] double GradientNorm(const std::vector<Eigen::Index>& held = {}) const;
};

/// How the scores change from one point to another.
struct Movement {
  double largest = 0.0;   ///< max_i |Δz_i|
  double smallest = 0.0;  ///< min_i (2 y_i − 1) Δz_i: ≥ 0 when no sample is worse off
};

/// Some rows that stand for all: row rows[k] counts weights[k] times.
struct RowSample {
  std::vector<std::size_t> rows;  ///< ascending
  std::vector<double> weights;
};

/// Penalised negative log-likelihood of logistic regression, on features standardised on the fly:
///   f(θ) = D(θ)/2 + λ/2 ‖w‖²,  D = −2 Σ_i log P(y_i | x_i),  z_i = b + Σ_j w_j (x_ij − m_j)/s_j,
///   ∇f = X̃ᵀ(p − y) + λ (w, 0),  H = X̃ᵀ W X̃ + λ diag(1 … 1, 0),  W = diag(p (1 − p)),
/// X̃ standardised with a column of ones at the end. Value and gradient are double throughout.
///
/// Refers to the caller's X and labels. Rows are read in chunks that depend on the number of rows
/// alone, and sums over chunks are formed in order: the number of threads changes no bit.
/// Source: McCullagh and Nelder 1989, section 4.4.
class Objective {
 public:
  using AnyDesignMatrix = std::variant<DesignMatrix<float>, DesignMatrix<double>>;

  /// `labels` and `moments` must outlive the object.
  Objective(AnyDesignMatrix X,
            std::span<const std::uint8_t> labels,
            const ColumnMoments& moments,
            double ridge,
            int num_threads);

  [[nodiscard]] std::size_t NumRows() const noexcept { return num_rows_; }
  [[nodiscard]] std::size_t NumFeatures() const noexcept { return num_features_; }
  [[nodiscard]] std::size_t NumPositive() const noexcept { return num_positive_; }
  [[nodiscard]] double ridge() const noexcept { return ridge_; }

  /// Value and gradient at theta in one pass over X. Reuses the memory of `point`.
  void Evaluate(const Eigen::VectorXd& theta, Point& point) const;

  /// H at the point, lower triangle, (p + 1) × (p + 1). `Number` is the arithmetic of the products
  /// and sums over rows: float is twice as fast and good to about 1e-6 of the largest entry.
  /// With a sample, H is estimated from its rows. Allocates up to eight (p + 1)² accumulators and a
  /// block of rows a thread.
  template <class Number>
  [[nodiscard]] Eigen::MatrixXd Hessian(const Point& point,
                                        const RowSample* sample = nullptr) const;

  /// ‖Mᵀx̃_i‖² of every row i, for a map M of (p + 1) × k. Products in single precision; one pass
  /// over X.
  [[nodiscard]] std::vector<double> SquaredNorms(const Eigen::MatrixXd& map) const;

  [[nodiscard]] Movement MovementBetween(const Point& from, const Point& to) const;

 private:
  struct ChunkSums;
  template <class T>
  void EvaluateChunk(const DesignMatrix<T>& X,
                     std::span<const double> factors,
                     std::size_t begin,
                     Point& point,
                     ChunkSums& sums) const;
  template <class T, class Number>
  void AddSlice(const DesignMatrix<T>& X,
                const Point& point,
                const RowSample* sample,
                std::size_t begin,
                std::size_t end,
                Number* accumulator) const;

  template <class T>
  void MeasureChunk(const DesignMatrix<T>& X,
                    const Eigen::MatrixXf& map,
                    std::size_t begin,
                    std::span<double> norms) const;

  AnyDesignMatrix X_;
  std::span<const std::uint8_t> labels_;
  const ColumnMoments& moments_;
  std::vector<double> inverse_scale_;
  double ridge_;
  int num_threads_;
  std::size_t num_rows_;
  std::size_t num_features_;
  std::size_t num_positive_ = 0;
};

extern template Eigen::MatrixXd Objective::Hessian<float>(const Point&, const RowSample*) const;
extern template Eigen::MatrixXd Objective::Hessian<double>(const Point&, const RowSample*) const;

}  // namespace handcraft::logistic
