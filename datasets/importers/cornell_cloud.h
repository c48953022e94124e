// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/formats/organised_cloud.h"

namespace handcraft::datasets {

/// Reads a cloud of the Cornell data, `pcdNNNN.txt`, into an organised one: PCD text of the fields
/// x y z rgb index, a line a point, in millimetres; index is row · width + column of the picture's
/// pixel. Pixels without a line are NaN. The frame is the data's own, which is kept (x forward,
/// y left, z up), the camera's pose is not in the file: identity. Throws Error with the line: other
/// fields, text that is no number, a pixel outside the picture, one that is there twice, fewer or
/// more points than the header says.
/// Source: the description that comes with the data of Y. Jiang, S. Moseson, A. Saxena, "Efficient
/// grasping from RGBD images", ICRA 2011.
[[nodiscard]] OrganisedCloud ReadCornellCloud(const std::filesystem::path& path,
                                              int width,
                                              int height);

}  // namespace handcraft::datasets
