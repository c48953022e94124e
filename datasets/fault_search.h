// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "datasets/formats/fault.h"
#include "datasets/parallel_reporting.h"
#include "lib/core/progress.h"

namespace handcraft::datasets {

/// What is found in the files of one picture.
struct PictureFindings {
  std::vector<Fault> faults;
  std::string image_digest;  ///< SHA-256 of the image file; empty: it cannot be read
};

/// Examines the set's pictures, each by its index, on several threads at once; the findings are
/// joined in the set's order, and a picture that is there twice is a fault of the later one. Same
/// set, same faults for any number of threads. `Set` has items with an image and a split.
template <class Set>
[[nodiscard]] std::vector<Fault> FindPictureFaults(
    const Set& set,
    int num_threads,
    const Progress& progress,
    const std::function<PictureFindings(std::size_t)>& examine) {
  std::vector<PictureFindings> findings(set.items.size());
  ParallelForReporting(
      set.items.size(), num_threads, progress, "checking files", [&](std::size_t i) {
        findings[i] = examine(i);
      });
  std::vector<Fault> faults;
  std::map<std::string, std::size_t> first_of_content;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    faults.insert(faults.end(), findings[i].faults.begin(), findings[i].faults.end());
    if (findings[i].image_digest.empty()) continue;
    const auto [first, is_new] = first_of_content.try_emplace(findings[i].image_digest, i);
    if (is_new) continue;
    const auto& twin = set.items[first->second];
    const bool is_apart = twin.split != set.items[i].split;
    faults.push_back(
        {set.items[i].image,
         "the same picture as " + twin.image + (is_apart ? ", which is in another split" : "")});
  }
  return faults;
}

}  // namespace handcraft::datasets
