// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "datasets/formats/mask_picture.h"
#include "lib/perception/cloud_view.h"

namespace handcraft::datasets {

/// One point for each pixel of a picture, in the base frame [m]; NaN where nothing was measured.
struct OrganisedCloud {
  int width = 0;                             ///< [px]
  int height = 0;                            ///< [px]; 1 for a cloud without a picture
  std::vector<Eigen::Vector3f> points = {};  ///< row-major: pixel (u, v) is number v · width + u
  /// Pose of the camera that measured it; the optical frame has z forward, x right, y down.
  Eigen::Isometry3f base_from_camera = Eigen::Isometry3f::Identity();

  [[nodiscard]] const Eigen::Vector3f& At(int u, int v) const {
    return points[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(u)];
  }
  /// The points as the perception code takes them; the cloud must outlive the view.
  [[nodiscard]] perception::CloudView View() const { return {points, width, height}; }
};

using perception::IsMeasured;

/// Reads a PCD file (docs/datasets.md) as it is: version 0.7; ascii, binary or binary_compressed;
/// x, y and z as four-byte floats among other fields, which are skipped. A point with a coordinate
/// that is NaN or infinite becomes NaN in all three. Throws Error with the line or byte: a header
/// that ReadPcdHeader refuses, no points, fewer or more data than the points take, text that is no
/// number, a damaged compressed stream. Up to a memory page of bytes behind the data is passed
/// over: older versions of the Point Cloud Library leave it there. Takes no more memory than the
/// length of the file can account for.
[[nodiscard]] OrganisedCloud ReadPcd(const std::filesystem::path& path);

/// Reads a PCD file as the cloud of a picture, whatever the file's name: organised, of the
/// picture's size, or indexed: with a field `index`, row · width + column of the pixel that a point
/// belongs to, which holds for an organised cloud too. Pixels that no point names are NaN: all, of
/// a cloud without points. Coordinates are multiplied by `unit_m`; nothing: the unit of the header
/// (PcdHeader.unit_m). Throws Error with the path as ReadPcd does, and: another size, an
/// unorganised cloud without `index`, an index that is no pixel of the picture, or twice there.
[[nodiscard]] OrganisedCloud ReadCloudOfPicture(const std::filesystem::path& path,
                                                const PixelSize& picture_size,
                                                std::optional<float> unit_m = std::nullopt);

/// Writes x, y and z as a binary PCD file, atomically; VIEWPOINT is the camera's pose. Same cloud,
/// same bytes. Throws Error when it cannot.
void WritePcd(const std::filesystem::path& path, const OrganisedCloud& cloud);

}  // namespace handcraft::datasets
