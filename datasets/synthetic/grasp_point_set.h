// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/synthetic/camera.h"
#include "datasets/synthetic/object_classes.h"
#include "datasets/synthetic/set_folder.h"
#include "lib/core/progress.h"

namespace handcraft::synthetic {

enum class SetSize {
  kSmall,  ///< 24 pictures a class
  kFull,   ///< as many as the dissertation has: 13247 of the trained family, 180 of the novel one,
           ///< 216 of the taught, 240 of the untaught, 144 of those that are regrasped
};

/// What is seen beside the objects.
enum class Surroundings {
  kHousehold,  ///< patterned table, room, sheets, books, cloths, coins
  kBare,       ///< even colours and shadows alone (MakeBare)
};

/// The most pictures that can be asked for by their number.
inline constexpr int kMaxImages = 1000000;

/// What is made. Every picture depends on seed, class and its number within the class alone, so a
/// larger set begins with the smaller one.
struct GraspPointSetOptions {
  Family family = Family::kTrained;
  Surroundings surroundings = Surroundings::kHousehold;
  SetSize size = SetSize::kSmall;
  int num_images = 0;  ///< spread evenly over the classes instead; 0: as `size` says
  /// A folder of meshes with a meshes.toml; empty: none. Every third instance of a class, from the
  /// first on, is then of the catalogue's meshes of this class and family; meshes of other classes
  /// make classes of their own (120 pictures in full). As shapes they are few, a model must not be
  /// tested on one it was trained on: pictures of them are all in train, or all in test where the
  /// family is for testing.
  std::filesystem::path meshes = {};
  bool with_right = false;    ///< also the picture of a second camera, to the right of the first
  float baseline_m = 0.12F;   ///< between the two cameras
  PinholeCamera camera = {};  ///< its intrinsics; the pose is drawn for each picture
  std::uint64_t seed = 1;
  int num_threads = 1;  ///< changes no byte
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

struct MadeImages {
  datasets::LabelledImageSet set;
  Written written;
};

/// Makes a labelled image set (docs/synthetic_data.md): images/, masks/, object_masks/, depth/ and
/// scenes/, dataset.toml first and manifest.csv last, so that a folder without a manifest is one
/// that is not finished. Called again, whether it was stopped or not, it keeps the pictures of
/// which every file is whole and makes the others (IsWhole, WriteList); the bytes are those of a
/// run that was not stopped. Throws Error when `out` holds anything else or a set made with other
/// options, and when it cannot write.
MadeImages MakeGraspPointSet(const std::filesystem::path& out, const GraspPointSetOptions& options);

}  // namespace handcraft::synthetic
