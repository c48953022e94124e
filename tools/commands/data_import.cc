// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "datasets/formats/fault.h"
#include "datasets/formats/set_fingerprint.h"
#include "datasets/importers/image_set_import.h"
#include "datasets/importers/view_set_import.h"
#include "lib/core/error.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/findings.h"
#include "tools/import_formats.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"

namespace handcraft::tools {
namespace {

struct DataImportOptions {
  std::string source;
  std::string out;
  SourceLister list;
  SetKind makes = SetKind::kLabelledImages;
  datasets::ImportOptions import;
  bool json = false;
};

// Empty for a good one.
std::string RuleAgainstPattern(const std::string& pattern) {
  try {
    datasets::ImportOptions{.instance_pattern = pattern}.Validate();
  } catch (const Error& refusal) {
    return "'" + pattern + "' given; it must be " + RuleOf(refusal);
  }
  return "";
}

void AddSharedOptions(CLI::App& command, DataImportOptions& options) {
  command.add_option("--out", options.out, "Folder to make; must not exist or be empty")
      ->type_name("DIR")
      ->required();
  AddNumber(command,
            "--test-share",
            options.import,
            &datasets::ImportOptions::test_share,
            "Share of the instances put into 'test', those last by name");
  AddNumber(command,
            "--max-images",
            options.import,
            &datasets::ImportOptions::max_images,
            "Keep this many, evenly spread over the pictures; 0: all");
  command
      .add_option("--instance-pattern",
                  options.import.instance_pattern,
                  "Regular expression; its first group in a picture's path is the instance")
      ->check(CLI::Validator(RuleAgainstPattern, ""))
      ->type_name("REGEX");
  command.add_option("--licence", options.import.licence, "Written into the manifest")
      ->capture_default_str();
  AddThreadsOption(command, options.import.num_threads);
  AddJsonFlag(command, options.json);
}

// A few of the notes by name, and how many there are besides.
void Warn(const std::vector<datasets::Fault>& notes, const Console& console) {
  constexpr std::size_t kMostNotes = 10;
  for (std::size_t i = 0; i < std::min(notes.size(), kMostNotes); ++i) {
    console.Warn(ToText(notes[i]));
  }
  if (notes.size() <= kMostNotes) return;
  console.Warn(std::to_string(notes.size() - kMostNotes) + " more; --json tells all");
}

// What was made, in words and as JSON.
template <class Set>
void TellOf(const Set& set,
            const std::vector<datasets::Fault>& notes,
            const char* what,
            const DataImportOptions& options,
            const Console& console) {
  if (options.json) {
    console.Print({{"folder", options.out},
                   {std::string("num_") + what, set.items.size()},
                   {"fingerprint", datasets::Fingerprint(set)},
                   {"notes", ToJson(notes)}});
  } else {
    console.out << "Wrote " << set.items.size() << ' ' << what << " with masks to " << options.out
                << '\n';
  }
}

// data check refuses a picture that is listed twice; files of unequal size need not be read.
template <class Set>
std::vector<datasets::Fault> NotesOnTwins(const Set& set) {
  std::map<std::uintmax_t, std::vector<std::string>> by_size;
  for (const auto& item : set.items) {
    by_size[std::filesystem::file_size(set.root / item.image)].push_back(item.image);
  }
  std::vector<datasets::Fault> notes;
  for (const auto& group : by_size) {
    std::map<std::string, std::string> first_of_content;
    if (group.second.size() < 2) continue;
    for (const std::string& image : group.second) {
      const std::string digest = datasets::FileDigest(set.root / image);
      const auto [first, is_new] = first_of_content.try_emplace(digest, image);
      if (is_new) continue;
      notes.push_back({.path = image,
                       .reason = "is the same picture as " + first->second +
                                 ": handcraft data check refuses the set",
                       .gravity = datasets::Gravity::kNote,
                       .remedy = "keep one of them"});
    }
  }
  return notes;
}

// Warns of what is worth knowing, twins first, and tells of what was made.
template <class Set>
void Tell(const Set& set,
          const std::vector<datasets::Fault>& notes,
          const char* what,
          const DataImportOptions& options,
          const Console& console) {
  std::vector<datasets::Fault> all = NotesOnTwins(set);
  all.insert(all.end(), notes.begin(), notes.end());
  Warn(all, console);
  TellOf(set, all, what, options, console);
}

void RequireThere(const std::filesystem::path& source) {
  std::error_code ignored;
  if (std::filesystem::exists(source, ignored)) return;
  throw Error({.path = source.string(),
               .reason = "no such file or folder",
               .remedy = "check the path of the data set to import"});
}

void RunDataImport(const DataImportOptions& options, const Console& console) {
  options.import.Validate();
  RequireThere(options.source);
  datasets::SourceSet source = options.list(options.source);
  ProgressBar bar(console);
  std::vector<datasets::Fault> notes;
  datasets::ImportOptions with_calls = options.import;
  with_calls.progress = bar.Callback();
  with_calls.on_note = [&notes](const datasets::Fault& note) { notes.push_back(note); };
  if (options.makes == SetKind::kViews) {
    const auto set = datasets::ImportViews(std::move(source), options.out, with_calls);
    bar.Clear();
    Tell(set, notes, "views", options, console);
  } else {
    const auto set = datasets::ImportPictures(std::move(source), options.out, with_calls);
    bar.Clear();
    Tell(set, notes, "images", options, console);
  }
}

}  // namespace

void AddDataImport(CLI::App& parent, const Console& console) {
  CLI::App* import = parent.add_subcommand("import", "Turn a public data set into one of ours");
  import->require_subcommand(1);
  for (const ImportFormat& format : ImportFormats()) {
    auto options = std::make_shared<DataImportOptions>();
    CLI::App* command = import->add_subcommand(format.name, format.description);
    command->add_option("SRC", options->source, format.source)->required();
    options->list = format.add_options(*command);
    options->makes = format.makes;
    AddSharedOptions(*command, *options);
    SetExample(*command, std::string("handcraft data import ") + format.example);
    command->callback([options, &console] { RunDataImport(*options, console); });
  }
}

}  // namespace handcraft::tools
