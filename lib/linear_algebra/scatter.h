// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "lib/core/design_matrix.h"
#include "lib/core/progress.h"

namespace handcraft {

/// In which arithmetic products are summed within a block of rows; blocks are always added in
/// double.
enum class ScatterPrecision : std::uint8_t { kDouble, kSingle };
[[nodiscard]] std::string_view NameOf(ScatterPrecision precision) noexcept;

struct ScatterOptions {
  ScatterPrecision precision = ScatterPrecision::kDouble;
  int num_threads = 1;  ///< ≥ 1; changes no bit of the result
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// How rows lie about the means of their groups.
struct Scatter {
  std::size_t num_features = 0;
  std::vector<std::size_t> num_rows;  ///< of each group
  std::vector<double> means;     ///< row-major num_groups × num_features; 0 for an empty group
  std::vector<double> products;  ///< num_features × num_features, symmetric: Σ_i (x_i − m)(x_i −
                                 ///< m)ᵀ with m the mean of row i's group
  bool fell_back_to_double = false;  ///< single precision could not hold the numbers

  [[nodiscard]] std::size_t NumRows() const noexcept;
  [[nodiscard]] std::span<const double> Mean(std::size_t group) const noexcept {
    return std::span(means).subspan(group * num_features, num_features);
  }
};

/// Means of the groups and the scatter within them, in one pass over X in blocks of rows: a block
/// is shifted by provisional means (of rows taken at even distances), multiplied by BLAS and added
/// in order; at the end
///   Σ (x − m)(x − m)ᵀ = Σ (x − p)(x − p)ᵀ − Σ_g n_g (m_g − p_g)(m_g − p_g)ᵀ,
/// so that a mean far from zero costs no digits. With one group, products / (n − 1) is the
/// covariance; with classes as groups, products / (n − classes) is the pooled one.
///
/// `groups`: the group of each row, below num_groups; empty: one group. X is read in place. Memory
/// above it: at most nine matrices of num_features², and a block a thread. Deterministic: same
/// input, same bits, for every number of threads, on one machine. With kSingle an entry is off by
/// some 1e-7 of √(diagonal · diagonal); what overflows or vanishes there is done again in double.
/// Throws Error(kBadInput) for no rows or columns and for the first number that is not finite (row
/// and column named), std::logic_error for groups that do not fit.
/// Source: Chan, Golub and LeVeque 1983, "Algorithms for computing the sample variance", the
/// shifted and corrected formula (1.7).
template <class T>
[[nodiscard]] Scatter ComputeScatter(const DesignMatrix<T>& X,
                                     std::span<const std::uint8_t> groups,
                                     std::size_t num_groups,
                                     const ScatterOptions& options = {});

extern template Scatter ComputeScatter(const DesignMatrix<float>&,
                                       std::span<const std::uint8_t>,
                                       std::size_t,
                                       const ScatterOptions&);
extern template Scatter ComputeScatter(const DesignMatrix<double>&,
                                       std::span<const std::uint8_t>,
                                       std::size_t,
                                       const ScatterOptions&);

}  // namespace handcraft
