// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/synthetic/view_sets.h"
#include "experiments/view_studies/view_study.h"
#include "tests/datasets/synthetic/small_camera.h"

namespace handcraft::testing {

/// A turntable of the four objects that are regrasped, seen by a small camera without fault: fast.
inline datasets::ViewSet MakeSmallViews(
    const std::filesystem::path& folder,
    int num_views,
    synthetic::ViewSetKind kind = synthetic::ViewSetKind::kTurntable) {
  return synthetic::MakeViewSet(folder,
                                {.kind = kind,
                                 .family = synthetic::Family::kRegrasp,
                                 .num_views = num_views,
                                 .sensor = synthetic::CloudSensor::kPerfect,
                                 .camera = synthetic::testing::SmallCamera()})
      .set;
}

/// A study of two methods on four such views of each object, in `folder`.
inline experiments::ViewStudy MakeSmallViewStudy(const std::filesystem::path& folder,
                                                 experiments::ViewTask task) {
  MakeSmallViews(folder, 4);
  return {.name = "small",
          .title = "Small",
          .task = task,
          .train = {.folder = folder.string()},
          .settings = {{"grid_size", "8"}},
          .methods = {{"poly", {{"kernel", "poly"}}}, {"linear", {{"kernel", "linear"}}}},
          .claim_source = "nowhere",
          .claims = {{"all", 100.0}}};
}

}  // namespace handcraft::testing
