// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/formats/view_set.h"

namespace handcraft::datasets {

/// The views of a split, in their order; an empty name: all. Throws Error(kBadInput) naming the
/// splits there are when it has none.
[[nodiscard]] ViewSet OnlySplit(const ViewSet& set, std::string_view split);

/// The classes of a set in the order in which they first occur, and the class of each view.
struct ViewClasses {
  std::vector<std::string> names;
  std::vector<std::uint32_t> values;
};
[[nodiscard]] ViewClasses ClassesOf(const ViewSet& set);

/// A fold for each view, so that views that are nearly the same are never on both sides: where
/// every class has several instances, the fold of an instance is its number in the class modulo
/// `num_folds`; else neighbouring angles go together, fold ⌊angle / 360° · num_folds⌋, and views
/// without an angle are dealt out class by class. Throws Error(kUsage) unless num_folds ≥ 2.
[[nodiscard]] std::vector<std::uint32_t> GroupedFolds(const ViewSet& set, int num_folds);

}  // namespace handcraft::datasets
