// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>

#include "experiments/evaluation/loaded_model.h"
#include "lib/core/file.h"
#include "lib/core/utf8.h"
#include "lib/model_io/libsvm_text.h"
#include "lib/model_io/model_writer.h"
#include "tools/commands.h"
#include "tools/common_options.h"

namespace handcraft::tools {
namespace {

struct ExportOptions {
  std::string model;
  std::string to;
  std::string out;
};

void RunExport(const ExportOptions& options, const Console& console) {
  RequireWritable(options.out);
  const std::array inputs = {std::filesystem::path(options.model)};
  RequireNotAnInput(options.out, inputs);
  static_cast<void>(experiments::LoadModel(options.model));  // only what a robot would load
  const model_io::ModelFile file = model_io::Parse(ReadFile(options.model), options.model);
  WriteFileAtomically(options.out,
                      model_io::ToLibsvmText({.model = model_io::ReadSvmModel(file),
                                              .names = model_io::ReadSvmNames(file)}));
  console.out << "libsvm's text of " << OnOneLine(options.model) << " written to "
              << OnOneLine(options.out) << '\n';
}

}  // namespace

void AddExport(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = parent.add_subcommand("export", "Write a model for other programs");
  command->add_option("MODEL", options->model, "Model file")->required();
  command->add_option("--to", options->to, "libsvm: the text of a support vector machine")
      ->check(CLI::IsMember({"libsvm"}))
      ->type_name("FORMAT")
      ->required();
  command->add_option("--out", options->out, "File to write")->type_name("FILE")->required();
  SetExample(*command, "handcraft export classes.safetensors --to libsvm --out classes.model");
  command->callback([options, &console] { RunExport(*options, console); });
}

}  // namespace handcraft::tools
