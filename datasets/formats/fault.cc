// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/fault.h"

#include <map>

namespace handcraft::datasets {

Fault FaultOf(const Error& error, const std::filesystem::path& root) {
  const Error::Details& details = error.details();
  return {.path = std::filesystem::path(details.path).lexically_relative(root).string(),
          .reason = details.reason,
          .line = details.line,
          .remedy = details.remedy};
}

void CollectFaults(const std::filesystem::path& root,
                   std::vector<Fault>& faults,
                   const std::function<void()>& check) {
  try {
    check();
  } catch (const Error& error) {
    faults.push_back(FaultOf(error, root));
  }
}

void FindRowFaults(CsvRows& rows,
                   const std::filesystem::path& root,
                   const std::function<std::string()>& read_row,
                   RowFindings& findings) {
  std::map<std::string, std::size_t> line_of_row;
  CollectFaults(root, findings.faults, [&] {
    while (rows.Next()) {
      ++findings.num_rows;
      CollectFaults(root, findings.faults, [&] {
        const auto [first, is_new] = line_of_row.try_emplace(read_row(), rows.line());
        if (!is_new) rows.Fail("the same row as on line " + std::to_string(first->second));
      });
    }
    if (findings.num_rows == 0) rows.Fail("no row is listed");
  });
}

}  // namespace handcraft::datasets
