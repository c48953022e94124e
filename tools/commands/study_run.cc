// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_run.h"

#include <cmath>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/evaluation/html_text.h"
#include "experiments/runner/shipped_studies.h"
#include "experiments/runner/study_file.h"
#include "experiments/runner/study_report.h"
#include "experiments/runner/summary_markdown.h"
#include "experiments/view_studies/view_study_report.h"
#include "experiments/view_studies/view_study_run.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/path_kind.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/progress_bar.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

struct StudyRunCommand {
  std::string study;
  std::string out;
  std::string size = "small";
  std::string data;
  std::string test_data;
  std::vector<std::string> methods;
  int num_threads = 1;
  bool json = false;
};

experiments::StudySize SizeOf(const StudyRunCommand& options) {
  return options.size == "full" ? experiments::StudySize::kFull : experiments::StudySize::kSmall;
}

// A shipped study goes before a file of its name; ./NAME is always the file.
std::string StudyText(const StudyRunCommand& options) {
  if (const experiments::ShippedStudy* shipped = experiments::FindShippedStudy(options.study)) {
    return std::string(shipped->text);
  }
  if (Exists(options.study)) return ReadTextFile(options.study);
  std::string names = "feature-analysis";
  for (const experiments::ShippedStudy& shipped : experiments::ShippedStudies()) {
    names.append(", ").append(shipped.name);
  }
  throw Error({.kind = Error::Kind::kUsage,
               .reason = "no study and no file \"" + options.study + "\"; there are: " + names});
}

// CLI11 would ask for these of feature-analysis too.
void RequireGiven(const StudyRunCommand& options) {
  if (!options.study.empty() && !options.out.empty()) return;
  throw Error({.kind = Error::Kind::kUsage,
               .reason = options.study.empty() ? "STUDY is required: a name or a file"
                                               : "--out is required: the folder of the results"});
}

// Other pictures than those the file names.
void ReplaceData(const StudyRunCommand& options, experiments::Study& study) {
  if (!options.data.empty()) study.train = {.folder = options.data};
  if (!options.test_data.empty()) study.test = experiments::DataSource{.folder = options.test_data};
}

void PrintText(const StudyRunCommand& options,
               const experiments::StudyRun& run,
               const std::string& verdict,
               const Console& console) {
  TextTable table({"cell", "samples", "features", "best pixels", "95 %", "AUC", "accuracy"});
  for (const experiments::CellResult& result : run.results) {
    const experiments::GroupFigures& all = result.groups.back();
    table.AddRow({result.id,
                  std::to_string(result.num_samples),
                  std::to_string(result.num_features),
                  experiments::PercentText(all.best_pixel_accuracy.value),
                  experiments::PercentIntervalText(all.best_pixel_accuracy),
                  experiments::DecimalText(all.auc.value, 3),
                  experiments::PercentText(all.accuracy.value)});
  }
  console.out << table.ToText() << '\n';
  if (!verdict.empty()) console.out << verdict << '\n';
  console.out << "Wrote " << options.out << ": " << run.cells.size() << " cells";
  if (run.num_resumed > 0) console.out << ", " << run.num_resumed << " of an earlier run";
  console.out << '\n';
}

void PrintJson(const StudyRunCommand& options,
               const experiments::StudyRun& run,
               const std::string& verdict,
               const Console& console) {
  console.Print({{"study", run.study.name},
                 {"out", options.out},
                 {"num_cells", run.cells.size()},
                 {"num_resumed", run.num_resumed},
                 {"verdict", verdict},
                 {"results", (std::filesystem::path(options.out) / "results.csv").string()}});
}

void WarnOf(const experiments::GnuplotReport& gnuplot, const Console& console) {
  if (!gnuplot.has_gnuplot) {
    console.Warn("there is no gnuplot: figures are SVG alone, without PDF (Debian: gnuplot-nox)");
  }
  for (const std::string& name : gnuplot.failed) {
    console.Warn(
        fmt::format("gnuplot failed on figures/{0}.gnuplot: {0} is SVG alone, without PDF", name));
  }
}

