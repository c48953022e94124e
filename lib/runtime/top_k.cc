// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/top_k.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace handcraft::runtime {
namespace {

// The order of the result; total, since no two pixels share a place and NaN never gets here.
bool IsBetter(const hc_point& a, const hc_point& b) noexcept {
  if (a.probability != b.probability) return a.probability > b.probability;
  return a.v != b.v ? a.v < b.v : a.u < b.u;
}

constexpr std::int32_t kMaxTilesPerAxis = 32;

// The tiles of a map and the best pixel of each that may still be taken (u < 0: none).
class TileBests {
 public:
  TileBests(const ProbabilityMap& map, float min_probability, std::int32_t radius_px) noexcept
      : map_(map),
        min_probability_(min_probability),
        radius_px_(radius_px),
        tile_width_(TileSize(map.width)),
        tile_height_(TileSize(map.height)),
        num_columns_((map.width - 1) / tile_width_ + 1),
        num_rows_((map.height - 1) / tile_height_ + 1) {
    for (std::int32_t row = 0; row < num_rows_; ++row) {
      for (std::int32_t column = 0; column < num_columns_; ++column) Rescan(column, row, {});
    }
  }

  // The best pixel that may be taken; u < 0: none is left.
  [[nodiscard]] hc_point Best() const noexcept {
    hc_point best = kNone;
    for (std::int32_t i = 0; i < num_columns_ * num_rows_; ++i) {
      const hc_point& candidate = bests_[static_cast<std::size_t>(i)];
      if (candidate.u >= 0 && (best.u < 0 || IsBetter(candidate, best))) best = candidate;
    }
    return best;
  }

  // Suppresses the square around the last of the points taken. In 64 bits: the radius may be large.
  void Suppress(std::span<const hc_point> taken) noexcept {
    const std::int64_t u = taken.back().u;
    const std::int64_t v = taken.back().v;
    const auto first_column = std::max<std::int64_t>(u - radius_px_, 0) / tile_width_;
    const auto first_row = std::max<std::int64_t>(v - radius_px_, 0) / tile_height_;
    const auto last_column = std::min<std::int64_t>(u + radius_px_, map_.width - 1) / tile_width_;
    const auto last_row = std::min<std::int64_t>(v + radius_px_, map_.height - 1) / tile_height_;
    for (auto row = first_row; row <= last_row; ++row) {
      for (auto column = first_column; column <= last_column; ++column) {
        const hc_point& best = BestOf(column, row);
        // A tile whose best pixel stays free keeps it: suppression only takes pixels away.
        if (best.u < 0 || !IsSuppressed(best.u, best.v, taken.last(1))) continue;
        Rescan(static_cast<std::int32_t>(column), static_cast<std::int32_t>(row), taken);
      }
    }
  }

 private:
  static constexpr hc_point kNone{-1, -1, 0.0F};

  static std::int32_t TileSize(std::int32_t size) noexcept {
    return std::max<std::int32_t>((size - 1) / kMaxTilesPerAxis + 1, 8);
  }

  hc_point& BestOf(std::int64_t column, std::int64_t row) noexcept {
    return bests_[static_cast<std::size_t>(row * num_columns_ + column)];
  }

  [[nodiscard]] bool IsSuppressed(std::int32_t u,
                                  std::int32_t v,
                                  std::span<const hc_point> taken) const noexcept {
    return std::any_of(taken.begin(), taken.end(), [&](const hc_point& point) {
      return std::abs(point.u - u) <= radius_px_ && std::abs(point.v - v) <= radius_px_;
    });
  }

  // The points whose squares reach into the tile, copied to `near`; all if they are too many.
  [[nodiscard]] std::span<const hc_point> PointsNear(std::int32_t column,
                                                     std::int32_t row,
                                                     std::span<const hc_point> taken,
                                                     std::span<hc_point> near) const noexcept {
    const std::int64_t u_begin = std::int64_t{column} * tile_width_ - radius_px_;
    const std::int64_t v_begin = std::int64_t{row} * tile_height_ - radius_px_;
    const std::int64_t u_end = u_begin + tile_width_ + 2 * std::int64_t{radius_px_};
    const std::int64_t v_end = v_begin + tile_height_ + 2 * std::int64_t{radius_px_};
    std::size_t count = 0;
    for (const hc_point& point : taken) {
      if (point.u < u_begin || point.u >= u_end || point.v < v_begin || point.v >= v_end) continue;
      if (count == near.size()) return taken;
      near[count++] = point;
    }
    return near.first(count);
  }

  // Row by row with a strict comparison, so that the first of equals wins.
  void Rescan(std::int32_t column, std::int32_t row, std::span<const hc_point> taken) noexcept {
    std::array<hc_point, 64> buffer;
    const std::span<const hc_point> near = PointsNear(column, row, taken, buffer);
    const std::int32_t u_begin = column * tile_width_;
    const std::int32_t u_end = std::min(u_begin + tile_width_, map_.width);
    const std::int32_t v_end = std::min((row + 1) * tile_height_, map_.height);
    hc_point best = kNone;
    best.probability = min_probability_;
    for (std::int32_t v = row * tile_height_; v < v_end; ++v) {
      const float* values = map_.Row(v);
      for (std::int32_t u = u_begin; u < u_end; ++u) {
        if (values[u] > best.probability && !IsSuppressed(u, v, near)) best = {u, v, values[u]};
      }
    }
    BestOf(column, row) = best;
  }

  ProbabilityMap map_;
  float min_probability_;
  std::int32_t radius_px_;
  std::int32_t tile_width_;
  std::int32_t tile_height_;
  std::int32_t num_columns_;
  std::int32_t num_rows_;
  std::array<hc_point, std::size_t{kMaxTilesPerAxis} * kMaxTilesPerAxis> bests_;
};

}  // namespace

std::size_t FindBest(const ProbabilityMap& map,
                     float min_probability,
                     std::span<hc_point> points) noexcept {
  if (points.empty()) return 0;
  // A heap with the worst kept point on top; pixels come in the order of ties, so that one that
  // equals the worst when the heap is full is rightly left out.
  const auto heap = points.begin();
  std::size_t count = 0;
  float threshold = min_probability;
  for (std::int32_t v = 0; v < map.height; ++v) {
    const float* values = map.Row(v);
    for (std::int32_t u = 0; u < map.width; ++u) {
      if (!(values[u] > threshold)) continue;
      if (count == points.size()) {
        std::pop_heap(heap, heap + static_cast<std::ptrdiff_t>(count), IsBetter);
      } else {
        ++count;
      }
      points[count - 1] = {u, v, values[u]};
      std::push_heap(heap, heap + static_cast<std::ptrdiff_t>(count), IsBetter);
      if (count == points.size()) threshold = std::max(threshold, points[0].probability);
    }
  }
  std::sort_heap(heap, heap + static_cast<std::ptrdiff_t>(count), IsBetter);
  return count;
}

std::size_t FindBestApart(const ProbabilityMap& map,
                          float min_probability,
                          std::int32_t radius_px,
                          std::span<hc_point> points) noexcept {
  if (points.empty()) return 0;
  TileBests tiles(map, min_probability, radius_px);
  std::size_t count = 0;
  while (count < points.size()) {
    const hc_point best = tiles.Best();
    if (best.u < 0) break;
    points[count++] = best;
    tiles.Suppress(points.first(count));
  }
  return count;
}

}  // namespace handcraft::runtime
