// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/region_pass.h"

#include <algorithm>

namespace handcraft::features::internal {
namespace {

class RegionPass {
 public:
  RegionPass(const ScoringLevel& level,
             const PixelMask& mask,
             const RegionBox& box,
             const RegionSums& sums,
             StripBuffers& buffers) noexcept
      : level_(level),
        mask_(mask),
        box_(box),
        sums_(sums.memory),
        stride_(RegionSums::Stride(level.planes.width())),
        radius_(level.window / 2),
        buffers_(buffers) {
    std::fill_n(sums_, RegionSums::NumFloats(level.planes.width(), level.window), 0.0F);
  }

  // Energies of row v into the sums of rows v − r … v + r; beyond the picture, those of its first
  // or last row once more.
  void AddRow(int v) noexcept {
    const int newest = v + radius_;
    if (newest < box_.last_v) {
      StartSums(
          level_, box_.first_u, box_.last_u - box_.first_u, newest, SumsOf(newest) + box_.first_u);
    }
    ForEachPiece(mask_, box_, v - radius_, newest, [&](const ColumnRun& run) {
      const int width = run.last - run.first;
      const int row = std::clamp(v, 0, level_.planes.height() - 1);
      FilterStripRow(level_.planes, level_.plan, level_.kernels, run.first, width, row, buffers_);
      CorrelateRowJob job{.energies = buffers_.energies.data(),
                          .weights = level_.weights,
                          .num_filters = level_.plan.num_filters,
                          .window = level_.window,
                          .count = width};
      for (int j = 0; j < level_.window; ++j) {
        job.sums[static_cast<std::size_t>(j)] = SumsOf(newest - j) + run.first;
      }
      level_.kernels.correlate_row(job);
    });
  }

  // The finished row, its wanted pixels as probabilities if they are due.
  const float* Finish(int v) noexcept {
    float* const row = SumsOf(v);
    if (!level_.as_probability) return row;
    ForEachRun(mask_, box_, v, v, [&](const ColumnRun& run) {
      level_.kernels.sigmoid_row(row + run.first, run.last - run.first);
    });
    return row;
  }

 private:
  [[nodiscard]] float* SumsOf(int v) const noexcept {
    return sums_ + (v + 2 * level_.window) % level_.window * stride_;
  }

  const ScoringLevel& level_;
  const PixelMask& mask_;
  const RegionBox& box_;
  float* sums_;
  std::ptrdiff_t stride_;
  int radius_;
  StripBuffers& buffers_;
};

void WriteMapRow(const PixelMask& mask,
                 const RegionBox& box,
                 int v,
                 const float* row,
                 const RegionOutput& output) noexcept {
  float* const out = output.map + v * output.stride;
  const std::uint8_t* const wanted = mask.Row(v);
  for (int u = box.first_u; u < box.last_u; ++u) out[u] = wanted[u] != 0 ? row[u] : 0.0F;
}

}  // namespace

void ScoreRegion(const ScoringLevel& level,
                 const PixelMask& mask,
                 const RegionBox& box,
                 const RegionSums& sums,
                 StripBuffers& buffers,
                 const RegionOutput& output) noexcept {
  if (output.map != nullptr) {
    for (int v = 0; v < level.planes.height(); ++v) {
      std::fill_n(output.map + v * output.stride, level.planes.width(), 0.0F);
    }
  }
  if (box.empty()) return;
  RegionPass pass(level, mask, box, sums, buffers);
  const int radius = level.window / 2;
  std::size_t next = 0;
  for (int v = box.first_v - radius; v < box.last_v + radius; ++v) {
    pass.AddRow(v);
    const int finished = v - radius;
    if (finished < box.first_v) continue;
    const float* const row = pass.Finish(finished);
    if (output.map != nullptr) {
      WriteMapRow(mask, box, finished, row, output);
      continue;
    }
    for (; next < output.pixels.size() && output.pixels[next].v == finished; ++next) {
      output.values[next] = row[output.pixels[next].u];
    }
  }
}

}  // namespace handcraft::features::internal
