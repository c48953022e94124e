// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/linear_algebra/scatter.h"

#include <cblas.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/core/parallel.h"
#include "lib/linear_algebra/single_threaded_blas.h"

namespace handcraft {
namespace {

// Rows a call of syrk multiplies: enough to fill BLAS's own blocking, few enough that single
// precision sums them well and that their copy stays in the cache.
constexpr std::size_t kRowsPerBlock = 512;

// Where every row is shifted to before it is multiplied, and by what single precision scales it.
struct Frame {
  std::vector<double> origins;  // num_groups × num_features
  std::vector<double> factors;  // num_features: powers of two that bring the spread near 1
};

// What one block of rows gives.
template <class Real>
struct Block {
  std::vector<Real> tile;      // rows × num_features, shifted
  std::vector<Real> products;  // the lower triangle
  std::vector<double> sums;    // num_groups × num_features, of x − origin
};

void Syrk(int size, int rows, const float* tile, float* products) {
  cblas_ssyrk(CblasRowMajor, CblasLower, CblasTrans, size, rows, 1, tile, size, 0, products, size);
}
void Syrk(int size, int rows, const double* tile, double* products) {
  cblas_dsyrk(CblasRowMajor, CblasLower, CblasTrans, size, rows, 1, tile, size, 0, products, size);
}

// One pass over X with the arithmetic Real.
template <class T, class Real>
class Pass {
 public:
  Pass(const DesignMatrix<T>& X,
       std::span<const std::uint8_t> groups,
       std::size_t num_groups,
       const ScatterOptions& options)
      : X_(X), groups_(groups), num_groups_(num_groups), options_(options) {}

  // False when Real could not hold the numbers.
  bool Run(Scatter& scatter);

 private:
  [[nodiscard]] std::size_t GroupOf(std::size_t row) const {
    return groups_.empty() ? 0 : groups_[row];
  }
  [[nodiscard]] std::vector<std::size_t> CountRows() const;
  void ChooseFrame();
  void MultiplyBlock(std::size_t first_row, Block<Real>& block) const;
  [[nodiscard]] bool IsHeld(const Block<Real>& block, std::size_t num_rows) const;
  void AddBlocks(std::span<const Block<Real>> blocks, Scatter& scatter) const;
  void Finish(std::vector<double> sums, Scatter& scatter) const;
  [[noreturn]] void ThrowNotFinite(std::size_t row) const;

