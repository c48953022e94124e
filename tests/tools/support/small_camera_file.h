// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "lib/core/file.h"

namespace handcraft::tools::testing {

/// Writes a file for --camera into the folder and returns its path: the usual camera at a quarter
/// of its resolution, for speed, with other keys besides if there are any.
inline std::string CameraFile(const std::filesystem::path& folder, std::string_view more = "") {
  const std::filesystem::path path = folder / "camera.toml";
  WriteFileAtomically(path,
                      "[camera]\nwidth_px = 160\nheight_px = 120\nfocal_px = 131.25\n"
                      "centre_u_px = 79.5\ncentre_v_px = 59.5\n" +
                          std::string(more));
  return path.string();
}

}  // namespace handcraft::tools::testing
