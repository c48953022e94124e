// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/synthetic/mesh_file.h"
#include "datasets/synthetic/object_classes.h"
#include "lib/core/rng.h"

namespace handcraft::synthetic {

/// What the surface of a mesh without colours of its own is made of.
enum class Finish { kGlaze, kPlastic, kRubber, kMetal, kWood };

/// A mesh of a catalogue: the shape of one physical object.
struct CatalogueMesh {
  std::string object_class;
  Family family = Family::kTrained;
  std::string licence;  ///< of the mesh, and so of pictures of it
  LabelledMesh labelled;
  float least_scale = 1.0F;  ///< instances are scaled by least_scale … greatest_scale
  float greatest_scale = 1.0F;
  Finish finish = Finish::kGlaze;
  std::optional<Finish> graspable_finish;  ///< of its graspable faces; nothing: as the rest
};

/// A folder of meshes with a file meshes.toml that says what they are (docs/synthetic_data.md).
struct MeshCatalogue {
  std::vector<CatalogueMesh> meshes;  ///< in the file's order
  std::string fingerprint;            ///< SHA-256 over the path and the bytes of every file below
};

/// Reads meshes.toml and every mesh that it names. Throws Error naming file and line for a key that
/// is missing, unknown or of another type, a name that is none, a path that leaves the folder, and
/// all that ReadMeshFile refuses. The same files, the same catalogue.
[[nodiscard]] MeshCatalogue ReadMeshCatalogue(const std::filesystem::path& folder);

/// An object of that shape, its scale and colours drawn. Same state of the generator, same object.
[[nodiscard]] Object DrawCatalogueObject(const CatalogueMesh& mesh, Rng& rng);

}  // namespace handcraft::synthetic
