// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/formats/fault.h"
#include "datasets/formats/mask_picture.h"
#include "datasets/importers/image_set_import.h"
#include "datasets/importers/source_tree.h"
#include "datasets/importers/staging_folder.h"
#include "lib/core/image.h"

/// Steps of an import that do not depend on what kind of set is made.
namespace handcraft::datasets {

/// Checks the options, refuses pictures or masks of one name, names the instances, thins the
/// pictures and splits them, as ImportPictures says.
void PlanImport(SourceSet& source, const ImportOptions& options);

/// Calls options.on_note, where there is one, with the notes on the source, then those on each
/// picture, in their order.
void TellNotes(const std::vector<Fault>& notes_on_source,
               const std::vector<std::vector<Fault>>& notes_of_pictures,
               const ImportOptions& options);

/// Makes the folders that files of these paths, relative to the staging folder, lie in.
void AddFoldersOf(const StagingFolder& staging, const std::vector<std::string>& files);

/// Writes the picture to `copy`: its file or what is embedded byte for byte, a made one as PNG.
/// Throws Error when it is no picture; the faults of an embedded one name its source. Nothing is
/// written where make_image returns an empty Image.
Image CopyPicture(const SourcePicture& picture, const std::filesystem::path& copy);

/// The path of its cloud in the set; empty when it has none.
[[nodiscard]] std::string CloudPath(const SourcePicture& picture);

/// Makes the cloud, which the picture has, and writes it. Throws Error when it is not of this size.
void WriteCloud(const SourcePicture& picture,
                const PixelSize& size,
                const std::filesystem::path& path);

}  // namespace handcraft::datasets
