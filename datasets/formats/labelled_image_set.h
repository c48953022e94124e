// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "lib/core/image.h"

namespace handcraft::datasets {

/// Values of a label mask.
inline constexpr std::uint8_t kMaskGood = 255;
inline constexpr std::uint8_t kMaskBad = 0;
inline constexpr std::uint8_t kMaskDontCare = 128;

/// One row of a manifest.
struct LabelledImage {
  std::string image;         ///< path relative to the set's folder
  std::string mask;          ///< path relative to the set's folder
  std::string object_class;  ///< column "class"
  std::string instance;      ///< which object: never on both sides of a split
  std::string split;         ///< "train", "test", or any other name
  std::string licence;
};

/// A folder with `manifest.csv` (header image,mask,class,instance,split,licence; any order, other
/// columns are ignored). The format is specified in docs/datasets.md.
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

/// Writes root/manifest.csv.
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

/// What `handcraft data check` prints: each fault with its file (relative to the folder), nothing
/// when all is well. Pictures that cannot be read, masks that do not fit, hold other values or lack
/// good or bad pixels (legal, but nothing is drawn from them), and pictures that are there twice.
struct Fault {
  std::string path;
  std::string reason;
};
[[nodiscard]] std::vector<Fault> FindFaults(const LabelledImageSet& set);

}  // namespace handcraft::datasets
