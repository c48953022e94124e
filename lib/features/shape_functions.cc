// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/shape_functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>

#include "lib/core/rng.h"

namespace handcraft::features {
namespace {

constexpr int kGridSize = 64;
constexpr float kRadius = 32.0F;  // of the ball, in voxels

enum Kind : std::uint8_t { kIn = 0, kOut = 1, kMixed = 2 };

struct Point {
  float x = 0.0F;  // [voxels], from the mean
  float y = 0.0F;
  float z = 0.0F;
  std::array<std::uint8_t, 4> voxel = {};  // the last is of no meaning
};

struct Triangle {
  std::array<float, 3> sides = {};  // [voxels]
  float root_area = 0.0F;
  std::array<std::uint8_t, 4> kinds = {};  // of the sides and of the triangle
};

// Which voxels are full: bit z of word 64 x + y.
class VoxelGrid {
 public:
  explicit VoxelGrid(std::uint64_t* words) noexcept : words_(words) {
    std::fill_n(words_, kNumWords, std::uint64_t{0});
  }
  static constexpr std::size_t kNumWords = std::size_t{kGridSize} * kGridSize;

  // Fills the voxels about one.
  void Fill(const std::array<std::uint8_t, 4>& voxel) noexcept {
    const std::uint64_t bit = std::uint64_t{1} << voxel[2];
    const std::uint64_t bits = bit | (bit << 1U) | (bit >> 1U);
    for (int x = std::max(voxel[0] - 1, 0); x <= std::min(voxel[0] + 1, kGridSize - 1); ++x) {
      for (int y = std::max(voxel[1] - 1, 0); y <= std::min(voxel[1] + 1, kGridSize - 1); ++y) {
        words_[x * kGridSize + y] |= bits;
      }
    }
  }

  // Whether the voxel of a word of Trace is full: 0 or 1.
  [[nodiscard]] int At(std::uint64_t at) const noexcept;

 private:
  std::uint64_t* words_;
};

struct Line {
  int num_voxels = 0;
  int num_full = 0;

  [[nodiscard]] Kind KindOf() const noexcept {
    if (num_full >= num_voxels - 1) return kIn;
    return num_full <= 7 ? kOut : kMixed;
  }
};

// A voxel in one word: 20 bits an axis, of them kFractionBits behind the point.
constexpr unsigned kFractionBits = 14;
constexpr unsigned kAxisBits = kFractionBits + 6;
constexpr std::int64_t kOne = std::int64_t{1} << kFractionBits;

int VoxelGrid::At(std::uint64_t at) const noexcept {
  const std::uint64_t x = at >> (2 * kAxisBits + kFractionBits);
  const std::uint64_t y = (at >> (kAxisBits + kFractionBits)) % kGridSize;
  const std::uint64_t z = (at >> kFractionBits) % kGridSize;
  return static_cast<int>((words_[x * kGridSize + y] >> z) & 1U);
}

// Bresenham's line in three dimensions. Along an axis of m voxels out of the longest axis' l, its
// voxel after i steps is ⌊t⌋ = ⌊½ − 1/(4l) + i m/l⌋ from the first: t is at least 1/(4l) from any
// whole number, which 14 bits keep for l ≤ 63, so that one addition takes all three axes to the
// next voxel.
Line Trace(const VoxelGrid& grid, const Point& from, const Point& to) noexcept {
  std::array<int, 3> lengths;
  for (std::size_t axis = 0; axis < 3; ++axis) lengths[axis] = to.voxel[axis] - from.voxel[axis];
  const int longest =
      std::max({1, std::abs(lengths[0]), std::abs(lengths[1]), std::abs(lengths[2])});
  const float scale = static_cast<float>(kOne) / static_cast<float>(longest);
  const auto begin = static_cast<std::int64_t>(0.5F * static_cast<float>(kOne) - 0.25F * scale);
  std::int64_t at = 0;
  std::int64_t step = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float slope = static_cast<float>(std::abs(lengths[axis])) * scale + 0.5F;
    const bool falls = lengths[axis] < 0;
    const std::int64_t first = from.voxel[axis] * kOne + (falls ? kOne - begin : begin);
    at = (at << kAxisBits) + first;
    step = (step << kAxisBits) + (falls ? -1 : 1) * static_cast<std::int64_t>(slope);
  }
  Line line{.num_voxels = longest};
  for (int i = 0; i < longest; ++i, at += step) {
    line.num_full += grid.At(static_cast<std::uint64_t>(at));
  }
  return line;
}

// Voxels are cut at whole numbers; what lies on one is nearer to the middle.
std::uint8_t VoxelOf(float x) noexcept {
  const int voxel = x < 0.0F ? static_cast<int>(std::floor(x)) + kGridSize / 2
                             : static_cast<int>(std::ceil(x)) + kGridSize / 2 - 1;
  return static_cast<std::uint8_t>(std::clamp(voxel, 0, kGridSize - 1));
}

// False when all points are in one place.
bool ScaleIntoBall(std::span<const Vector3> points_m, std::span<Point> scaled) noexcept {
  Vector3 mean_m = {};
  for (const Vector3& p : points_m) {
    for (std::size_t axis = 0; axis < 3; ++axis) mean_m[axis] += p[axis];
  }
  for (double& value : mean_m) value /= static_cast<double>(points_m.size());
  double squared = 0.0;
  for (const Vector3& p : points_m) {
    const Vector3 d = Subtract(p, mean_m);
    squared = std::max(squared, Dot(d, d));
  }
  if (!(squared > 0.0)) return false;
  const double scale = double{kRadius} / std::sqrt(squared);
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    const Vector3 d = Subtract(points_m[i], mean_m);
    Point& point = scaled[i];
    point.x = static_cast<float>(d[0] * scale);
    point.y = static_cast<float>(d[1] * scale);
    point.z = static_cast<float>(d[2] * scale);
    point.voxel = {VoxelOf(point.x), VoxelOf(point.y), VoxelOf(point.z), 0};
  }
  return true;
}

