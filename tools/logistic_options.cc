// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/logistic_options.h"

#include <map>
#include <string>

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
  const std::string group = "Logistic regression";
  command
      .add_option(
          "--ridge", options.ridge, "Penalty λ in deviance/2 + λ/2·‖w‖², on standardised features")
      ->capture_default_str()
      ->group(group);
  command.add_option("--max-iterations", options.max_iterations, "Newton steps at most")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--gradient-tolerance",
                  options.gradient_tolerance,
                  "Converged when the gradient's largest entry per sample is below")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--warm-start",
                  options.warm_start_share,
                  "Share of the samples to optimise on first; 0: none")
      ->capture_default_str()
      ->group(group);
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
      ->group(group);
}

}  // namespace handcraft::tools
