// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/formats/mask_picture.h"
#include "datasets/formats/organised_cloud.h"
#include "lib/core/image.h"

namespace handcraft::datasets {

/// One object seen from one side: a row of views.csv. Paths are relative to the set's folder.
struct ObjectView {
  std::string image;         ///< picture
  std::string object_mask;   ///< mask of the same size: kObject where the object is seen
  std::string cloud = {};    ///< organised PCD of the same size; empty: none
  std::string object_class;  ///< column "class": what is seen
  std::string instance;      ///< which physical object it is
  /// Turned by so much about z, in [0, 360); none where unknown.
  std::optional<double> angle_deg = std::nullopt;
  std::string split;          ///< train, test or any other name
  std::string licence = {};   ///< may be empty
  std::string depth = {};     ///< true depth: 16-bit PNG [mm], 0: nothing there; empty: none
  std::string scene = {};     ///< file that tells the poses; empty: none
  std::string symmetry = {};  ///< about z: "none", "half_turn" or "round"; empty: unknown

  bool operator==(const ObjectView&) const = default;
};

/// Pictures and point clouds of objects one at a time: a folder with views.csv in it. The format is
/// specified in docs/datasets.md.
struct ViewSet {
  std::filesystem::path root;
  std::vector<ObjectView> items;
};

/// Reads and checks views.csv: columns, paths that lie inside the folder, angles, no image twice,
/// no instance in two splits. Throws Error with path and line. Pictures and clouds are not opened.
[[nodiscard]] ViewSet ReadViewSet(const std::filesystem::path& root);

/// Writes root/views.csv; the optional columns that no view fills are left out. Throws Error when
/// it cannot.
void WriteViews(const ViewSet& set);

/// A view's files, checked: 8 bits, a mask of the picture's size with its two values alone, a cloud
/// of the picture's size.
struct LoadedView {
  Image image;
  Image object_mask;
  std::optional<OrganisedCloud> cloud;
};
[[nodiscard]] LoadedView ReadView(const ViewSet& set, std::size_t index);

/// The object mask alone, its values checked.
[[nodiscard]] Image ReadObjectMask(const ViewSet& set, std::size_t index);

/// SHA-256 over sorted (path, SHA-256 of image, of mask and of cloud, class, instance, angle,
/// split): same data, same text, wherever the folder lies. Without a cloud its part is empty.
[[nodiscard]] std::string Fingerprint(const ViewSet& set);

}  // namespace handcraft::datasets
