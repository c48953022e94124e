// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "experiments/runner/study_run.h"
#include "tests/experiments/runner/small_study.h"

namespace handcraft::testing {

/// The cells of SmallStudy filled in by hand: six pictures of two classes with ten best pixels
/// each; "laplacian" has eight good ones, "edge" seven, one less with ridge 2.
/// Of ten good and ten bad pixels each calls right all bad ones and as many good ones.
inline experiments::StudyRun SmallRun() {
  experiments::StudyRun run{.study = SmallStudy("data")};
  run.study.claim = experiments::Claim{"Section 9", 15.0};
  run.data.train_fingerprint = "0123abcd";
  run.cells = experiments::MakeCells(run.study);
  for (const experiments::Cell& cell : run.cells) {
    experiments::CellResult result{
        .id = cell.id, .num_samples = 200, .num_features = 1, .termination = "converged"};
    const std::size_t good =
        (cell.method == "edge" ? 7U : 8U) - (cell.factors[0].value == "2" ? 1U : 0U);
    for (int i = 0; i < 6; ++i) {
      result.images.push_back(
          {.image = "p" + std::to_string(i),
           .object_class = i < 3 ? "mug <blue>" : "pen|cil",
           .best = {.good = good, .bad = 10 - good},
           .num_pixels = 20,
           .confusion = {.true_positive = good, .true_negative = 10, .false_negative = 10 - good},
           .strict_confusion = {
               .true_positive = 5, .false_positive = 0, .true_negative = 10, .false_negative = 5}});
    }
    result.groups.push_back(
        {.name = "all", .confusion = {.true_positive = 5, .true_negative = 7}, .auc = {0.75}});
    run.results.push_back(std::move(result));
  }
  return run;
}

}  // namespace handcraft::testing
