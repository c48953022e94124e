// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/small_eigen.h"

#include <algorithm>
#include <cmath>

namespace handcraft::features {
namespace {

template <std::size_t N>
using Rows = std::array<std::array<double, N>, N>;

// a becomes JᵀaJ and the rows of v turn with it, J the rotation in the plane (p, q) that makes
// a[p][q] zero (section 8.5.2).
template <std::size_t N>
void Annihilate(std::size_t p, std::size_t q, Rows<N>& a, Rows<N>& v) noexcept {
  const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
  const double t = std::copysign(1.0, theta) / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
  const double c = 1.0 / std::sqrt(t * t + 1.0);
  const double s = t * c;
  for (std::size_t k = 0; k < N; ++k) {
    const double kp = a[k][p];
    const double kq = a[k][q];
    a[k][p] = c * kp - s * kq;
    a[k][q] = s * kp + c * kq;
  }
  for (std::size_t k = 0; k < N; ++k) {
    const double pk = a[p][k];
    const double qk = a[q][k];
    a[p][k] = c * pk - s * qk;
    a[q][k] = s * pk + c * qk;
    const double vp = v[p][k];
    const double vq = v[q][k];
    v[p][k] = c * vp - s * vq;
    v[q][k] = s * vp + c * vq;
  }
  a[p][q] = 0.0;
  a[q][p] = 0.0;
}

template <std::size_t N>
void MakeLargestEntryPositive(std::array<double, N>& vector) noexcept {
  const auto largest = std::max_element(
      vector.begin(), vector.end(), [](double a, double b) { return std::fabs(a) < std::fabs(b); });
  if (*largest >= 0.0) return;
  for (double& entry : vector) entry = -entry;
}

// Whether an entry beside the diagonal changes neither of its two diagonal entries.
template <std::size_t N>
bool IsNegligible(const Rows<N>& a, std::size_t p, std::size_t q) noexcept {
  constexpr double kRounding = 1e-17;
  return std::fabs(a[p][q]) <= kRounding * std::sqrt(std::fabs(a[p][p] * a[q][q])) ||
         std::fabs(a[p][q]) < 1e-300;
}

}  // namespace

template <std::size_t N>
SmallEigen<N> EigenOfSymmetric(const std::array<double, N * N>& matrix) noexcept {
  constexpr int kMaxSweeps = 30;  // five do; this ends what is not finite
  Rows<N> a;
  Rows<N> v{};
  for (std::size_t i = 0; i < N; ++i) {
    std::copy_n(matrix.begin() + static_cast<std::ptrdiff_t>(i * N), N, a[i].begin());
    v[i][i] = 1.0;
  }
  bool is_diagonal = false;
  for (int sweep = 0; sweep < kMaxSweeps && !is_diagonal; ++sweep) {
    is_diagonal = true;
    for (std::size_t p = 0; p + 1 < N; ++p) {
      for (std::size_t q = p + 1; q < N; ++q) {
        if (IsNegligible<N>(a, p, q)) continue;
        Annihilate<N>(p, q, a, v);
        is_diagonal = false;
      }
    }
  }
  std::array<std::size_t, N> order;
  for (std::size_t i = 0; i < N; ++i) order[i] = i;
  for (std::size_t i = 1; i < N; ++i) {
    for (std::size_t j = i; j > 0 && a[order[j]][order[j]] < a[order[j - 1]][order[j - 1]]; --j) {
      std::swap(order[j], order[j - 1]);
    }
  }
  SmallEigen<N> eigen;
  for (std::size_t k = 0; k < N; ++k) {
    eigen.values[k] = a[order[k]][order[k]];
    eigen.vectors[k] = v[order[k]];
    MakeLargestEntryPositive<N>(eigen.vectors[k]);
  }
  return eigen;
}

template SmallEigen<3> EigenOfSymmetric<3>(const std::array<double, 9>&) noexcept;
template SmallEigen<4> EigenOfSymmetric<4>(const std::array<double, 16>&) noexcept;

}  // namespace handcraft::features
