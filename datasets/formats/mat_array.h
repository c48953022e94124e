// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace handcraft::datasets {

/// An array of numbers as MATLAB keeps it: the first subscript changes fastest.
struct MatArray {
  std::vector<std::size_t> dimensions;  ///< two or more: rows, columns, …
  std::vector<double> values;           ///< as many as the product of the dimensions
};

/// Reads the array `name` of a MAT-file of level 5 (MATLAB's `save`, with -v6 or -v7, compressed or
/// not; either byte order): real, full, of any numeric class or logical. Other variables of the
/// file are passed over. Throws Error with the byte: another kind of file (level 4, or -v7.3, which
/// is HDF5), truncated, damaged, a size that does not fit, no array of that name (the ones there
/// are listed), a complex or sparse one, text, cells or structures, more than 2²⁴ values. Source:
/// The MathWorks, "MAT-File Format" (level 5).
[[nodiscard]] MatArray ReadMatArray(const std::filesystem::path& path, const std::string& name);

}  // namespace handcraft::datasets
