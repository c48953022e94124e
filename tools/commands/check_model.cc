// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <memory>
#include <ostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/evaluation/cloud_evaluation.h"
#include "experiments/evaluation/loaded_model.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/core/utf8.h"
#include "tools/commands.h"
#include "tools/common_options.h"

namespace handcraft::tools {
namespace {

struct CheckModelOptions {
  std::string model;
  bool json = false;
};

void RunCheckModel(const CheckModelOptions& options, const Console& console) {
  const experiments::LoadedModel model = experiments::LoadModel(options.model);
  const std::string_view kind = experiments::KindName(hc_model_kind(model.get()));
  const std::string sha256 = Sha256Hex(ReadFile(options.model));
  const double threshold = experiments::RejectionThreshold(model.get());
  if (options.json) {
    nlohmann::ordered_json json = {
        {"model", options.model}, {"ok", true}, {"kind", kind}, {"sha256", sha256}};
    if (std::isfinite(threshold)) json["rejection_threshold"] = threshold;
    console.Print(json);
    return;
  }
  console.out << "OK: " << OnOneLine(options.model) << " is a " << kind
              << " model; checksum, contents and self-test are right\nsha256 " << sha256 << '\n';
  if (std::isfinite(threshold)) {
    console.out << fmt::format("none of its classes: what has a margin below {:.4g}\n", threshold);
  }
}

}  // namespace

void AddCheckModel(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<CheckModelOptions>();
  CLI::App* command =
      parent.add_subcommand("check-model", "Load a model as the robot does: checksum, self-test");
  command->add_option("MODEL", options->model, "Model file")->required();
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft check-model out/demo/grasp_points.safetensors");
  command->callback([options, &console] { RunCheckModel(*options, console); });
}

}  // namespace handcraft::tools