void RunPixelStudy(const StudyRunCommand& options,
                   experiments::Study study,
                   const Console& console) {
  ReplaceData(options, study);
  if (!options.methods.empty()) experiments::KeepMethods(options.methods, study);
  ProgressBar bar(console);
  const experiments::StudyRun run = experiments::RunStudy(
      study, {.out = options.out, .num_threads = options.num_threads, .progress = bar.Callback()});
  bar.Clear();
  const experiments::StudySummary summary = experiments::SummariseStudy(run, options.num_threads);
  WarnOf(experiments::WriteStudyReport(options.out, run, summary), console);
  for (const std::string& cell : run.redone) console.Warn(cell);
  for (const std::string& warning : summary.warnings) console.Warn(warning);
  const std::string verdict = experiments::VerdictText(study, summary);
  options.json ? PrintJson(options, run, verdict, console)
               : PrintText(options, run, verdict, console);
}

void PrintViewStudy(const StudyRunCommand& options,
                    const experiments::ViewStudyRun& run,
                    const Console& console) {
  TextTable table({"cell", "group", "views", "right", "95 %"});
  auto json = nlohmann::ordered_json::array();
  for (const experiments::ViewCellResult& result : run.results) {
    for (const experiments::GroupShare& group : result.groups) {
      table.AddRow({result.id,
                    group.name,
                    std::to_string(group.num_views),
                    experiments::PercentText(group.share.value),
                    experiments::PercentIntervalText(group.share)});
      json.push_back({{"cell", result.id}, {"group", group.name}, {"share", group.share.value}});
    }
  }
  if (options.json) {
    console.Print({{"study", run.study.name}, {"out", options.out}, {"results", json}});
    return;
  }
  console.out << table.ToText() << "\nWrote " << options.out << ": " << run.cells.size()
              << " cells\n";
}

void RunStudyOfViews(const StudyRunCommand& options,
                     experiments::ViewStudy study,
                     const Console& console) {
  if (!options.data.empty()) study.train = {.folder = options.data};
  if (!options.test_data.empty()) study.test = experiments::ViewSource{.folder = options.test_data};
  if (!options.methods.empty()) {
    experiments::KeepMethods(options.methods, study.name, study.methods);
  }
  ProgressBar bar(console);
  const experiments::ViewStudyRun run = experiments::RunViewStudy(
      study, {.out = options.out, .num_threads = options.num_threads, .progress = bar.Callback()});
  bar.Clear();
  WarnOf(experiments::WriteViewStudyReport(options.out, run), console);
  PrintViewStudy(options, run, console);
}

void RunStudyRun(const StudyRunCommand& options, const Console& console) {
  const std::string text = StudyText(options);
  if (experiments::IsViewStudy(text, options.study)) {
    RunStudyOfViews(
        options, experiments::ParseViewStudy(text, options.study, SizeOf(options)), console);
  } else {
    RunPixelStudy(options, experiments::ParseStudy(text, options.study, SizeOf(options)), console);
  }
}

}  // namespace

void AddStudyRun(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<StudyRunCommand>();
  CLI::App* command =
      parent.add_subcommand("run", "Work out every cell of a study; goes on where it was stopped");
  command->add_option("STUDY", options->study, "Name of a shipped study, or a study file (TOML)")
      ->type_name("NAME|FILE");
  command->add_option("--out", options->out, "Folder of the results")->type_name("DIR");
  command->add_option("--size", options->size, "Which values of { small = …, full = … } are meant")
      ->check(CLI::IsMember({"small", "full"}))
      ->capture_default_str();
  command->add_option("--data", options->data, "Data set in place of [data.train]")
      ->type_name("DIR");
  command->add_option("--test-data", options->test_data, "Data set in place of [data.test]")
      ->type_name("DIR");
  command
      ->add_option("--methods",
                   options->methods,
                   "These methods of the study alone; its baseline, if any, must be among them")
      ->type_name("NAME,...")
      ->delimiter(',');
  AddThreadsOption(*command, options->num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command,
             "handcraft study run chapter3-trained-objects --data datasets/samples/cornell_mini "
             "--methods all500,H1,H2,H3 --out study");
  AddStudyFeatureAnalysis(*command, console);
  command->callback([options, command, &console] {
    if (!command->get_subcommands().empty()) return;  // it has done the work
    RequireGiven(*options);
    RunStudyRun(*options, console);
  });
}

}  // namespace handcraft::tools
