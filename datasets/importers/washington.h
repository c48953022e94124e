// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/importers/image_set_import.h"

namespace handcraft::datasets {

/// Lists the views of the Washington RGB-D object data: for each CLASS_N_VIDEO_FRAME, at any depth,
/// _crop.png (the picture), _maskcrop.png (nonzero: the object), _depthcrop.png (16 bits [mm], 0:
/// nothing measured), _loc.txt ("x,y" of the first pixel in the whole picture, from 1) and, if
/// there is one, _pose.txt (the turn [deg]). CLASS_N is the instance. What is left out, for want of
/// a picture or a mask, and views without a cloud stand in the notes. Clouds have the camera at the
/// origin, levelled by the height it was mounted at: it looks down by 30°, 45° or 60° in the videos
/// 1, 2 and 4; in others its axis is taken for level. Throws Error when there is no such view, or a
/// file is not as said. Source: K. Lai, L. Bo, X. Ren, D. Fox, "A large-scale hierarchical
/// multi-view RGB-D object dataset", ICRA 2011, and the data's depthToCloud.m for the camera: f =
/// 570.3 px, centre (320, 240).
[[nodiscard]] SourceSet ListWashington(const std::filesystem::path& source);

}  // namespace handcraft::datasets
