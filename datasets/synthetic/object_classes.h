// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "datasets/synthetic/material.h"
#include "datasets/synthetic/mesh.h"
#include "lib/core/rng.h"

namespace handcraft::synthetic {

/// A mesh that rests on z = 0 about the z axis, with the materials that its faces name.
struct Object {
  Mesh mesh;
  std::vector<Material> materials;
};

/// Which objects a picture shows: those a model is trained on, or those it has never seen. The two
/// have no builder and no range of parameters in common (dissertation, section 3.3).
enum class Family { kTrained, kNovel };

/// One kind of object, or of pairs of objects.
struct ObjectClass {
  std::string_view name;
  Family family = Family::kTrained;
  Object (*draw)(Rng& rng) = nullptr;  ///< one object, its parameters drawn from the kind's ranges
  int num_objects = 1;                 ///< of that kind in a picture
  int num_images_full = 0;             ///< pictures of it in the set of full size
};

/// The classes of a family in a fixed order. In full there are 13247 pictures of the trained ones,
/// 120 to 2001 each, as in the dissertation, which does not say which class has how many; and 30 of
/// each novel one.
[[nodiscard]] std::span<const ObjectClass> ClassesOf(Family family);

}  // namespace handcraft::synthetic
