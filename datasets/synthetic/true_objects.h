// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "datasets/formats/view_set.h"
#include "datasets/synthetic/mesh.h"

namespace handcraft::synthetic {

/// What stands in a made-up view: the mesh as it was rendered, and where.
struct TrueObject {
  Mesh mesh;  ///< resting on z = 0 of its own frame
  Eigen::Isometry3f base_from_object = Eigen::Isometry3f::Identity();
};

/// The object of a view that MakeViews or MakeDemonstrations made. Its mesh is drawn
/// again from the family and seed in the set's dataset.toml, which is in the folder above the
/// view's scene file, and the instance and scale there; its pose is the scene's. Thread-safe.
/// Throws Error naming the file for a view without a scene, a set that was not made up or by
/// another version of the generator, and a scene of several objects.
[[nodiscard]] TrueObject DrawTrueObject(const datasets::ViewSet& set, std::size_t index);

}  // namespace handcraft::synthetic
