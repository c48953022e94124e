// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include <Eigen/Geometry>

namespace handcraft::datasets {

enum class PcdData { kAscii, kBinary, kBinaryCompressed };

/// What the header of a PCD file says, as far as points are concerned.
struct PcdHeader {
  /// Where a coordinate stands in the record of a point.
  struct Coordinate {
    std::size_t offset_bytes = 0;
    std::size_t value = 0;  ///< number of values before it
  };
  /// Where the number of a point's pixel stands, in a record whose points are in no order.
  struct PixelIndex : Coordinate {
    char type = 'U';  ///< of four bytes: U and I whole numbers, F a float
  };
  std::array<Coordinate, 3> coordinates;  ///< of x, y and z
  std::optional<PixelIndex> index = {};   ///< a field `index` of four bytes, if there is one
  std::size_t point_bytes = 0;            ///< of a point's record
  std::size_t point_values = 0;           ///< in a point's record
  int width = 0;
  int height = 0;
  Eigen::Isometry3f viewpoint = Eigen::Isometry3f::Identity();
  float unit_m = 1.0F;  ///< of the coordinates; 0.001 in the files of the Cornell data
  PcdData data = PcdData::kAscii;
  std::size_t data_begin = 0;  ///< byte
  std::size_t data_line = 0;   ///< line of the first point, if it is text

  [[nodiscard]] std::size_t num_points() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Reads the header of a PCD file, version 0.7: lines that begin with VERSION, FIELDS, SIZE, TYPE,
/// COUNT, WIDTH, HEIGHT, VIEWPOINT, POINTS and DATA, each at most once, DATA last; only COUNT and
/// VIEWPOINT may be missing; lines that begin with # are skipped; lines end with LF or CRLF. x, y
/// and z must be there, floats of four bytes, one each. No points to 2²⁸, at most 64 fields and
/// 65536 bytes a point. The files of the Cornell data, whose fields are x y z rgb index, have no
/// line VERSION: it may be missing there, and then the unit is the millimetre. Throws Error with
/// the line and what was found. Takes no memory for points. Source: "The PCD (Point Cloud Data)
/// file format", Point Cloud Library; the description that comes with the data of Y. Jiang, S.
/// Moseson, A. Saxena, "Efficient grasping from RGBD images", 2011.
[[nodiscard]] PcdHeader ReadPcdHeader(const std::filesystem::path& path,
                                      std::span<const std::uint8_t> bytes);

}  // namespace handcraft::datasets
