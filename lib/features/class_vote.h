// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace handcraft::features {

/// How two-class machines are put together to tell several classes apart. The numbers stand in
/// model files.
enum class ClassScheme : std::uint8_t {
  kOneAgainstOne = 0,  ///< a machine for each pair of classes; they vote
  kOneAgainstAll = 1,  ///< a machine for each class against the rest; the largest value wins
};

/// Machines for so many classes; of two classes there is one machine in either scheme.
[[nodiscard]] constexpr std::size_t NumMachines(ClassScheme scheme,
                                                std::size_t num_classes) noexcept {
  return scheme == ClassScheme::kOneAgainstOne || num_classes == 2
             ? num_classes * (num_classes - 1) / 2
             : num_classes;
}

/// The place of the machine of classes a < b, positive for a: pairs are ordered by their second
/// class, so that those of a class added later come last.
[[nodiscard]] constexpr std::size_t PairIndex(std::size_t a, std::size_t b) noexcept {
  return b * (b - 1) / 2 + a;
}

/// What the machines decide about a sample.
struct ClassVote {
  std::size_t winner = 0;
  /// One against one: the winner's smallest decision value against another class, negative if it
  /// lost to one. One against all: its decision value.
  double margin = 0.0;
};

/// The class that most pairs vote for (a positive decision value is a vote for the pair's first
/// class, any other for its second), or the one whose decision value is largest; of equal ones the
/// first, as in libsvm and OpenCV. `decision_values` holds NumMachines values; `votes` is scratch,
/// num_classes long. Does not allocate.
[[nodiscard]] ClassVote VoteForClass(ClassScheme scheme,
                                     std::span<const double> decision_values,
                                     std::span<std::int32_t> votes) noexcept;

}  // namespace handcraft::features
