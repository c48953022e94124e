// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/logistic_options.h"

#include <map>
#include <string>

#include "tools/number_option.h"

namespace handcraft::tools {
namespace {

const std::map<std::string, logistic::HessianPrecision>& PrecisionNames() {
  static const std::map<std::string, logistic::HessianPrecision> names = {
      {"auto", logistic::HessianPrecision::kAuto},
      {"single", logistic::HessianPrecision::kSingle},
      {"double", logistic::HessianPrecision::kDouble}};
  return names;
}

}  // namespace

void AddLogisticOptions(CLI::App& command, logistic::Options& options) {
  AddNumber(command,
            "--ridge",
            options,
            &logistic::Options::ridge,
            "Penalty λ in deviance/2 + λ/2·‖w‖², on standardised features")
      ->group(kLogisticGroup);
  AddNumber(command,
            "--max-iterations",
            options,
            &logistic::Options::max_iterations,
            "Newton steps at most")
      ->group(kLogisticGroup);
  AddNumber(command,
            "--gradient-tolerance",
            options,
            &logistic::Options::gradient_tolerance,
            "Converged when the gradient's largest entry per sample is below")
      ->group(kLogisticGroup);
  AddNumber(command,
            "--warm-start",
            options,
            &logistic::Options::warm_start_share,
            "Share of the samples that the first Hessians are estimated from; 0: all")
      ->group(kLogisticGroup);
  command
      .add_option_function<std::string>(
          "--hessian",
          [&options](const std::string& name) {
            options.hessian_precision = PrecisionNames().at(name);
          },
          "Arithmetic of the Hessian: auto, single or double; the optimum is the same")
      ->check(CLI::IsMember({"auto", "single", "double"}))
      ->type_name("NAME")
      ->default_str("auto")
      ->group(kLogisticGroup);
}

}  // namespace handcraft::tools
