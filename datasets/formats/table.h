// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "datasets/formats/npy.h"

namespace handcraft::datasets {

/// A table of numbers with named columns and one label a row.
struct Table {
  std::vector<std::string> columns;  ///< feature names, label column left out
  std::vector<double> values;        ///< row-major num_rows × columns.size()
  std::size_t num_rows = 0;
  std::string label_column;
  std::vector<std::string> labels;  ///< as text, one a row; empty when there is no label column
};

/// Reads libsvm's text (.libsvm, .svm: ReadLibsvmTable; the label column has no name, or "label"),
/// CSV (header line, RFC 4180 quotes, '.' decimals) or NPY (rank 2, f4/f8/integers, C or
/// Fortran order; columns are named "0", "1", …; `label_column` is then a number, −1 the last one).
/// An empty label_column reads features alone. Throws Error with line (CSV) or byte (NPY): ragged
/// rows, text where a number is due, NaN and infinities, a label column that does not exist (the
/// ones that do are listed). With `wanted`, columns of a CSV file that are neither among these
/// names nor the label are passed over, whatever they hold; those that are missing are not missed
/// here.
[[nodiscard]] Table ReadTable(const std::filesystem::path& path,
                              const std::string& label_column,
                              const std::vector<std::string>& wanted = {});

/// The two labels of a table, negative first: numbers in numeric order, words in alphabetical
/// order. Throws Error(kBadInput) unless there are exactly two.
struct BinaryLabels {
  std::string negative;
  std::string positive;
  std::vector<std::uint8_t> values;  ///< 1 where positive
};
[[nodiscard]] BinaryLabels ToBinaryLabels(const Table& table, const std::filesystem::path& path);

/// The labels of a table as numbers of classes, which are in the order of their first rows
/// (libsvm's order, which decides between equal votes). Throws Error(kBadInput) unless there are
/// two or more.
struct ClassLabels {
  std::vector<std::string> names;
  std::vector<std::uint32_t> values;  ///< one a row
};
[[nodiscard]] ClassLabels ToClassLabels(const Table& table, const std::filesystem::path& path);

}  // namespace handcraft::datasets
