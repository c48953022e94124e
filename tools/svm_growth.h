// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "datasets/formats/table.h"
#include "lib/model_io/svm_models.h"
#include "trainers/svm/svm.h"

namespace handcraft::tools {

/// A class to add to a model that is there.
struct SvmGrowth {
  std::string new_class = {};  ///< empty: none
  std::string model = {};      ///< the model file
};

/// --add-class NAME --to MODEL, `target` saying what becomes of it. Neither goes with the options
/// of `command` that the model answers: descriptor, kernel, scheme, normaliser and what chooses
/// them.
void AddSvmGrowthOptions(CLI::App& command, const std::string& target, SvmGrowth& growth);

/// The model that a class is added to.
struct GrowingSvm {
  model_io::SvmModel model;
  model_io::SvmNames names;  ///< the new class is the last
  std::string sha256;        ///< of its file

  /// `options` with kernel, scheme and normaliser of the model.
  [[nodiscard]] svm::Options OptionsOf(svm::Options options) const;
};

/// Reads the model as a robot would load it. Throws Error for a file that is none, another kind of
/// model, and Error(kUsage) when it has the class already.
[[nodiscard]] GrowingSvm ReadGrowingSvm(const SvmGrowth& growth);

/// The labels of samples as numbers of the classes `names`, of which each must occur, so that the
/// new pairs see every class. Throws Error(kBadInput) naming `path`, a label that is none of them,
/// or a class without samples.
[[nodiscard]] datasets::ClassLabels LabelsAmong(const std::vector<std::string>& names,
                                                const std::vector<std::string>& labels,
                                                const std::filesystem::path& path);

}  // namespace handcraft::tools
