// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "lib/model_io/model_writer.h"
#include "lib/model_io/provenance.h"
#include "lib/model_io/svm_model.h"

namespace handcraft::model_io {

/// What the rows and classes of a support vector machine are called.
struct SvmNames {
  std::vector<std::string> columns;
  std::vector<std::string> classes;
  std::string label_column;
};

/// Kind "svm", docs/model_format.md § 9. Self-test rows are the mean row and two support vectors.
/// Deterministic. Throws std::logic_error when sizes do not fit, Error(kBadInput) for a name that
/// is empty, has a line break or is not UTF-8.
[[nodiscard]] ModelFile MakeSvmModel(const SvmModel& model,
                                     const SvmNames& names,
                                     const Provenance& provenance);

/// The way back from a file that the runtime loads, to add a class or to export it. Throws
/// Error(kBadInput) for another kind of model, and when a tensor is missing or of another type.
[[nodiscard]] SvmModel ReadSvmModel(const ModelFile& file);
[[nodiscard]] SvmNames ReadSvmNames(const ModelFile& file);

}  // namespace handcraft::model_io
