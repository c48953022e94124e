// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/handcraft.h"

#include <unistd.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "lib/core/error.h"
#include "lib/runtime/handcraft_runtime.h"
#include "tools/commands.h"
#include "tools/console.h"
#include "tools/help_formatter.h"

namespace handcraft::tools {
namespace {

constexpr int kExitBug = 1;

CLI::App& AddGroup(CLI::App& parent, const std::string& name, const std::string& description) {
  CLI::App* group = parent.add_subcommand(name, description);
  group->require_subcommand(1);
  return *group;
}

// An empty path is never meant: it is what "$OUT" gives when OUT was not set.
void RefuseEmptyPaths(CLI::App& app) {
  const CLI::Validator not_empty(
      [](const std::string& text) {
        return text.empty() ? std::string("an empty path was given") : std::string();
      },
      "");
  for (CLI::Option* option : app.get_options()) {
    const std::string type = option->get_type_name();
    const bool is_path = option->get_positional() || type == "FILE" || type == "DIR";
    if (is_path) option->check(not_empty);
  }
  for (CLI::App* command : app.get_subcommands({})) RefuseEmptyPaths(*command);
}

void AddCommands(CLI::App& app, const Console& console) {
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string("handcraft ") + hc_version());
  app.formatter(std::make_shared<HelpFormatter>());
  app.footer("Run 'handcraft COMMAND --help' for the options of a command and an example.");
  CLI::App& data = AddGroup(app, "data", "Import, make, describe, check and export data sets");
  AddDataInfo(data, console);
  AddDataCheck(data, console);
  AddDataClouds(data, console);
  AddDataExport(data, console);
  AddDataImport(data, console);
  AddDataPreview(data, console);
  AddDataSplit(data, console);
  AddDataSynth(data, console);
  CLI::App& train = AddGroup(app, "train", "Fit a model and write it to a file");
  AddTrainGraspPoints(train, console);
  AddTrainLda(train, console);
  AddTrainLogistic(train, console);
  AddTrainGraspLibrary(train, console);
  AddTrainObjectClass(train, console);
  AddTrainSvm(train, console);
  AddEvaluate(app, console);
  AddPredict(app, console);
  AddPlan(app, console);
  AddInspect(app, console);
  AddCheckModel(app, console);
  AddExport(app, console);
  AddImport(app, console);
  AddRobot(app, console);
  AddStudy(app, console);
  AddBench(app, console);
  RefuseEmptyPaths(app);
}

// The innermost command that was named.
const CLI::App& NamedCommand(const CLI::App& app) {
  const std::vector<CLI::App*> named = app.get_subcommands();
  return named.empty() ? app : NamedCommand(*named.front());
}

std::string FullName(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : FullName(*parent) + " " + command.get_name();
}

// CLI11 lists what it did not expect from the end.
std::string DescribeOptionError(const CLI::App& command, const CLI::ParseError& error) {
  const std::vector<std::string> rest = command.remaining();
  if (rest.empty() || dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr) return error.what();
  std::string words;
  for (const std::string& word : rest) words += " " + word;
  return (rest.size() == 1 ? "The following argument was not expected:"
                           : "The following arguments were not expected:") +
         words;
}

// CLI11 answers a wrong command word with "A subcommand is required": name the word and the choice.
std::string DescribeParseError(const CLI::App& command, const CLI::ParseError& error) {
  const std::vector<const CLI::App*> choices =
      command.get_subcommands([](const CLI::App* choice) { return !choice->get_name().empty(); });
  if (choices.empty() || command.get_require_subcommand_min() == 0) {
    return DescribeOptionError(command, error);
  }
  std::string names;
  for (const CLI::App* choice : choices) names += (names.empty() ? "" : ", ") + choice->get_name();
  const std::vector<std::string> rest = command.remaining();
  const std::string found = rest.empty() ? "a command is missing" : "no command '" + rest[0] + "'";
  return found + "; there are: " + names;
}

int ReportParseError(const CLI::App& app, const CLI::ParseError& error, const Console& console) {
  const CLI::App& command = NamedCommand(app);
  if (error.get_exit_code() == 0) {
    return app.exit(error, console.out, console.err);  // --help and --version
  }
  console.err << "handcraft: error: " << DescribeParseError(command, error) << "\nTry '"
              << FullName(command) << " --help'.\n";
  return ExitCode(Error::Kind::kUsage);
}

int ReportError(const CLI::App& app, const Error& error, const Console& console) {
  console.err << "handcraft: error: " << error.what() << '\n';
  if (error.details().kind == Error::Kind::kUsage) {
    console.err << "Try '" << FullName(NamedCommand(app)) << " --help'.\n";
  }
  return ExitCode(error.details().kind);
}

// Every exception becomes a message and an exit code here, and nowhere else.
int ParseAndRun(CLI::App& app, std::span<const char* const> args, const Console& console) {
  try {
    AddCommands(app, console);
    std::vector<std::string> reversed(args.rbegin(), args.rend());  // CLI11 reads from the end
    app.parse(std::move(reversed));
    return 0;
  } catch (const CLI::ParseError& error) {
    return ReportParseError(app, error, console);
  } catch (const Error& error) {
    return ReportError(app, error, console);
  } catch (const std::filesystem::filesystem_error& error) {
    return ReportError(
        app, Error({.path = error.path1().string(), .reason = error.code().message()}), console);
  } catch (const std::bad_alloc&) {
    console.err << "handcraft: error: out of memory (use fewer samples, features or pictures)\n";
    return ExitCode(Error::Kind::kBadInput);
  } catch (const std::exception& error) {
    console.err
        << "handcraft: error: " << error.what()
        << "\nThis is a bug in handcraft: please report it with the command that you ran.\n";
    return kExitBug;
  }
}

}  // namespace

int RunHandcraft(std::span<const char* const> args, std::ostream& out, std::ostream& err) noexcept
    try {
  const Console console{out, err, &err == &std::cerr && isatty(STDERR_FILENO) == 1};
  CLI::App app("Trains small, explainable robot-manipulation models and runs them on the robot.",
               "handcraft");
  const int code = ParseAndRun(app, args, console);
  if (code != 0 || out.flush()) return code;
  return ReportError(
      app,
      Error({.path = "standard output", .reason = "cannot write: the result is incomplete"}),
      console);
} catch (...) {
  return kExitBug;
}

}  // namespace handcraft::tools
