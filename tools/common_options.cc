// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/common_options.h"

#include <unistd.h>

#include <ostream>
#include <string_view>

#include "datasets/formats/listing_rules.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/parallel.h"
#include "tools/number_option.h"

namespace handcraft::tools {

std::vector<std::string> GivenOptions(const CLI::App& command, const std::string& group) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group() == group && option->count() > 0) names.push_back(option->get_name());
  }
  return names;
}

void RefusePictureOptions(const std::vector<std::string>& given) {
  if (given.empty()) return;
  throw Error({.kind = Error::Kind::kUsage,
               .reason = given.front() + " is about pictures: it needs a grasp-point model"});
}

void AddJsonFlag(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "Print the result as JSON");
}

void AddSeedOption(CLI::App& command, std::uint64_t& seed) {
  AddNumber(command,
            "--seed",
            seed,
            AnyNumber<std::uint64_t>(),
            "Seed of every random draw; same seed, same data: same bytes");
}

void AddThreadsOption(CLI::App& command, int& num_threads) {
  num_threads = NumHardwareThreads();
  AddNumber(command,
            "--threads",
            num_threads,
            IntegerWithin(1, 1024),
            "Threads; they never change a result")
      ->default_str("all of the machine");
}

void AddJsonFileOption(CLI::App& command, std::string& target) {
  command.add_option("--json", target, "Write the result as JSON to a file, or print it (-)")
      ->expected(0, 1)
      ->type_name("[FILE]")
      ->default_str("-");
}

void WriteJson(const Console& console, const std::string& target, const std::string& text) {
  const std::string_view end = text.ends_with('\n') ? "" : "\n";
  if (target == "-") {
    console.out << text << end;
  } else if (!target.empty()) {
    WriteFileAtomically(target, text + std::string(end));
  }
}

void SetExample(CLI::App& command, const std::string& line) {
  command.footer("Example:\n  " + line);
}

void RequireWritable(const std::filesystem::path& path) {
  if (path.empty()) return;
  std::error_code ignored;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (std::filesystem::is_directory(path, ignored)) {
    throw Error({.path = path.string(),
                 .reason = "cannot write: this is a folder",
                 .remedy = "name a file"});
  }
  if (!std::filesystem::is_directory(folder, ignored)) {
    throw Error({.path = path.string(),
                 .reason = "cannot write: there is no folder " + folder.string(),
                 .remedy = "create it first"});
  }
  if (access(folder.c_str(), W_OK) != 0) {
    throw Error({.path = path.string(),
                 .reason = "cannot write: the folder " + folder.string() + " is not writable"});
  }
}

std::vector<std::filesystem::path> FilesOf(const datasets::LabelledImageSet& set) {
  std::vector<std::filesystem::path> files = {set.root / datasets::kManifestFileName};
  for (const datasets::LabelledImage& item : set.items) {
    files.push_back(set.root / item.image);
    files.push_back(set.root / item.mask);
  }
  return files;
}

std::vector<std::filesystem::path> FilesOf(const datasets::ViewSet& set) {
  std::vector<std::filesystem::path> files = {set.root / datasets::kViewsFileName,
                                              set.root / datasets::kDemonstrationsFileName,
                                              set.root / datasets::kHoldsFileName};
  for (const datasets::ObjectView& view : set.items) {
    for (const std::string* path : {&view.image, &view.object_mask, &view.cloud, &view.depth}) {
      if (!path->empty()) files.push_back(set.root / *path);
    }
  }
  return files;
}

void RequireNotAnInput(const std::filesystem::path& output,
                       std::span<const std::filesystem::path> inputs) {
  if (output.empty() || output == "-") return;
  for (const std::filesystem::path& input : inputs) {
    std::error_code ignored;  // what is not there cannot be overwritten
    if (!std::filesystem::equivalent(output, input, ignored)) continue;
    throw Error({.kind = Error::Kind::kUsage,
                 .path = output.string(),
                 .reason = "the result would overwrite the input " + input.string(),
                 .remedy = "name another file"});
  }
}

}  // namespace handcraft::tools
