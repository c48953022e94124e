// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace handcraft::experiments {

/// A place in which the results of two runs differ.
struct RunDifference {
  std::string cell;
  std::string object_class;
  std::string column;  ///< of results.csv; empty: the row is on one side alone
  std::string first;   ///< the field, or "missing"
  std::string second;
};

struct RunComparison {
  std::vector<std::string> inputs;         ///< names of inputs that differ, "study", "data.train"
  std::vector<RunDifference> differences;  ///< in the order of the first run, then of the second
  std::size_t num_rows = 0;                ///< rows that both have

  [[nodiscard]] bool IsSame() const noexcept { return inputs.empty() && differences.empty(); }
};

/// Compares results.csv of two folders field by field, rows told by cell and class, and their
/// pinned inputs. Texts are compared as they stand: numbers that differ in the last digit differ.
/// Throws Error when a folder has no results.
[[nodiscard]] RunComparison CompareRuns(const std::filesystem::path& first,
                                        const std::filesystem::path& second);

}  // namespace handcraft::experiments