struct Side {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
  float length = 0.0F;
};

Side SideOf(const Point& from, const Point& to) noexcept {
  Side side{.x = to.x - from.x, .y = to.y - from.y, .z = to.z - from.z};
  side.length = std::sqrt(side.x * side.x + side.y * side.y + side.z * side.z);
  return side;
}

// Of the triangle with these sides; Heron's formula would not tell slivers from lines.
float SquaredArea(const Side& a, const Side& b) noexcept {
  const float x = a.y * b.z - a.z * b.y;
  const float y = a.z * b.x - a.x * b.z;
  const float z = a.x * b.y - a.y * b.x;
  return 0.25F * (x * x + y * y + z * z);
}

std::size_t BinOf(float share) noexcept {
  const float nearest = share * static_cast<float>(kShapeBins - 1) + 0.5F;  // truncated below
  return static_cast<std::size_t>(nearest);
}

// Of the acute angle between two lines.
std::size_t AngleBin(const Side& a, const Side& b) noexcept {
  const float cosine = std::fabs(a.x * b.x + a.y * b.y + a.z * b.z) / (a.length * b.length);
  constexpr float kQuarterTurn = std::numbers::pi_v<float> / 2.0F;
  return BinOf(std::acos(std::min(cosine, 1.0F)) / kQuarterTurn);
}

Kind KindOf(const std::array<Line, 3>& lines) noexcept {
  const int num_full = lines[0].num_full + lines[1].num_full + lines[2].num_full;
  const int num_voxels = lines[0].num_voxels + lines[1].num_voxels + lines[2].num_voxels;
  if (num_full <= 21) return kOut;
  return num_voxels - num_full < 4 ? kIn : kMixed;
}

// What is counted, before the weights; three histograms of kShapeBins for each but the last.
struct Counts {
  std::array<double, 3 * kShapeBins> angles = {};
  std::array<double, 3 * kShapeBins> areas = {};
  std::array<double, 3 * kShapeBins> lengths = {};
  std::array<double, kShapeBins> ratios = {};
};

