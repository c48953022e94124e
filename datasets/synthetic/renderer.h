// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/scene.h"
#include "lib/core/image.h"

namespace handcraft::synthetic {

/// What a camera sees of a scene, and what is known about it.
struct View {
  FloatImage light;  ///< linear red, green, blue
  Image labels;      ///< 255 where all of a pixel is a target's graspable surface, 0 where none is,
                     ///< 128 where some is, along the part's edge
  Image object_mask;  ///< 255 where the pixel's centre shows a target, else 0
  FloatImage depth;   ///< along the optical axis at the pixel's centre [m]; 0: nothing there
};

/// Renders a scene from a camera, which need not be the scene's own: diffuse and mirrored light of
/// the area light with soft shadows, light from all around dimmed where surfaces shade each other,
/// four further samples in pixels that an edge crosses. Same scene and camera, same values; uses
/// one thread. Throws Error when Embree cannot be set up.
[[nodiscard]] View Render(const Scene& scene, const PinholeCamera& camera);

}  // namespace handcraft::synthetic
