// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/hessian_factor.h"

#include <algorithm>
#include <limits>

#include "lib/core/check.h"

namespace handcraft::logistic {

std::vector<Eigen::Index> FindAliasedColumns(const Eigen::MatrixXd& hessian, double tolerance) {
  HC_CHECK(hessian.rows() == hessian.cols() && hessian.rows() >= 1, hessian.rows());
  const Eigen::Index size = hessian.rows();
  std::vector<Eigen::Index> kept;
  std::vector<Eigen::Index> aliased;
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(size, size);  // of the kept columns, row by row
  for (Eigen::Index step = 0; step < size; ++step) {
    const Eigen::Index column = step == 0 ? size - 1 : step - 1;
    const auto rank = static_cast<Eigen::Index>(kept.size());
    Eigen::VectorXd row(rank);
    for (Eigen::Index k = 0; k < rank; ++k) {
      const Eigen::Index other = kept[static_cast<std::size_t>(k)];
      row[k] = hessian(std::max(column, other), std::min(column, other));
    }
    factor.topLeftCorner(rank, rank).triangularView<Eigen::Lower>().solveInPlace(row);
    const double whole = hessian(column, column);
    const double unexplained = whole - row.squaredNorm();
    if (!(unexplained > tolerance * whole)) {
      aliased.push_back(column);
      continue;
    }
    factor.row(rank).head(rank) = row.transpose();
    factor(rank, rank) = std::sqrt(unexplained);
    kept.push_back(column);
  }
  std::sort(aliased.begin(), aliased.end());
  return aliased;
}

std::optional<HessianFactor> HessianFactor::Make(const Eigen::MatrixXd& hessian,
                                                 const std::vector<Eigen::Index>& aliased) {
  HC_CHECK(hessian.rows() == hessian.cols(), hessian.rows(), hessian.cols());
  if (!hessian.diagonal().allFinite()) return std::nullopt;  // bounds what is off it
  HessianFactor factor;
  factor.size_ = hessian.rows();
  for (Eigen::Index j = 0; j < factor.size_; ++j) {
    if (!std::binary_search(aliased.begin(), aliased.end(), j)) factor.kept_.push_back(j);
  }
  if (aliased.empty()) {
    factor.cholesky_.compute(hessian);
  } else {
    factor.cholesky_.compute(hessian(factor.kept_, factor.kept_));
  }
  if (factor.cholesky_.info() != Eigen::Success) return std::nullopt;
  factor.reciprocal_condition_ = factor.cholesky_.rcond();
  if (!(factor.reciprocal_condition_ > 1e-15)) return std::nullopt;
  return factor;
}

Eigen::VectorXd HessianFactor::Kept(const Eigen::VectorXd& v) const {
  HC_CHECK(v.size() == size_, v.size(), size_);
  return v(kept_);
}

Eigen::VectorXd HessianFactor::Solve(const Eigen::VectorXd& v) const {
  const Eigen::VectorXd kept = cholesky_.solve(Kept(v));
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(size_);
  solution(kept_) = kept;
  return solution;
}

Eigen::MatrixXd HessianFactor::InverseRootTimes(const Eigen::MatrixXd& V) const {
  HC_CHECK(V.rows() == size_, V.rows(), size_);
  const Eigen::MatrixXd kept = V(kept_, Eigen::all);
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(size_, V.cols());
  product(kept_, Eigen::all) = cholesky_.matrixU().solve(kept).eval();
  return product;
}

double HessianFactor::InverseForm(const Eigen::VectorXd& v) const {
  return cholesky_.matrixL().solve(Kept(v)).squaredNorm();
}

Eigen::VectorXd HessianFactor::InverseDiagonal() const {
  const auto rank = static_cast<Eigen::Index>(kept_.size());
  // H⁻¹ = L⁻ᵀ L⁻¹, so its diagonal holds the squared norms of the columns of L⁻¹.
  const Eigen::MatrixXd inverse = cholesky_.matrixL().solve(Eigen::MatrixXd::Identity(rank, rank));
  Eigen::VectorXd diagonal =
      Eigen::VectorXd::Constant(size_, std::numeric_limits<double>::quiet_NaN());
  diagonal(kept_) = inverse.colwise().squaredNorm().transpose();
  return diagonal;
}

}  // namespace handcraft::logistic
