// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace handcraft::experiments {

/// The area under the ROC curve of resampled groups (images): what the bootstrap asks for a
/// thousand times. The samples are sorted once; each resample is then one linear pass in which a
/// sample counts as often as its group was drawn. Exactly RocAuc of the samples written out.
///
/// Immutable after construction: OfResample may be called from many threads.
class GroupedAuc {
 public:
  /// Sample i belongs to group groups[i] < num_groups. Throws std::logic_error on lengths that
  /// differ, NaN scores, labels other than 0/1, or a group out of range. O(n log n).
  GroupedAuc(std::span<const double> scores,
             std::span<const std::uint8_t> labels,
             std::span<const std::size_t> groups,
             std::size_t num_groups);

  /// AUC of the listed groups, repeats counted; NaN when a class is missing. O(n), allocates
  /// num_groups counts.
  [[nodiscard]] double OfResample(std::span<const std::size_t> drawn_groups) const;

 private:
  struct Sample {
    std::size_t group = 0;
    bool is_good = false;
    bool ends_tie = false;  ///< the next sample has a lower score, or there is none
  };

  std::vector<Sample> descending_;
  std::size_t num_groups_;
};

}  // namespace handcraft::experiments
