// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "datasets/synthetic/ray_tracer.h"
#include "datasets/synthetic/scene_geometry.h"
#include "lib/core/image.h"

namespace handcraft::synthetic {

/// What the rays through the pixel centres have met, row by row.
struct PixelHits {
  int width_px = 0;
  int height_px = 0;
  std::vector<Hit> hits;
  std::vector<SurfacePoint> points;  ///< without materials

  [[nodiscard]] std::size_t Index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width_px) +
           static_cast<std::size_t>(u);
  }
  [[nodiscard]] const Hit& At(int u, int v) const { return hits[Index(u, v)]; }
  [[nodiscard]] const SurfacePoint& PointAt(int u, int v) const { return points[Index(u, v)]; }
};

/// Casts one ray through the centre of each pixel.
[[nodiscard]] PixelHits CastPixels(const RayTracer& tracer,
                                   const SceneGeometry& geometry,
                                   const PinholeCamera& camera);

/// The share of the area light that each pixel's surface sees, 0 ... 1: one ray a pixel first, to a
/// quarter of the light that changes from pixel to pixel; sixteen where a block of 2 × 2 pixels or
/// one beside it disagrees, and these smoothed over 3 × 3 pixels of the same object. A shadow's
/// full light and full dark are thus exact but for details smaller than about two pixels.
[[nodiscard]] FloatImage LightVisibility(const RayTracer& tracer,
                                         const PixelHits& pixels,
                                         const AreaLight& light);

/// The share of the sky, weighted by the cosine, that each pixel's surface sees within 0.3 m,
/// 0 ... 1: sixteen rays at every fourth pixel, smoothed along the surface.
[[nodiscard]] FloatImage SkyVisibility(const RayTracer& tracer, const PixelHits& pixels);

}  // namespace handcraft::synthetic
