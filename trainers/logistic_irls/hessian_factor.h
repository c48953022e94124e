// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace handcraft::logistic {

/// Columns of X̃ that others explain: reads the lower triangle of H = X̃ᵀWX̃ and goes through the
/// intercept (last index), then the features in order, as R's glm does; a column is aliased when
/// what the columns kept before it leave unexplained of its weighted sum of squares is below
/// `tolerance`. Returned ascending. Cost: (p + 1)³/3 multiply-adds.
/// The default is a thousand times the rounding of a Hessian in double: a residual below one
/// millionth of the column's spread cannot be told from none.
[[nodiscard]] std::vector<Eigen::Index> FindAliasedColumns(const Eigen::MatrixXd& hessian,
                                                           double tolerance = 1e-12);

/// Cholesky factor of a Hessian, restricted to some of its columns.
class HessianFactor {
 public:
  /// Reads the lower triangle. Nothing when it is not positive definite to working precision
  /// (reciprocal condition below 1e-15) or not finite.
  [[nodiscard]] static std::optional<HessianFactor> Make(const Eigen::MatrixXd& hessian,
                                                         const std::vector<Eigen::Index>& aliased);

  /// H⁻¹ v; aliased entries are zero.
  [[nodiscard]] Eigen::VectorXd Solve(const Eigen::VectorXd& v) const;

  /// L⁻ᵀ V with H = LLᵀ, so that V Vᵀ = I gives a map M with M Mᵀ = H⁻¹; aliased rows are zero.
  [[nodiscard]] Eigen::MatrixXd InverseRootTimes(const Eigen::MatrixXd& V) const;

  /// vᵀ H⁻¹ v.
  [[nodiscard]] double InverseForm(const Eigen::VectorXd& v) const;

  /// Diagonal of H⁻¹; NaN at aliased entries.
  [[nodiscard]] Eigen::VectorXd InverseDiagonal() const;

  /// Estimate in the 1-norm (Hager's, by Eigen).
  [[nodiscard]] double reciprocal_condition() const noexcept { return reciprocal_condition_; }

 private:
  [[nodiscard]] Eigen::VectorXd Kept(const Eigen::VectorXd& v) const;

  std::vector<Eigen::Index> kept_;
  Eigen::Index size_ = 0;
  Eigen::LLT<Eigen::MatrixXd> cholesky_;
  double reciprocal_condition_ = 0.0;
};

}  // namespace handcraft::logistic
