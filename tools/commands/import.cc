// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>

#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/core/utf8.h"
#include "lib/model_io/libsvm_text.h"
#include "lib/model_io/model_writer.h"
#include "tools/commands.h"
#include "tools/common_options.h"

namespace handcraft::tools {
namespace {

struct ImportOptions {
  std::string file;
  std::string from;
  std::string out;
  std::string name = "svm";
  model_io::SvmNames names = {};  // what the file does not hold
};

void RunImport(const ImportOptions& options, const Console& console) {
  RequireWritable(options.out);
  const std::array inputs = {std::filesystem::path(options.file)};
  RequireNotAnInput(options.out, inputs);
  model_io::NamedSvm svm = model_io::FromLibsvmText(ReadTextFile(options.file), options.file);
  model_io::GiveNames(options.names, svm);
  WriteFileAtomically(
      options.out,
      model_io::Serialise(model_io::MakeSvmModel(svm.model,
                                                 svm.names,
                                                 {.name = options.name,
                                                  .task = "svm",
                                                  .algorithm = "libsvm",
                                                  .parent = Sha256Hex(ReadFile(options.file))})));
  console.out << "Model of " << svm.model.num_classes << " classes written to "
              << OnOneLine(options.out) << '\n';
}

}  // namespace

void AddImport(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* command = parent.add_subcommand("import", "Take over a model of another program");
  command->add_option("FILE", options->file, "The other program's model")->required();
  command->add_option("--from", options->from, "libsvm: what svm-train writes")
      ->check(CLI::IsMember({"libsvm"}))
      ->type_name("FORMAT")
      ->required();
  command->add_option("--out", options->out, "Model file to write")->type_name("FILE")->required();
  command
      ->add_option("--columns",
                   options->names.columns,
                   "Names of the table's columns but the label, in their order [1,2,…]")
      ->delimiter(',')
      ->type_name("NAME,…");
  command
      ->add_option("--classes",
                   options->names.classes,
                   "Names of the classes, in the order of the line 'label' [its numbers]")
      ->delimiter(',')
      ->type_name("NAME,…");
  command->add_option("--label", options->names.label_column, "Name of the label column [label]")
      ->type_name("COLUMN");
  command->add_option("--name", options->name, "Name of the model, stored in it")
      ->capture_default_str();
  SetExample(*command,
             "handcraft import tests/data/trainers/svm_classes_rbf.model --from libsvm "
             "--out classes.safetensors");
  command->callback([options, &console] { RunImport(*options, console); });
}

}  // namespace handcraft::tools
