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

/// A mesh that rests on z = 0 about the z axis, with the materials that its faces name. Its front
/// faces +x: the handle, chuck or nozzle, or else the broad side with the label.
struct Object {
  Mesh mesh;
  std::vector<Material> materials;
};

/// Which objects a picture shows.
enum class Family {
  kTrained,   ///< those that grasp points are learnt on (dissertation, section 3.3)
  kNovel,     ///< others that they are tested with
  kTaught,    ///< those whose grasps the robot was taught (section 4.2.1)
  kUntaught,  ///< others that it is tested with (section 4.3)
  kRegrasp,   ///< those that are passed from hand to hand (section 5.3)
};

/// The name of a family on the command line and in files: trained, novel, taught, untaught,
/// regrasp.
[[nodiscard]] std::string_view NameOf(Family family);

/// The family of this name; throws Error(kUsage) naming the five for any other.
[[nodiscard]] Family FamilyNamed(std::string_view name);

/// Which turns about z give the same shape (print and small parts such as a spout aside).
enum class Symmetry {
  kNone,      ///< no turn
  kHalfTurn,  ///< half a turn
  kRound,     ///< any turn
};

/// As a view set names it: none, half_turn, round.
[[nodiscard]] std::string_view NameOf(Symmetry symmetry);

/// One kind of object, or of pairs of objects.
struct ObjectClass {
  std::string_view name;
  Family family = Family::kTrained;
  Object (*draw)(Rng& rng) = nullptr;  ///< one object, its parameters drawn from the kind's ranges
  int num_objects = 1;                 ///< of that kind in a picture
  int num_images_full = 0;             ///< pictures of it in the set of full size
  Symmetry symmetry = Symmetry::kNone;
};

/// The classes of a family in a fixed order. In full there are 13247 pictures of the trained ones,
/// 120 to 2001 each, as in the dissertation, which does not say which class has how many; 36 of
/// each taught one and of each that is regrasped, 30 of each novel and untaught one. The trained
/// and the novel ones, and the taught and the untaught ones, have no builder and no range of
/// parameters in common; can, drill and water bottle are regrasped by the builders of chapter 4's.
[[nodiscard]] std::span<const ObjectClass> ClassesOf(Family family);

}  // namespace handcraft::synthetic
