// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "lib/features/cloud_descriptor.h"
#include "lib/runtime/model_header.h"
#include "lib/runtime/svm_model.h"

namespace handcraft::runtime {

/// Which class an object's cloud belongs to (docs/model_format.md § 10): a descriptor and the
/// machine that reads it. Immutable: any number of threads may use one, each with scratch memory of
/// its own.
struct ObjectClassModel {
  features::CloudDescriptor descriptor;
  SvmModel svm;

  /// Bytes of scratch memory, aligned to 64, that Predict works in; the machine's come first.
  [[nodiscard]] std::size_t WorkspaceBytes() const noexcept;

  /// The class of an object; nothing when fewer than features::kMinObjectPoints of its points were
  /// measured. Does not allocate.
  [[nodiscard]] std::optional<SvmModel::Prediction> Predict(
      const features::ObjectCloud& cloud, std::span<std::byte> workspace) const noexcept;
};

/// Builds a model of kind "object_class", version 1, and runs the stored self-test. Errors:
/// HC_ERROR_CONTENT, HC_ERROR_SELF_TEST. Allocates (std::bad_alloc).
[[nodiscard]] Result<ObjectClassModel> LoadObjectClassModel(const ParsedModel& parsed);

}  // namespace handcraft::runtime
