// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/grid.h"

#include <fmt/format.h>

#include "experiments/runner/study_entries.h"
#include "lib/core/error.h"

namespace handcraft::experiments {
namespace {

// A file of this name has an ending and, while it is written, seven bytes more; 255 are allowed.
constexpr std::size_t kMaxIdBytes = 230;

std::string IdOf(const Cell& cell) {
  return CombinationId(cell.method, cell.factors) + fmt::format(",repetition={}", cell.repetition);
}

CellSettings SettingsOf(const Study& study, const Method& method, const Cell& cell) {
  CellSettings settings;
  for (const auto* list : {&study.settings, &method.settings, &cell.factors}) {
    for (const Setting& setting : *list) ApplySetting(setting, settings);
  }
  return settings;
}

// What no single setting can be blamed for.
void CheckSettings(const Study& study, const Cell& cell) {
  if (cell.id.size() > kMaxIdBytes) {
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = fmt::format("the name of cell {} is longer than the {} bytes that a file's "
                               "may have",
                               cell.id,
                               kMaxIdBytes),
         .remedy = "make methods with short names of these values, in place of [grid]"});
  }
  const bool leaves_test_images = study.split == StudySplit::kManifest || study.test.has_value() ||
                                  cell.settings.training_share < 1.0;
  if (leaves_test_images) return;
  throw Error(
      {.kind = Error::Kind::kUsage,
       .reason = fmt::format("cell {}: training_share 1 leaves no picture to test with", cell.id),
       .remedy = "train on less, or name other pictures in [data.test]"});
}

}  // namespace

std::vector<Cell> MakeCells(const Study& study) {
  std::vector<Cell> cells;
  for (const Method& method : study.methods) {
    for (const std::vector<Setting>& factors : Combine(study.factors)) {
      for (int repetition = 1; repetition <= study.repetitions; ++repetition) {
        Cell cell{.id = {},
                  .method = method.name,
                  .factors = factors,
                  .repetition = repetition,
                  .seed = study.seed + static_cast<std::uint64_t>(repetition - 1),
                  .settings = {}};
        cell.id = IdOf(cell);
        cell.settings = SettingsOf(study, method, cell);
        CheckSettings(study, cell);
        cells.push_back(std::move(cell));
      }
    }
  }
  return cells;
}

}  // namespace handcraft::experiments
