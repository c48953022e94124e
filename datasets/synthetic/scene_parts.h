// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/scene.h"

/// What scenes are put together from. Each function draws from its generator alone.
namespace handcraft::synthetic {

/// Height of what may lie anywhere, under other things too: sheets, cloths.
inline constexpr float kThinM = 0.0018F;

/// A direction in the plane, all equally likely.
[[nodiscard]] Eigen::Vector2f DrawDirection(Rng& rng);

/// Of an object that stands there, turned about z.
[[nodiscard]] Eigen::Isometry3f UprightPose(const Eigen::Vector3f& at_m, float yaw_rad);

/// Distance from the z axis to the farthest vertex [m].
[[nodiscard]] float FootprintRadius(const Object& object);

/// Adds the table, whose top is z = 0 about the origin, the floor and the walls. The table is 0.9
/// to 1.8 m by 0.7 to 1 m, times the scale.
void AddRoom(Scene& scene, float table_scale, Rng& rng);

/// Something flat that rests on z = 0: a sheet, a book, a cloth, a coin.
[[nodiscard]] Object DrawFlatThing(Rng& rng);

/// Draws the area light and the light from all around.
void DrawLight(Scene& scene, Rng& rng);

/// Exposure, noise and blur.
[[nodiscard]] SensorModel DrawSensor(Rng& rng);

}  // namespace handcraft::synthetic
