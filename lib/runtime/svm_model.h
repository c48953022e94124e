// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "lib/features/class_vote.h"
#include "lib/features/inner_products.h"
#include "lib/features/similarity.h"
#include "lib/runtime/aligned_buffer.h"

namespace handcraft::runtime {

/// Support vectors in the precision of the file, row after row, each filled up with zeros.
template <class T>
struct SupportVectors {
  AlignedBuffer buffer;
  features::PaddedRows<T> rows;
};

/// Which class a row of numbers belongs to (docs/model_format.md § 9). Immutable: any number of
/// threads may use one, each with scratch memory of its own.
class SvmModel {
 public:
  struct Prediction {
    features::ClassVote vote;
    bool is_rejected = false;  ///< the margin is below the threshold: none of the classes
  };

  [[nodiscard]] std::size_t NumFeatures() const noexcept { return feature_mean_.size(); }
  [[nodiscard]] std::size_t NumMachines() const noexcept { return intercepts_.size(); }
  [[nodiscard]] const std::vector<std::string>& ClassNames() const noexcept { return class_names_; }

  /// The margin below which a prediction is rejected; −∞ when none is.
  [[nodiscard]] double RejectionThreshold() const noexcept {
    return rejection_threshold_.value_or(-std::numeric_limits<double>::infinity());
  }

  /// Bytes of scratch memory, aligned to 64, that Predict works in.
  [[nodiscard]] std::size_t WorkspaceBytes() const noexcept;

  /// The class of a row of NumFeatures() finite numbers. One product of the matrix of support
  /// vectors with the row, shared by all machines. Does not allocate.
  [[nodiscard]] Prediction Predict(std::span<const double> row,
                                   std::span<std::byte> workspace) const noexcept;

  /// The value of every machine in the last prediction made in the workspace, where they lie.
  [[nodiscard]] std::span<const double> Decisions(std::span<std::byte> workspace) const noexcept;

  /// What the rounding of such a value is to be measured by: |b| + Σ |βK|.
  [[nodiscard]] double Magnitude(std::size_t machine,
                                 std::span<std::byte> workspace) const noexcept;

 private:
  friend class SvmLoader;

  struct Scratch;
  [[nodiscard]] Scratch Divide(std::span<std::byte> workspace) const noexcept;
  template <class T>
  void CompareWithSupport(const SupportVectors<T>& support,
                          std::span<const double> row,
                          const Scratch& scratch) const noexcept;
  void Evaluate(std::span<const double> row, const Scratch& scratch) const noexcept;

  features::Similarity similarity_;
  features::ClassScheme scheme_ = features::ClassScheme::kOneAgainstOne;
  std::vector<std::string> class_names_;
  std::vector<double> feature_mean_;
  std::vector<double> feature_scale_;
  std::variant<std::monostate, SupportVectors<float>, SupportVectors<double>> support_;
  std::vector<double> squared_norms_;  // of the support vectors
  std::vector<std::int32_t> machine_begins_;
  std::vector<std::int32_t> machine_supports_;
  std::vector<double> dual_coefficients_;
  std::vector<double> intercepts_;
  std::optional<double> rejection_threshold_;
};

}  // namespace handcraft::runtime
