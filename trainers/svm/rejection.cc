// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/rejection.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "lib/core/error.h"
#include "trainers/svm/margins.h"

namespace handcraft::svm {
namespace {

struct Margin {
  double value;
  bool is_known;
};

void AddMargins(std::span<const double> values,
                bool is_known,
                const std::string& what,
                std::vector<Margin>& margins) {
  if (values.empty()) {
    throw Error({.kind = Error::Kind::kBadInput,
                 .reason = "no margins of " + what +
                           " samples: there is nothing to set the "
                           "threshold of rejection by",
                 .remedy = "give samples of objects that are known and of others"});
  }
  for (const double value : values) {
    if (!std::isfinite(value)) {
      throw Error({.kind = Error::Kind::kBadInput,
                   .reason = "a margin of a " + what + " sample is not a finite number",
                   .remedy = "look at the sample's features"});
    }
    margins.push_back({.value = value, .is_known = is_known});
  }
}

double Share(std::size_t part, std::size_t whole) noexcept {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

double Rejection::FalseRejection() const noexcept { return Share(num_known_rejected, num_known); }

double Rejection::FalseAcceptance() const noexcept {
  return 1.0 - Share(num_novel_rejected, num_novel);
}

double Rejection::BalancedAccuracy() const noexcept {
  return 1.0 - 0.5 * (FalseRejection() + FalseAcceptance());
}

std::vector<Rejection> RejectionTradeOff(std::span<const double> known_margins,
                                         std::span<const double> novel_margins) {
  std::vector<Margin> margins;
  margins.reserve(known_margins.size() + novel_margins.size());
  AddMargins(known_margins, true, "known", margins);
  AddMargins(novel_margins, false, "novel", margins);
  std::sort(margins.begin(), margins.end(), [](const Margin& a, const Margin& b) {
    return a.value < b.value;
  });
  Rejection at{.threshold = margins.front().value,
               .num_known = known_margins.size(),
               .num_novel = novel_margins.size()};
  std::vector<Rejection> trade_off = {at};
  for (std::size_t i = 0; i + 1 < margins.size(); ++i) {
    ++(margins[i].is_known ? at.num_known_rejected : at.num_novel_rejected);
    if (margins[i].value == margins[i + 1].value) continue;
    at.threshold = margins[i].value + 0.5 * (margins[i + 1].value - margins[i].value);
    trade_off.push_back(at);
  }
  return trade_off;
}

Rejection ChooseRejection(std::span<const Rejection> trade_off, double max_false_rejection) {
  Rejection best = trade_off.front();
  for (const Rejection& rejection : trade_off) {
    if (rejection.FalseRejection() <= max_false_rejection &&
        rejection.BalancedAccuracy() > best.BalancedAccuracy()) {
      best = rejection;
    }
  }
  return best;
}

Rejection CalibrateRejection(std::span<const double> known_margins,
                             std::span<const double> novel_margins,
                             double max_false_rejection) {
  return ChooseRejection(RejectionTradeOff(known_margins, novel_margins), max_false_rejection);
}

template <class T>
Calibration RejectNovel(std::span<const double> known_margins,
                        const DesignMatrix<T>& novel,
                        double max_false_rejection,
                        int num_threads,
                        model_io::SvmModel& model) {
  Calibration calibration{
      .chosen = {},
      .trade_off = RejectionTradeOff(known_margins, MarginsOf(model, novel, num_threads))};
  calibration.chosen = ChooseRejection(calibration.trade_off, max_false_rejection);
  model.rejection_threshold = calibration.chosen.threshold;
  return calibration;
}

template Calibration RejectNovel(
    std::span<const double>, const DesignMatrix<float>&, double, int, model_io::SvmModel&);
template Calibration RejectNovel(
    std::span<const double>, const DesignMatrix<double>&, double, int, model_io::SvmModel&);

}  // namespace handcraft::svm
