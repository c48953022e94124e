// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/projector.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "lib/core/check.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

constexpr float kLeaveM = 2e-4F;     // how far above its surface a ray begins
constexpr float kArriveAt = 0.999F;  // and how far along its way it ends
constexpr int kCellsAcross = 1024;   // a power of two

// Pixels whose rays are cast together.
struct Batch {
  RayPacket rays;
  std::array<std::size_t, 4> pixels{};
};

void Cast(const RayTracer& tracer, Batch& batch, std::uint8_t* reached) {
  if (batch.rays.count == 0) return;
  const std::array<bool, 4> blocked = tracer.IsBlocked(batch.rays);
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.rays.count); ++i) {
    if (!blocked[i]) reached[batch.pixels[i]] = 255;
  }
  batch.rays.count = 0;
}

}  // namespace

Image ReachedFrom(const RayTracer& tracer, const PixelHits& pixels, const Vector3f& from_m) {
  Image reached(pixels.width_px, pixels.height_px);
  Batch batch;
  for (std::size_t i = 0; i < pixels.hits.size(); ++i) {
    if (pixels.hits[i].mesh == Hit::kNothing) continue;
    const SurfacePoint& point = pixels.points[i];
    const Vector3f begin = point.p_in_base + kLeaveM * point.normal;
    if (point.normal.dot(from_m - begin) <= 0.0F) continue;
    batch.pixels[static_cast<std::size_t>(batch.rays.count)] = i;
    batch.rays.Add(begin, from_m - begin, kArriveAt);
    if (batch.rays.IsFull()) Cast(tracer, batch, reached.Row(0));
  }
  Cast(tracer, batch, reached.Row(0));
  return reached;
}

DotPattern::DotPattern(float cell_px, Rng& rng) : cell_px_(cell_px) {
  HC_CHECK(cell_px > 0.0F, cell_px);
  constexpr std::size_t kBitsADraw = 64;
  cells_.reserve(static_cast<std::size_t>(kCellsAcross) * kCellsAcross);
  while (cells_.size() < static_cast<std::size_t>(kCellsAcross) * kCellsAcross) {
    const std::uint64_t bits = rng.Next();
    for (std::size_t bit = 0; bit < kBitsADraw; ++bit) {
      cells_.push_back(static_cast<std::uint8_t>(bits >> bit & 1U));
    }
  }
}

float DotPattern::Cell(int column, int row) const {
  constexpr auto kMask = static_cast<unsigned>(kCellsAcross - 1);
  const std::size_t x = static_cast<unsigned>(column) & kMask;
  const std::size_t y = static_cast<unsigned>(row) & kMask;
  return static_cast<float>(cells_[y * kCellsAcross + x]);
}

float DotPattern::At(float u_px, float v_px) const {
  const float x = u_px / cell_px_;
  const float y = v_px / cell_px_;
  const float column = std::floor(x);
  const float row = std::floor(y);
  const auto i = static_cast<int>(column);
  const auto j = static_cast<int>(row);
  const auto blend = [](float a, float b, float share) { return a + share * (b - a); };
  return blend(blend(Cell(i, j), Cell(i + 1, j), x - column),
               blend(Cell(i, j + 1), Cell(i + 1, j + 1), x - column),
               y - row);
}

void ProjectPattern(const DotPattern& pattern,
                    const PinholeCamera& projector,
                    const Image& reached,
                    const PixelHits& pixels,
                    float gain,
                    FloatImage& light) {
  HC_CHECK(light.width() == pixels.width_px && light.height() == pixels.height_px, light.width());
  for (int v = 0; v < pixels.height_px; ++v) {
    for (int u = 0; u < pixels.width_px; ++u) {
      if (reached.At(u, v) == 0) continue;
      const Eigen::Vector2f at = projector.Project(pixels.PointAt(u, v).p_in_base);
      const float factor = 1.0F + gain * pattern.At(at.x(), at.y());
      for (int channel = 0; channel < 3; ++channel) light.At(u, v, channel) *= factor;
    }
  }
}

}  // namespace handcraft::synthetic
