// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/npy_pictures.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "datasets/formats/npy_header.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

constexpr std::size_t kLargestSide_px = 65535;

void RequirePictures(const NpyFile& file, const NpyHeader& header) {
  if (header.shape.size() != 3) {
    file.Fail(kNpyMagic.size(),
              "an array of rank " + std::to_string(header.shape.size()) +
                  "; rank 3 is due: picture, row, column");
  }
  const bool is_bytes = header.type == "|u1" || header.type == "<u1" || header.type == ">u1";
  if (!is_bytes || header.fortran_order) {
    file.Fail(kNpyMagic.size(),
              "elements of type '" + header.type + "'" +
                  (header.fortran_order ? " in Fortran order" : "") + "; bytes in C order are due",
              "convert them, for example by numpy.ascontiguousarray(x, dtype='uint8')");
  }
  RequireNpyLength(file, header, 1);
  const auto is_a_side = [](std::size_t side) { return side >= 1 && side <= kLargestSide_px; };
  if (header.shape[0] == 0 || !is_a_side(header.shape[1]) || !is_a_side(header.shape[2])) {
    file.Fail(kNpyMagic.size(),
              "an array of " + ShapeText(header.shape) +
                  "; one or more pictures of 1 to 65535 pixels a side are due");
  }
}

}  // namespace

std::vector<Image> ReadNpyPictures(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = ReadFile(path);
  const NpyFile file{path, bytes};
  const NpyHeader header = ReadNpyHeader(file);
  RequirePictures(file, header);
  const std::size_t num_rows = header.shape[1];
  const std::size_t num_columns = header.shape[2];
  std::vector<Image> pictures;
  const std::uint8_t* from = bytes.data() + header.data_begin;
  for (std::size_t i = 0; i < header.shape[0]; ++i) {
    Image& picture =
        pictures.emplace_back(static_cast<int>(num_columns), static_cast<int>(num_rows));
    for (int v = 0; v < picture.height(); ++v, from += num_columns)
      std::copy_n(from, num_columns, picture.Row(v));
  }
  return pictures;
}

}  // namespace handcraft::datasets
