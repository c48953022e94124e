// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/image.h"

namespace handcraft::datasets {

/// Values of a label mask.
inline constexpr std::uint8_t kMaskGood = 255;
inline constexpr std::uint8_t kMaskBad = 0;
inline constexpr std::uint8_t kMaskDontCare = 128;

/// Columns that a manifest need not have: files that belong to a picture, as paths relative to the
/// set's folder.
inline constexpr std::string_view kObjectMask = "object_mask";  ///< 255 where the object is seen
inline constexpr std::string_view kDepth = "depth";             ///< 16-bit PNG, millimetres
inline constexpr std::string_view kCloud = "cloud";             ///< organised PCD
inline constexpr std::string_view kScene = "scene";             ///< poses, TOML
inline constexpr std::string_view kRightImage = "right_image";  ///< of a rectified pair
inline constexpr std::array kCompanions = {kObjectMask, kDepth, kCloud, kScene, kRightImage};

/// One row of a manifest.
struct LabelledImage {
  std::string image;         ///< path relative to the set's folder
  std::string mask;          ///< path relative to the set's folder
  std::string object_class;  ///< column "class"
  std::string instance;      ///< which object: never on both sides of a split
  std::string split;         ///< "train", "test", or any other name
  std::string licence;
  /// What its other columns hold, by their names: companions, and whatever else people note.
  /// Nothing is kept of an empty field.
  std::map<std::string, std::string, std::less<>> others = {};

  /// The path of a companion, empty when there is none.
  [[nodiscard]] std::string Companion(std::string_view column) const;

  bool operator==(const LabelledImage&) const = default;
};

/// A folder with `manifest.csv` (header image,mask,class,instance,split,licence; any order, with
/// any other columns). The format is specified in docs/datasets.md.
struct LabelledImageSet {
  std::filesystem::path root;
  std::vector<LabelledImage> items;

  /// The items of one split, in order; all when `split` is empty. Throws Error(kUsage) naming the
  /// splits there are when there is none of that name.
  [[nodiscard]] LabelledImageSet Only(const std::string& split) const;
};

/// Reads and checks the manifest: columns, file names inside the folder, no instance in two splits.
/// Throws Error with path and line. Pictures are not opened.
[[nodiscard]] LabelledImageSet ReadLabelledImageSet(const std::filesystem::path& root);

/// Writes root/manifest.csv, atomically: the six columns, then the companions that any item has,
/// then other columns in alphabetical order.
void WriteManifest(const LabelledImageSet& set);

/// A picture with its mask, checked: 8 bits, mask of the same size with the three values alone.
struct LabelledPicture {
  Image image;
  Image mask;
};
[[nodiscard]] LabelledPicture ReadLabelledPicture(const LabelledImageSet& set, std::size_t index);

/// The mask alone, its values checked.
[[nodiscard]] Image ReadMask(const LabelledImageSet& set, std::size_t index);

/// SHA-256 over sorted (path, SHA-256 of image, SHA-256 of mask, class, instance, split): same
/// data, same text, wherever the folder lies.
[[nodiscard]] std::string Fingerprint(const LabelledImageSet& set);

/// The licences of its pictures, each once.
[[nodiscard]] std::set<std::string> LicencesOf(const LabelledImageSet& set);

}  // namespace handcraft::datasets
