// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "experiments/runner/cell_result.h"

namespace handcraft::testing {

/// A result filled in by hand: two pictures, one class, an AUC that could not be formed.
inline experiments::CellResult SmallResult(const std::string& id) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  experiments::CellResult result{.id = id,
                                 .num_training_images = 3,
                                 .num_samples = 200,
                                 .num_features = 20,
                                 .termination = "converged",
                                 .training_log_loss = 0.1,
                                 .features_time_s = 0.25,
                                 .training_time_s = 0.5,
                                 .score_time_ms = 7.0};
  experiments::GroupFigures group{.name = "mug, blue",
                                  .num_images = 2,
                                  .best_total = 30,
                                  .best_good = 20,
                                  .best_pixel_accuracy = {2.0 / 3.0, 0.5, 0.75},
                                  .auc = {nan, nan, nan},
                                  .log_loss = {0.3, 0.2, 0.4},
                                  .brier = {0.1, 0.05, 0.2}};
  result.groups.push_back(group);
  group.name = "all";
  result.groups.push_back(group);
  result.images = {{.image = "a.png",
                    .object_class = "mug, blue",
                    .best = {.good = 12, .bad = 3},
                    .num_pixels = 10,
                    .confusion = {.true_positive = 4, .true_negative = 5, .false_negative = 1},
                    .log_loss_sum = 1.0 / 3.0,
                    .squared_error_sum = 0.5},
                   {.image = "b.png", .object_class = "mug, blue", .best = {.good = 8, .bad = 7}}};
  result.curves = {.roc = {{0.0, 0.0}, {1.0 / 3.0, 0.5}, {1.0, 1.0}},
                   .precision_recall = {{0.5, 0.75}, {1.0, 0.5}},
                   .bands = {.roc = {{0.0, nan, nan}, {1.0, 0.25, 1.0}},
                             .precision_recall = {{0.5, 1.0 / 3.0, 0.9}}},
                   .reliability = {{{0.0, 0.5, 1, 3, 0.25}, {0.25, 0.1, nan}},
                                   {{0.5, 1.0, 0, 0, nan}, {nan, nan, nan}}}};
  result.search_space = {.num_images_without_region = 1,
                         .stages = {{.stage = "picture", .num_pixels = 300.0},
                                    {.stage = "region", .num_pixels = 12.5, .time_ms = 0.75}}};
  return result;
}

}  // namespace handcraft::testing
