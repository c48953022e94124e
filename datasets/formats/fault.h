// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "datasets/formats/csv_rows.h"
#include "lib/core/error.h"

namespace handcraft::datasets {

/// Whether what was found must be mended.
enum class Gravity {
  kFault,
  kNote,  ///< legal, and worth knowing
};

/// Something wrong with a data set, and the place that it is wrong at.
struct Fault {
  std::string path;                                ///< relative to the set's folder
  std::string reason;                              ///< what was found, and what was expected
  std::optional<std::size_t> line = std::nullopt;  ///< of a list, 1-based; none: of the whole file
  Gravity gravity = Gravity::kFault;
  std::string remedy = {};  ///< what to do about it; may be empty
};

/// An error as the fault it names, its path relative to the set's folder.
[[nodiscard]] Fault FaultOf(const Error& error, const std::filesystem::path& root);

/// Runs a check of files of the set in `root` and adds the Error that it throws to the faults.
void CollectFaults(const std::filesystem::path& root,
                   std::vector<Fault>& faults,
                   const std::function<void()>& check);

/// What is found in the rows of a list.
struct RowFindings {
  std::size_t num_rows = 0;  ///< sound or not
  std::vector<Fault> faults;
};

/// Looks at each row and adds the Error that `read_row` throws for it to the findings. What it
/// returns is the row as Handcraft writes it: a row that is there twice is a fault of the later
/// one. Where the text is no CSV any more the search ends. A list without rows is a fault. All
/// findings so far stay when an Error comes from elsewhere.
void FindRowFaults(CsvRows& rows,
                   const std::filesystem::path& root,
                   const std::function<std::string()>& read_row,
                   RowFindings& findings);

}  // namespace handcraft::datasets
