// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/table_command.h"

#include "tools/common_options.h"

namespace handcraft::tools {

CLI::App* AddTableCommand(CLI::App& parent,
                          const std::string& name,
                          const std::string& description,
                          TableArguments& arguments) {
  CLI::App* command = parent.add_subcommand(name, description);
  arguments.name = name;
  command->add_option("TABLE", arguments.table, "CSV with a header line, NPY, or libsvm's text")
      ->required();
  command
      ->add_option("--label",
                   arguments.label,
                   "Column of the label; NPY: its number, -1 the last; libsvm: not needed")
      ->type_name("COLUMN");
  CLI::Option* out =
      command->add_option("--out", arguments.out, "Model file to write")->type_name("FILE");
  command->add_option("--name", arguments.name, "Name of the model, stored in it")
      ->needs(out)
      ->capture_default_str();
  AddJsonFlag(*command, arguments.json);
  return command;
}

}  // namespace handcraft::tools
