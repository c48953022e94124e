// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <CLI/App.hpp>

namespace handcraft::tools {

/// The arguments of every command that trains on a table.
struct TableArguments {
  std::string table = {};
  std::string label = {};  ///< column of the label; empty for a file that needs no name of it
  std::string out = {};    ///< model file; empty: none is written
  std::string name = {};   ///< stored in the model
  bool json = false;
};

/// Adds `train NAME TABLE --label COLUMN [--out FILE [--name NAME]] [--json]`; the model's name is
/// the command's unless --name says otherwise.
[[nodiscard]] CLI::App* AddTableCommand(CLI::App& parent,
                                        const std::string& name,
                                        const std::string& description,
                                        TableArguments& arguments);

}  // namespace handcraft::tools
