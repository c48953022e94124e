// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "datasets/synthetic/camera.h"
#include "datasets/synthetic/object_classes.h"
#include "datasets/synthetic/sensor.h"

namespace handcraft::synthetic {

/// An object in its place. Only targets have labels; the rest is surroundings.
struct PlacedObject {
  Object object;
  Eigen::Isometry3f base_from_object = Eigen::Isometry3f::Identity();
  bool is_target = false;
};

/// A rectangle that shines to its front.
struct AreaLight {
  Eigen::Vector3f centre_m = {0.0F, 0.0F, 2.0F};
  Eigen::Vector3f half_u_m = {0.2F, 0.0F, 0.0F};  ///< from the centre to the middle of an edge
  Eigen::Vector3f half_v_m = {0.0F, 0.2F, 0.0F};
  Colour intensity = Colour::Ones();  ///< irradiance that it gives at one metre, face to face
};

/// A table in a room with objects on it; the table's top is z = 0, the targets near the origin.
struct Scene {
  std::vector<PlacedObject> objects;
  AreaLight light;
  Colour ambient = Colour::Constant(0.3F);  ///< light from all around
  PinholeCamera camera;
  SensorModel sensor;
};

/// Draws everything but the targets, which are given: their places on the table, the table itself,
/// what else lies on it (paper, a book, a mat, coins), the room, light, camera and sensor. Targets
/// do not touch each other. Same state of the generator, same scene.
[[nodiscard]] Scene DrawScene(std::span<const Object> targets, Rng& rng);

/// Takes away what lies about the targets, and every pattern of table, floor and walls: what is
/// left to be seen beside the targets is even colour, shadows and the table's edge.
void MakeBare(Scene& scene);

}  // namespace handcraft::synthetic
