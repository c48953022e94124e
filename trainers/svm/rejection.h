// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lib/core/design_matrix.h"
#include "lib/model_io/svm_model.h"

namespace handcraft::svm {

/// From where on a sample is taken for none of the classes, and what that costs.
struct Rejection {
  double threshold = 0.0;  ///< a margin below it is rejected
  std::size_t num_known = 0;
  std::size_t num_known_rejected = 0;  ///< of those, wrongly
  std::size_t num_novel = 0;
  std::size_t num_novel_rejected = 0;  ///< of those, rightly

  [[nodiscard]] double FalseRejection() const noexcept;    ///< share of known ones rejected
  [[nodiscard]] double FalseAcceptance() const noexcept;   ///< share of novel ones kept
  [[nodiscard]] double BalancedAccuracy() const noexcept;  ///< 1 − the mean of the two
};

/// Every threshold that there is to choose from, ascending: the smallest margin, below which there
/// is nothing, then halfway between neighbouring margins. From one to the next neither number of
/// rejected samples falls: what finds more novel ones loses more known ones. Neither list was seen
/// in training: margins of CrossValidate, and of a model on objects of no class. O(n log n);
/// deterministic. Throws Error(kBadInput) when either list is empty or holds a number that is not
/// finite.
[[nodiscard]] std::vector<Rejection> RejectionTradeOff(std::span<const double> known_margins,
                                                       std::span<const double> novel_margins);

/// Of that trade-off the largest balanced accuracy that rejects at most the share
/// `max_false_rejection` of the known samples; of equally good ones the lowest threshold, which
/// rejects fewest known samples. `trade_off` is not empty.
[[nodiscard]] Rejection ChooseRejection(std::span<const Rejection> trade_off,
                                        double max_false_rejection = 1.0);

/// Both at once, of known and novel margins.
[[nodiscard]] Rejection CalibrateRejection(std::span<const double> known_margins,
                                           std::span<const double> novel_margins,
                                           double max_false_rejection = 1.0);

/// A threshold, and the others that there were.
struct Calibration {
  Rejection chosen;
  std::vector<Rejection> trade_off;  ///< RejectionTradeOff
};

/// Sets the model's rejection threshold by margins of held-out known samples (CrossValidate) and
/// those of `novel`, raw numbers of objects of no class. Throws Error as MarginsOf and
/// RejectionTradeOff do.
template <class T>
Calibration RejectNovel(std::span<const double> known_margins,
                        const DesignMatrix<T>& novel,
                        double max_false_rejection,
                        int num_threads,
                        model_io::SvmModel& model);
extern template Calibration RejectNovel(
    std::span<const double>, const DesignMatrix<float>&, double, int, model_io::SvmModel&);
extern template Calibration RejectNovel(
    std::span<const double>, const DesignMatrix<double>&, double, int, model_io::SvmModel&);

}  // namespace handcraft::svm
