// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "lib/runtime/content_reader.h"
#include "lib/runtime/model_header.h"
#include "lib/runtime/svm_model.h"

namespace handcraft::runtime {

/// Takes the tensors of docs/model_format.md § 9 but for column_names and the self-test out of a
/// parsed file, part by part.
class SvmLoader {
 public:
  /// Both outlive the loader.
  SvmLoader(ContentReader& reader, SvmModel& model) noexcept : reader_(reader), model_(model) {}

  /// Whether all went well; the reader has the error.
  bool Read();

 private:
  bool ReadKernel();
  bool ReadNames();
  bool ReadSupportVectors();
  template <class T>
  bool ReadRows();
  bool ReadMachines();
  bool ReadThreshold();

  ContentReader& reader_;
  SvmModel& model_;
};

/// Refuses the model when a number of an I32 tensor is outside [low, high].
bool RequireWithin(ContentReader& reader,
                   const char* tensor,
                   std::int32_t value,
                   std::int32_t low,
                   std::size_t high,
                   std::size_t entry = 0);

/// § 9.2: reads the tensor selftest.tolerance, whose limits are checked.
bool ReadSelfTestTolerance(ContentReader& reader, double& tolerance);

/// § 9.2: compares the values of the last prediction made in the workspace with those stored; row
/// `row` is named in the error.
[[nodiscard]] std::optional<ModelError> CheckSelfTestRow(const SvmModel& model,
                                                         std::span<const double> expected,
                                                         double tolerance,
                                                         std::size_t row,
                                                         std::span<std::byte> workspace);

/// Builds a model of kind "svm", version 1 (docs/model_format.md § 9), and runs the stored
/// self-test. Errors: HC_ERROR_CONTENT, HC_ERROR_SELF_TEST. Allocates (std::bad_alloc).
[[nodiscard]] Result<SvmModel> LoadSvmModel(const ParsedModel& parsed);

}  // namespace handcraft::runtime
