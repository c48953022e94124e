// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "lib/features/cloud_descriptor.h"
#include "lib/features/object_cloud.h"
#include "lib/model_io/model_writer.h"
#include "lib/model_io/provenance.h"
#include "lib/model_io/svm_model.h"

namespace handcraft::model_io {

/// A machine that tells objects apart by their clouds.
struct ObjectClassModel {
  features::CloudDescriptor descriptor = {};
  /// Which points are left out before: perception::CloudOutlierOptions.step; 0: none. Not looked at
  /// by the runtime, which is given the object's points.
  double outlier_step = 1.5;
  SvmModel svm = {};
  std::vector<std::string> classes = {};
};

/// Kind "object_class", docs/model_format.md § 10. The self-test is `cloud`, an object's, with so
/// many rows and columns left out that it has at most 48 of each. Deterministic. Throws
/// std::logic_error when sizes do not fit, Error(kBadInput) for a bad class name and for a cloud
/// with too few points.
[[nodiscard]] ModelFile MakeObjectClassModel(const ObjectClassModel& model,
                                             const features::ObjectCloud& cloud,
                                             const Provenance& provenance);

/// The way back from a file that the runtime loads, to add a class. Throws Error(kBadInput) for
/// another kind of model, and when a tensor is missing or of another type.
[[nodiscard]] ObjectClassModel ReadObjectClassModel(const ModelFile& file);

}  // namespace handcraft::model_io