  const DesignMatrix<T>& X_;
  std::span<const std::uint8_t> groups_;
  std::size_t num_groups_;
  const ScatterOptions& options_;
  Frame frame_;
};

template <class T, class Real>
std::vector<std::size_t> Pass<T, Real>::CountRows() const {
  std::vector<std::size_t> counts(num_groups_, 0);
  for (std::size_t i = 0; i < X_.num_samples; ++i) {
    HC_CHECK(GroupOf(i) < num_groups_, i, GroupOf(i), num_groups_);
    ++counts[GroupOf(i)];
  }
  return counts;
}

template <class T, class Real>
void Pass<T, Real>::ThrowNotFinite(std::size_t row) const {
  const T* values = X_.Row(row);
  const T* wrong =
      std::find_if(values, values + X_.num_features, [](T value) { return !std::isfinite(value); });
  throw Error({.kind = Error::Kind::kBadInput,
               .reason = fmt::format(
                   "row {}, column {} (counted from 0) is {}: a feature must be a finite number",
                   row,
                   wrong - values,
                   *wrong),
               .remedy = "leave the row out or repair the feature"});
}

// Means of up to kMaxRows rows at even distances, and the spread of the columns over them. A group
// without any of these rows keeps the origin 0: it is small.
template <class T, class Real>
void Pass<T, Real>::ChooseFrame() {
  constexpr std::size_t kMaxRows = 1024;
  const std::size_t p = X_.num_features;
  const std::size_t step = (X_.num_samples + kMaxRows - 1) / kMaxRows;
  std::vector<double> counts(num_groups_, 0.0);
  std::vector<double> low(p, std::numeric_limits<double>::infinity());
  std::vector<double> high(p, -std::numeric_limits<double>::infinity());
  frame_.origins.assign(num_groups_ * p, 0.0);
  for (std::size_t i = 0; i < X_.num_samples; i += step) {
    const T* row = X_.Row(i);
    double* origin = frame_.origins.data() + GroupOf(i) * p;
    const double share = 1.0 / ++counts[GroupOf(i)];
    for (std::size_t j = 0; j < p; ++j) {
      const auto value = static_cast<double>(row[j]);
      if (!std::isfinite(value)) ThrowNotFinite(i);
      origin[j] += (value - origin[j]) * share;
      low[j] = std::min(low[j], value);
      high[j] = std::max(high[j], value);
    }
  }
  frame_.factors.assign(p, 1.0);
  if (std::is_same_v<Real, double>) return;
  for (std::size_t j = 0; j < p; ++j) {
    const double spread = high[j] - low[j];
    if (std::isnormal(spread)) frame_.factors[j] = std::ldexp(1.0, -std::ilogb(spread));
  }
}

template <class T, class Real>
void Pass<T, Real>::MultiplyBlock(std::size_t first_row, Block<Real>& block) const {
  const std::size_t p = X_.num_features;
  const std::size_t num_rows = std::min(kRowsPerBlock, X_.num_samples - first_row);
  block.tile.resize(kRowsPerBlock * p);
  block.products.resize(p * p);
  block.sums.assign(num_groups_ * p, 0.0);
  for (std::size_t r = 0; r < num_rows; ++r) {
    const T* row = X_.Row(first_row + r);
    const std::size_t group = GroupOf(first_row + r);
    const double* origin = frame_.origins.data() + group * p;
    double* sums = block.sums.data() + group * p;
    Real* out = block.tile.data() + r * p;
    double faults = 0.0;  // NaN as soon as a value is not finite
    for (std::size_t j = 0; j < p; ++j) {
      const auto value = static_cast<double>(row[j]);
      const double shifted = value - origin[j];
      faults += value - value;
      sums[j] += shifted;
      out[j] = static_cast<Real>(shifted * frame_.factors[j]);
    }
    if (faults != 0.0) ThrowNotFinite(first_row + r);
  }
  Syrk(static_cast<int>(p), static_cast<int>(num_rows), block.tile.data(), block.products.data());
}

// Whether no sum of squares became infinite, and none vanished of a column that varies.
template <class T, class Real>
bool Pass<T, Real>::IsHeld(const Block<Real>& block, std::size_t num_rows) const {
  const std::size_t p = X_.num_features;
  for (std::size_t j = 0; j < p; ++j) {
    const Real square = block.products[j * p + j];
    if (std::isnormal(square)) continue;
    if (square != Real{0}) return false;
    for (std::size_t r = 0; r < num_rows; ++r) {
      if (block.tile[r * p + j] != Real{0}) return false;
    }
  }
  return true;
}

// In the order of the blocks; rows of the matrix are independent, so threads share them out.
template <class T, class Real>
void Pass<T, Real>::AddBlocks(std::span<const Block<Real>> blocks, Scatter& scatter) const {
  constexpr std::size_t kRowsPerTask = 64;
  const std::size_t p = X_.num_features;
  ParallelFor((p + kRowsPerTask - 1) / kRowsPerTask, options_.num_threads, [&](std::size_t task) {
    const std::size_t end = std::min(p, (task + 1) * kRowsPerTask);
    for (std::size_t i = task * kRowsPerTask; i < end; ++i) {
      double* sum = scatter.products.data() + i * p;
      for (const Block<Real>& block : blocks) {
        const Real* products = block.products.data() + i * p;
        for (std::size_t j = 0; j <= i; ++j) sum[j] += static_cast<double>(products[j]);
      }
    }
  });
}

// From sums about the origins to means, from products about the origins to those about the means.
template <class T, class Real>
void Pass<T, Real>::Finish(std::vector<double> sums, Scatter& scatter) const {
  const std::size_t p = X_.num_features;
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      scatter.products[i * p + j] /= frame_.factors[i] * frame_.factors[j];
    }
  }
  scatter.means = frame_.origins;
  for (std::size_t g = 0; g < num_groups_; ++g) {
    const auto count = static_cast<double>(scatter.num_rows[g]);
    if (scatter.num_rows[g] == 0) continue;
    double* offset = sums.data() + g * p;  // of the mean from the origin
    for (std::size_t j = 0; j < p; ++j) {
      offset[j] /= count;
      scatter.means[g * p + j] += offset[j];
    }
    for (std::size_t i = 0; i < p; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        scatter.products[i * p + j] -= count * offset[i] * offset[j];
      }
    }
  }
  for (std::size_t i = 0; i < p; ++i) {
    scatter.products[i * p + i] = std::max(0.0, scatter.products[i * p + i]);
    for (std::size_t j = 0; j < i; ++j) scatter.products[j * p + i] = scatter.products[i * p + j];
  }
}

