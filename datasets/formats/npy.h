// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace handcraft::datasets {

/// A matrix of numbers, row-major.
struct NpyMatrix {
  std::vector<double> values;  ///< rows × columns
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// Whether a file begins as NPY files do; false when it cannot be read.
[[nodiscard]] bool IsNpy(const std::filesystem::path& path);

/// Reads an NPY file of format 1, 2 or 3: rank 2, float32, float64, integers or booleans, either
/// byte order, C or Fortran order. Throws Error with the byte: another kind of array, a length that
/// does not fit the shape, NaN, infinity.
/// Source: numpy.lib.format, "NPY format".
[[nodiscard]] NpyMatrix ReadNpy(const std::filesystem::path& path);

/// Writes a row-major matrix as NPY version 1.0 (little-endian), atomically.
void WriteNpy(const std::filesystem::path& path,
              const float* values,
              std::size_t rows,
              std::size_t columns);
void WriteNpy(const std::filesystem::path& path,
              const double* values,
              std::size_t rows,
              std::size_t columns);

}  // namespace handcraft::datasets
