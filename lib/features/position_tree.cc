// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/position_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace handcraft::features {
namespace {

// Rows that are still to be looked at.
struct Part {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t axis = 0;
  double squared_gap_m2 = 0.0;  // from the point to the plane that cut it off
};

constexpr std::size_t kMaxDepth = 64;  // halving: one pending part a level
using Stack = std::array<Part, kMaxDepth>;

bool IsLeaf(const Part& part) noexcept { return part.last - part.first <= kTreeLeafRows; }
std::size_t MiddleOf(const Part& part) noexcept {
  return part.first + (part.last - part.first) / 2;
}
std::size_t NextAxis(std::size_t axis) noexcept { return axis == 2 ? 0 : axis + 1; }

// The nearest so far, in order, in the caller's memory.
class Shortlist {
 public:
  explicit Shortlist(std::span<Neighbour> places) noexcept : places_(places) {}

  // Whether something at this distance could still have a place.
  [[nodiscard]] bool Admits(double squared_distance_m2) const noexcept {
    return count_ < places_.size() || squared_distance_m2 <= places_.back().squared_distance_m2;
  }
  void Add(const Neighbour& found) noexcept {
    if (count_ == places_.size() && !IsBefore(found, places_.back())) return;
    std::size_t at = count_ < places_.size() ? count_++ : count_ - 1;
    for (; at > 0 && IsBefore(found, places_[at - 1]); --at) places_[at] = places_[at - 1];
    places_[at] = found;
  }
  [[nodiscard]] std::size_t size() const noexcept { return count_; }

 private:
  static bool IsBefore(const Neighbour& a, const Neighbour& b) noexcept {
    return a.squared_distance_m2 != b.squared_distance_m2
               ? a.squared_distance_m2 < b.squared_distance_m2
               : a.number < b.number;
  }

  std::span<Neighbour> places_;
  std::size_t count_ = 0;
};

void AddRow(const PositionTree& tree,
            std::size_t row,
            const Vector3& point,
            Shortlist& shortlist) noexcept {
  const double* p = tree.rows.data() + 3 * row;
  const double x = p[0] - point[0];
  const double y = p[1] - point[1];
  const double z = p[2] - point[2];
  shortlist.Add({x * x + y * y + z * z, tree.numbers[row], row});
}

}  // namespace

std::vector<std::size_t> TreeOrder(std::span<const Vector3> positions) {
  std::vector<std::size_t> order(positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<Part> parts = {{0, positions.size(), 0}};
  while (!parts.empty()) {
    const Part part = parts.back();
    parts.pop_back();
    if (IsLeaf(part)) continue;
    const std::size_t middle = MiddleOf(part);
    const auto at = [&order](std::size_t i) {
      return order.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(part.first), at(middle), at(part.last), [&](std::size_t a, std::size_t b) {
      const double x = positions[a][part.axis];
      const double y = positions[b][part.axis];
      return x != y ? x < y : a < b;
    });
    parts.push_back({part.first, middle, NextAxis(part.axis)});
    parts.push_back({middle + 1, part.last, NextAxis(part.axis)});
  }
  return order;
}

bool IsTree(std::span<const double> rows) noexcept {
  Stack stack;
  stack[0] = {0, rows.size() / 3, 0};
  std::size_t depth = 1;
  while (depth > 0) {
    const Part part = stack[--depth];
    if (IsLeaf(part)) continue;
    const std::size_t middle = MiddleOf(part);
    const double divider = rows[3 * middle + part.axis];
    for (std::size_t i = part.first; i < part.last; ++i) {
      const double value = rows[3 * i + part.axis];
      if (i < middle ? value > divider : value < divider) return false;
    }
    stack[depth++] = {part.first, middle, NextAxis(part.axis)};
    stack[depth++] = {middle + 1, part.last, NextAxis(part.axis)};
  }
  return true;
}

std::size_t FindNearest(const PositionTree& tree,
                        const Vector3& point,
                        std::span<Neighbour> nearest) noexcept {
  if (nearest.empty()) return 0;
  Shortlist shortlist(nearest);
  Stack stack;
  stack[0] = {0, tree.size(), 0};
  std::size_t depth = 1;
  while (depth > 0) {
    const Part part = stack[--depth];
    if (!shortlist.Admits(part.squared_gap_m2)) continue;
    if (IsLeaf(part)) {
      for (std::size_t row = part.first; row < part.last; ++row) {
        AddRow(tree, row, point, shortlist);
      }
      continue;
    }
    const std::size_t middle = MiddleOf(part);
    const double gap_m = point[part.axis] - tree.rows[3 * middle + part.axis];
    AddRow(tree, middle, point, shortlist);
    const std::size_t axis = NextAxis(part.axis);
    const Part below{part.first, middle, axis, 0.0};
    const Part above{middle + 1, part.last, axis, 0.0};
    // The point's own side is looked at first, so it goes on top.
    stack[depth] = gap_m < 0.0 ? above : below;
    stack[depth++].squared_gap_m2 = gap_m * gap_m;
    stack[depth++] = gap_m < 0.0 ? below : above;
  }
  return shortlist.size();
}

}  // namespace handcraft::features
