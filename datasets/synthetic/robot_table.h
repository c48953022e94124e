// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/scene.h"

/// Scenes as the robot has them before it: it stands on the −x side of the table, looks towards +x,
/// and one object stands near the origin.
namespace handcraft::synthetic {

/// Standard deviations by which the camera is moved between two views.
struct CameraNoise {
  float position_m = 0.0F;  ///< along each axis of the base frame; 0 ... 0.05
  float angle_deg = 0.0F;   ///< about each axis of the camera; 0 ... 5
};

/// Where the robot's camera stands when nothing moves it: 0.45 m above the table, half a metre
/// before the origin, which it sees from 0.62 m.
[[nodiscard]] Eigen::Isometry3f RobotCameraPose();

/// Draws all but the object: room and table, thin things on it, light and sensor. The camera has
/// the intrinsics of `lens` and stands at RobotCameraPose.
[[nodiscard]] Scene DrawRobotTable(const PinholeCamera& lens, Rng& rng);

/// The pose, moved and turned by noise.
[[nodiscard]] Eigen::Isometry3f DrawNear(const Eigen::Isometry3f& base_from_camera,
                                         const CameraNoise& noise,
                                         Rng& rng);

/// Whether every vertex lies at least 2 pixels within the picture and 0.4 m before the camera.
[[nodiscard]] bool IsSeenWhole(const Mesh& mesh,
                               const Eigen::Isometry3f& base_from_object,
                               const PinholeCamera& camera);

/// An object in some place, turned and larger or smaller than it was built.
struct MovedObject {
  Object object;  ///< scaled
  Eigen::Isometry3f base_from_object = Eigen::Isometry3f::Identity();
  double angle_deg = 0.0;  ///< about z, in [0, 360)
  float scale = 1.0F;
};

/// Draws a place on the table within 0.1 m of the origin along x and 0.22 m along y, a turn, and a
/// scale from 0.8 to 1.25, all equally likely (turns in hundredths of a degree), again until the
/// camera sees the object whole. Throws Error(kUsage) when it has not after 1000 draws: another
/// lens is needed.
[[nodiscard]] MovedObject DrawMoved(const Object& object, const PinholeCamera& camera, Rng& rng);

}  // namespace handcraft::synthetic