// Counts angles and ratios; false for a sliver, of which nothing is counted.
bool Take(const VoxelGrid& grid,
          const std::array<const Point*, 3>& corners,
          Triangle& triangle,
          Counts& counts) noexcept {
  const std::array<Side, 3> sides = {SideOf(*corners[0], *corners[1]),
                                     SideOf(*corners[0], *corners[2]),
                                     SideOf(*corners[1], *corners[2])};
  triangle.sides = {sides[0].length, sides[1].length, sides[2].length};
  const float squared_area = SquaredArea(sides[0], sides[1]);
  constexpr float kLeastSquaredArea = 0.001F;
  if (!(squared_area > kLeastSquaredArea)) return false;
  triangle.root_area = std::sqrt(std::sqrt(squared_area));
  const std::array<Line, 3> lines = {Trace(grid, *corners[0], *corners[1]),
                                     Trace(grid, *corners[0], *corners[2]),
                                     Trace(grid, *corners[1], *corners[2])};
  for (std::size_t k = 0; k < lines.size(); ++k) {
    triangle.kinds[k] = lines[k].KindOf();
    if (triangle.kinds[k] != kMixed) continue;
    ++counts.ratios[BinOf(static_cast<float>(lines[k].num_full) /
                          static_cast<float>(lines[k].num_voxels))];
  }
  triangle.kinds[3] = KindOf(lines);
  double* const angles = &counts.angles[triangle.kinds[3] * kShapeBins];
  for (std::size_t k = 0; k < lines.size(); ++k) {  // the angle that faces side k
    angles[AngleBin(sides[(k + 1) % 3], sides[(k + 2) % 3])] += lines[k].num_voxels / 32.0;
  }
  return true;
}

void CountLengthsAndAreas(std::span<const Triangle> triangles, Counts& counts) noexcept {
  float longest = 0.0F;
  float largest = 0.0F;
  for (const Triangle& t : triangles) {
    longest = std::max({longest, t.sides[0], t.sides[1], t.sides[2]});
    largest = std::max(largest, t.root_area);
  }
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++counts.lengths[t.kinds[k] * kShapeBins + BinOf(t.sides[k] / longest)];
    }
    ++counts.areas[t.kinds[3] * kShapeBins + BinOf(t.root_area / largest)];
  }
}

void Write(const Counts& counts, std::span<float, kShapeFunctionsSize> histogram) noexcept {
  constexpr std::array<double, 10> kWeights = {0.5, 0.5, 0.5, 0.5, 0.5, 1.0, 0.5, 2.0, 2.0, 1.0};
  const auto count = [&counts](std::size_t i) {
    constexpr std::size_t kThree = 3 * kShapeBins;
    if (i < kThree) return counts.angles[i];
    if (i < 2 * kThree) return counts.areas[i - kThree];
    return i < 3 * kThree ? counts.lengths[i - 2 * kThree] : counts.ratios[i - 3 * kThree];
  };
  double sum = 0.0;
  for (std::size_t i = 0; i < kShapeFunctionsSize; ++i) sum += kWeights[i / kShapeBins] * count(i);
  for (std::size_t i = 0; i < kShapeFunctionsSize; ++i) {
    histogram[i] = static_cast<float>(kWeights[i / kShapeBins] * count(i) / sum);
  }
}

}  // namespace

std::size_t ShapeFunctionsWorkspace(std::size_t num_points) noexcept {
  return VoxelGrid::kNumWords * sizeof(std::uint64_t) + num_points * sizeof(Point) +
         kNumTriangles * sizeof(Triangle);
}

void DescribeByShapeFunctions(std::span<const Vector3> points_m,
                              std::span<std::byte> workspace,
                              std::span<float, kShapeFunctionsSize> histogram) noexcept {
  std::fill(histogram.begin(), histogram.end(), 0.0F);
  auto* const words = reinterpret_cast<std::uint64_t*>(workspace.data());
  const std::span points(reinterpret_cast<Point*>(words + VoxelGrid::kNumWords), points_m.size());
  const std::span triangles(reinterpret_cast<Triangle*>(points.data() + points.size()),
                            std::size_t{kNumTriangles});
  if (points.size() < 3 || !ScaleIntoBall(points_m, points)) return;
  VoxelGrid grid(words);
  for (const Point& point : points) grid.Fill(point.voxel);
  Counts counts;
  Rng rng = Rng::Stream(1, "shape functions");
  const auto draw = [&rng, &points] {
    return &points[static_cast<std::size_t>(rng.Uniform() * static_cast<double>(points.size()))];
  };
  std::size_t size = 0;
  for (int k = 0; k < 2 * kNumTriangles && size < triangles.size(); ++k) {
    const Point* const first = draw();
    const Point* const second = draw();
    const Point* const third = draw();
    if (Take(grid, {first, second, third}, triangles[size], counts)) ++size;
  }
  if (size == 0) return;
  CountLengthsAndAreas(triangles.first(size), counts);
  Write(counts, histogram);
}

}  // namespace handcraft::features