// Blocks in flight: their products take at most about 64 MB; depends on the number of columns
// alone.
std::size_t BlocksInFlight(std::size_t num_features) {
  constexpr std::size_t kNumbers = std::size_t{8} << 20U;
  return std::clamp<std::size_t>(kNumbers / (num_features * num_features), 2, 8);
}

template <class T, class Real>
bool Pass<T, Real>::Run(Scatter& scatter) {
  const std::size_t p = X_.num_features;
  scatter = {.num_features = p, .num_rows = CountRows(), .means = {}, .products = {}};
  scatter.products.assign(p * p, 0.0);
  ChooseFrame();
  std::vector<double> sums(num_groups_ * p, 0.0);
  const std::size_t num_blocks = (X_.num_samples + kRowsPerBlock - 1) / kRowsPerBlock;
  std::vector<Block<Real>> blocks(std::min(num_blocks, BlocksInFlight(p)));
  for (std::size_t first = 0; first < num_blocks; first += blocks.size()) {
    const std::size_t count = std::min(blocks.size(), num_blocks - first);
    ParallelFor(count, options_.num_threads, [&](std::size_t b) {
      MultiplyBlock((first + b) * kRowsPerBlock, blocks[b]);
    });
    for (std::size_t b = 0; b < count; ++b) {
      const std::size_t begin = (first + b) * kRowsPerBlock;
      if (!IsHeld(blocks[b], std::min(kRowsPerBlock, X_.num_samples - begin))) return false;
      for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += blocks[b].sums[k];
    }
    AddBlocks(std::span(blocks).first(count), scatter);
    Report(options_.progress, "covariance", first + count, num_blocks);
  }
  Finish(std::move(sums), scatter);
  return true;
}

}  // namespace

std::string_view NameOf(ScatterPrecision precision) noexcept {
  return precision == ScatterPrecision::kDouble ? "double" : "single";
}

void ScatterOptions::Validate() const {
  RequireOption(num_threads >= 1, "ScatterOptions.num_threads", num_threads, ">= 1");
}

std::size_t Scatter::NumRows() const noexcept {
  return std::accumulate(num_rows.begin(), num_rows.end(), std::size_t{0});
}

template <class T>
Scatter ComputeScatter(const DesignMatrix<T>& X,
                       std::span<const std::uint8_t> groups,
                       std::size_t num_groups,
                       const ScatterOptions& options) {
  options.Validate();
  HC_CHECK(X.stride >= X.num_features, X.stride, X.num_features);
  HC_CHECK(groups.empty() ? num_groups == 1 : groups.size() == X.num_samples,
           groups.size(),
           X.num_samples,
           num_groups);
  if (X.num_samples == 0 || X.num_features == 0) {
    throw Error(
        {.kind = Error::Kind::kBadInput,
         .reason = fmt::format(
             "the design matrix is empty: {} samples, {} features", X.num_samples, X.num_features),
         .remedy = "give at least one sample and one feature"});
  }
  const SingleThreadedBlas single_threaded_blas;
  Scatter scatter;
  if (options.precision == ScatterPrecision::kSingle) {
    if (Pass<T, float>(X, groups, num_groups, options).Run(scatter)) return scatter;
  }
  if (!Pass<T, double>(X, groups, num_groups, options).Run(scatter)) {
    throw Error({.kind = Error::Kind::kBadInput,
                 .reason = "a column has a spread whose square double cannot hold",
                 .remedy = "multiply the column by a constant that brings it near 1"});
  }
  scatter.fell_back_to_double = options.precision == ScatterPrecision::kSingle;
  return scatter;
}

template Scatter ComputeScatter(const DesignMatrix<float>&,
                                std::span<const std::uint8_t>,
                                std::size_t,
                                const ScatterOptions&);
template Scatter ComputeScatter(const DesignMatrix<double>&,
                                std::span<const std::uint8_t>,
                                std::size_t,
                                const ScatterOptions&);

}  // namespace handcraft
