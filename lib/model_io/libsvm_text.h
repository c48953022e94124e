// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

#include "lib/model_io/svm_models.h"

namespace handcraft::model_io {

/// A support vector machine with the names of its columns and classes.
struct NamedSvm {
  SvmModel model = {};
  SvmNames names = {};
};

/// The model as libsvm's svm-predict reads it: decision values are those of the runtime but for
/// rounding. Classes whose names are not all whole numbers become 0, 1, … in their order. The
/// rejection threshold is left out. Throws Error(kUsage) for a model that libsvm's text cannot
/// hold: one against all of more than two classes, or with a normaliser.
[[nodiscard]] std::string ToLibsvmText(const NamedSvm& svm);

/// The way back, from a model of svm-train: c_svc or nu_svc with a linear, polynomial or rbf
/// kernel. Columns are named "1", "2", …, the label column "label"; probability estimates are
/// passed over. Throws Error(kBadInput) with `path` and the line of what is missing, unknown or no
/// number.
[[nodiscard]] NamedSvm FromLibsvmText(std::string_view text, const std::string& path);

/// Gives a machine read from libsvm's text the names that the text cannot hold; what is empty stays
/// as it was. There may be more columns than the machine has features: libsvm leaves out zeros, and
/// the last ones with them. Throws Error(kUsage) for fewer, and for another number of classes.
void GiveNames(const SvmNames& names, NamedSvm& svm);

}  // namespace handcraft::model_io
