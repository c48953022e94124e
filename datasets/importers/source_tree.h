// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Finding files in the folders of others.
namespace handcraft::datasets {

/// Throws Error for a file, a pipe or a device. A path where nothing is passes: opening it will
/// tell.
void RequireFolder(const std::filesystem::path& path);

/// Throws Error that names what stands at the path of a file and is of no use as one: a folder, a
/// pipe, a device, a link that leads nowhere, a file of 0 bytes. A path where nothing is passes.
void RequireFile(const std::filesystem::path& path);

/// Whether there is a file; false where nothing is. Throws as RequireFile does.
[[nodiscard]] bool HasFile(const std::filesystem::path& path);

/// Files of a folder and of the folders below it, `max_depth` levels deep (0: its own alone), in
/// the byte order of their paths; links to files are files. `is_meant` tells by its path what the
/// format wants as a file: RequireFile is asked of it. Throws Error when the folder is none or
/// cannot be read, and naming a link that leads nowhere or to a folder that would be listed, unless
/// its name begins with a dot.
[[nodiscard]] std::vector<std::filesystem::path> ListFiles(
    const std::filesystem::path& folder,
    int max_depth,
    const std::function<bool(const std::filesystem::path&)>& is_meant);

/// Whether the name ends as pictures do that ReadImage may read (.png, .jpg, .jpeg, .bmp, .ppm,
/// .pgm, in capitals too). What the file holds is not looked at.
[[nodiscard]] bool IsNamedLikeAPicture(const std::filesystem::path& path);

/// A file name that stands in the file `origin`, below `folder`, with / between folders on return;
/// none where nothing is. Backslashes are taken for separators, as Windows writes them. Throws
/// Error naming `origin` when it is empty, absolute or climbs out of the folder by "..", and as
/// RequireFile does.
[[nodiscard]] std::optional<std::filesystem::path> FindNamedFile(
    const std::filesystem::path& folder, std::string name, const std::filesystem::path& origin);

/// The first folder of a path, which by convention names the class; "object" if it has none.
[[nodiscard]] std::string ClassOfPath(const std::filesystem::path& relative);

}  // namespace handcraft::datasets
