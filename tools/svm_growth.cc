// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/svm_growth.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/evaluation/loaded_model.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/model_io/model_writer.h"
#include "tools/svm_options.h"

namespace handcraft::tools {

void AddSvmGrowthOptions(CLI::App& command, const std::string& target, SvmGrowth& growth) {
  CLI::Option* add = command
                         .add_option("--add-class",
                                     growth.new_class,
                                     "Train this class's pairs alone; the others stay as they are")
                         ->type_name("NAME")
                         ->group(kSvmGroup);
  CLI::Option* to =
      command.add_option("--to", growth.model, target)->type_name("MODEL")->group(kSvmGroup);
  add->needs(to);
  to->needs(add);
  for (const char* answered : {"--kernel",
                               "--degree",
                               "--gamma",
                               "--coef0",
                               "--scheme",
                               "--standardize",
                               "--search",
                               "--descriptor",
                               "--grid-size",
                               "--box",
                               "--scaling",
                               "--frame",
                               "--outlier-step"}) {
    if (CLI::Option* const option = command.get_option_no_throw(answered)) add->excludes(option);
  }
}

svm::Options GrowingSvm::OptionsOf(svm::Options options) const {
  options.kernel = model.similarity.type;
  options.degree = model.similarity.degree;
  options.gamma = model.similarity.gamma;
  options.coef0 = model.similarity.coef0;
  options.scheme = model.scheme;
  const auto is = [](double expected) { return [=](double x) { return x == expected; }; };
  options.standardize =
      !(std::all_of(model.feature_mean.begin(), model.feature_mean.end(), is(0.0)) &&
        std::all_of(model.feature_scale.begin(), model.feature_scale.end(), is(1.0)));
  return options;
}

GrowingSvm ReadGrowingSvm(const SvmGrowth& growth) {
  static_cast<void>(experiments::LoadModel(growth.model));  // only what a robot would load
  const std::vector<std::uint8_t> bytes = ReadFile(growth.model);
  const model_io::ModelFile file = model_io::Parse(bytes, growth.model);
  GrowingSvm growing{.model = model_io::ReadSvmModel(file),
                     .names = model_io::ReadSvmNames(file),
                     .sha256 = Sha256Hex(bytes)};
  std::vector<std::string>& classes = growing.names.classes;
  if (std::find(classes.begin(), classes.end(), growth.new_class) != classes.end()) {
    throw Error({.kind = Error::Kind::kUsage,
                 .path = growth.model,
                 .reason = fmt::format("the model has the class '{}' already", growth.new_class),
                 .remedy = "train it again with all classes to change one"});
  }
  classes.push_back(growth.new_class);
  return growing;
}

datasets::ClassLabels LabelsAmong(const std::vector<std::string>& names,
                                  const std::vector<std::string>& labels,
                                  const std::filesystem::path& path) {
  datasets::ClassLabels among{.names = names, .values = {}};
  std::vector<bool> occurs(names.size());
  among.values.reserve(labels.size());
  for (const std::string& label : labels) {
    const auto found = std::find(names.begin(), names.end(), label);
    if (found == names.end()) {
      throw Error({.path = path.string(),
                   .reason = fmt::format(
                       "'{}' is not one of the classes {}", label, fmt::join(names, ", ")),
                   .remedy = "add one class at a time"});
    }
    const auto number = static_cast<std::uint32_t>(found - names.begin());
    occurs[number] = true;
    among.values.push_back(number);
  }
  const auto missing = std::find(occurs.begin(), occurs.end(), false);
  if (missing == occurs.end()) return among;
  throw Error({.path = path.string(),
               .reason = fmt::format("no samples of the class '{}'",
                                     names[static_cast<std::size_t>(missing - occurs.begin())]),
               .remedy = "give samples of all classes: the new one is told from each of them"});
}

}  // namespace handcraft::tools
