// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/evaluation/loaded_model.h"
#include "lib/core/error.h"
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

// Of what a robot would load, a machine of rows alone.
void RequireTableMachine(const std::string& path) {
  const experiments::LoadedModel model = experiments::LoadModel(path);
  const hc_kind kind = hc_model_kind(model.get());
  if (kind == HC_KIND_SVM) return;
  const bool is_of_clouds = kind == HC_KIND_OBJECT_CLASS;
  throw Error({.path = path,
               .reason = fmt::format("a model of kind {}; libsvm's text holds models of kind svm",
                                     experiments::KindName(kind)),
               .remedy = is_of_clouds ? "libsvm cannot describe a cloud: keep to 'handcraft "
                                        "predict', or train a machine on a table of your own"
                                      : "give a model made by 'handcraft train svm'"});
}

template <class Work>
auto NamingFile(const std::string& path, Work&& work) {
  try {
    return work();
  } catch (const Error& error) {
    Error::Details details = error.details();
    if (details.path.empty()) details.path = path;
    throw Error(std::move(details));
  }
}

// The text has numbers alone: 'import' takes the names again.
void WarnOfWhatIsLost(const model_io::NamedSvm& svm, const Console& console) {
  const model_io::SvmNames& names = svm.names;
  const auto quoted = [](const std::vector<std::string>& list) {
    return fmt::format("'{}'", fmt::join(list, ","));
  };
  console.Warn(fmt::format(
      "libsvm's text holds no names: columns are 1 to {}, classes are numbers or 0, 1, … in their "
      "order; to read it with names again, give 'handcraft import' --columns {} --classes {} "
      "--label '{}'",
      names.columns.size(),
      quoted(names.columns),
      quoted(names.classes),
      names.label_column));
  if (!svm.model.rejection_threshold) return;
  console.Warn(
      fmt::format("libsvm's text holds no threshold: what has a margin below {:.4g} is "
                  "taken for one of the classes there",
                  *svm.model.rejection_threshold));
}

void RunExport(const ExportOptions& options, const Console& console) {
  RequireWritable(options.out);
  const std::array inputs = {std::filesystem::path(options.model)};
  RequireNotAnInput(options.out, inputs);
  RequireTableMachine(options.model);
  const model_io::ModelFile file = model_io::Parse(ReadFile(options.model), options.model);
  const model_io::NamedSvm svm{.model = model_io::ReadSvmModel(file),
                               .names = model_io::ReadSvmNames(file)};
  WriteFileAtomically(options.out,
                      NamingFile(options.model, [&svm] { return model_io::ToLibsvmText(svm); }));
  WarnOfWhatIsLost(svm, console);
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
