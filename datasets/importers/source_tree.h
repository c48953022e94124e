// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Finding files in the folders of others.
namespace handcraft::datasets {

/// Throws Error for a file. A path where nothing is passes: opening it will tell.
void RequireFolder(const std::filesystem::path& path);

/// Files of a folder and of the folders below it, `max_depth` levels deep (0: its own alone), in
/// the byte order of their paths; links to files are files. Throws Error when the folder is a file
/// or cannot be read, and naming a link that leads nowhere or
/// to a folder that would be listed, unless its name begins with a dot.
[[nodiscard]] std::vector<std::filesystem::path> ListFiles(const std::filesystem::path& folder,
                                                           int max_depth);

/// Whether the name ends as pictures do that ReadImage may read (.png, .jpg, .jpeg, .bmp, .ppm,
/// .pgm, in capitals too). What the file holds is not looked at.
[[nodiscard]] bool IsNamedLikeAPicture(const std::filesystem::path& path);

/// A file name that stands in the file `origin`, below `folder`, with / between folders on return.
/// Backslashes are taken for separators, as Windows writes them. Throws Error naming `origin` when
/// it is empty, absolute, climbs out of the folder by "..", or no such file is there.
[[nodiscard]] std::filesystem::path FindNamedFile(const std::filesystem::path& folder,
                                                  std::string name,
                                                  const std::filesystem::path& origin);

/// The first folder of a path, which by convention names the class; "object" if it has none.
[[nodiscard]] std::string ClassOfPath(const std::filesystem::path& relative);

}  // namespace handcraft::datasets
