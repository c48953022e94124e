// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "experiments/benchmarks/benchmark.h"
#include "experiments/evaluation/json_text.h"
#include "lib/core/error.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using Json = nlohmann::ordered_json;

struct BenchOptions {
  std::vector<std::string> only;
  std::string json;
  bool list = false;
  bool dataset_given = false;
  bool repetitions_given = false;
  experiments::BenchmarkOptions benchmark;
};

std::string NamesOfAll() {
  std::string names;
  for (const experiments::Benchmark& benchmark : experiments::AllBenchmarks()) {
    names += (names.empty() ? "" : ", ") + std::string(benchmark.name);
  }
  return names;
}

// The benchmarks asked for, in their own order; all when none is named. Throws Error(kUsage).
std::vector<experiments::Benchmark> Choose(const std::vector<std::string>& names) {
  const auto all = experiments::AllBenchmarks();
  for (const std::string& name : names) {
    const bool is_there = std::any_of(
        all.begin(), all.end(), [&](const auto& benchmark) { return benchmark.name == name; });
    if (!is_there) {
      throw Error({.kind = Error::Kind::kUsage,
                   .reason = "no benchmark '" + name + "'; there are: " + NamesOfAll()});
    }
  }
  std::vector<experiments::Benchmark> chosen;
  std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), [&](const auto& benchmark) {
    return names.empty() || std::find(names.begin(), names.end(), benchmark.name) != names.end();
  });
  return chosen;
}

// Throws Error(kUsage) for an option that none of the chosen benchmarks reads.
void RefuseUnread(const BenchOptions& options, const std::vector<experiments::Benchmark>& chosen) {
  const auto refuse = [&](const char* option, bool experiments::Benchmark::*reads) {
    if (std::any_of(chosen.begin(), chosen.end(), std::mem_fn(reads))) return;
    std::string names;
    for (const experiments::Benchmark& benchmark : chosen) {
      names += (names.empty() ? "" : ", ") + std::string(benchmark.name);
    }
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = std::string(option) + " is read by none of: " + names});
  };
  if (options.dataset_given) refuse("--data", &experiments::Benchmark::reads_dataset);
  if (options.repetitions_given)
    refuse("--repetitions", &experiments::Benchmark::reads_repetitions);
}

// Before minutes of work: the data set is there, and the result is not one of its files.
void CheckFiles(const BenchOptions& options, const std::vector<experiments::Benchmark>& chosen) {
  if (options.json != "-") RequireWritable(options.json);
  const bool reads_dataset = std::any_of(
      chosen.begin(), chosen.end(), std::mem_fn(&experiments::Benchmark::reads_dataset));
  if (!reads_dataset) return;
  RequireNotAnInput(options.json,
                    FilesOf(datasets::ReadLabelledImageSet(options.benchmark.dataset)));
}

Json ToJson(const experiments::BenchmarkResult& result) {
  return {{"name", result.name},
          {"what", result.what},
          {"dissertation_ms", result.dissertation_ms},
          {"target_ms", result.target_ms},
          {"peer", result.peer},
          {"peer_ms", result.peer_ms},
          {"ours_ms", result.ours_ms},
          {"ratio", result.ratio},
          {"unit", result.unit},
          {"details", result.details}};
}

// About three digits; "-" for what is not known.
std::string Figure(double value) {
  if (std::isnan(value)) return "-";
  const int num_decimals = value >= 100.0 ? 0 : value >= 10.0 ? 1 : value >= 1.0 ? 2 : 4;
  return fmt::format("{:.{}f}", value, num_decimals);
}

std::string ToText(const std::vector<experiments::BenchmarkResult>& results) {
  TextTable table(
      {"name", "ours [ms]", "target [ms]", "peer [ms]", "ratio", "dissertation [ms]", "peer"});
  std::string details;
  for (const experiments::BenchmarkResult& result : results) {
    table.AddRow({result.name,
                  Figure(result.ours_ms),
                  Figure(result.target_ms),
                  Figure(result.peer_ms),
                  Figure(result.ratio),
                  Figure(result.dissertation_ms),
                  result.peer});
    details += "\n" + result.name + ": " + result.what + "\n";
    for (const auto& [key, value] : result.details) {
      details += fmt::format("  {} = {:.6g}\n", key, value);
    }
  }
  return table.ToText() + details;
}

void ListBenchmarks(const Console& console) {
  TextTable table({"name", "what is measured"});
  for (const experiments::Benchmark& benchmark : experiments::AllBenchmarks()) {
    table.AddRow({std::string(benchmark.name), std::string(benchmark.what)});
  }
  console.out << table.ToText();
}

void RunBench(const BenchOptions& options, const Console& console) {
  if (options.list) return ListBenchmarks(console);
  const std::vector<experiments::Benchmark> chosen = Choose(options.only);
  RefuseUnread(options, chosen);
  CheckFiles(options, chosen);
  ProgressBar bar(console);
  const Progress progress = bar.Callback();
  experiments::BenchmarkOptions benchmark_options = options.benchmark;
  benchmark_options.progress = progress;
  std::vector<experiments::BenchmarkResult> results;
  for (const experiments::Benchmark& benchmark : chosen) {
    Report(progress, benchmark.name, results.size(), chosen.size());
    results.push_back(benchmark.run(benchmark_options));
    results.back().name = benchmark.name;
    results.back().what = benchmark.what;
    results.back().target_ms = benchmark.target_ms;
  }
  bar.Clear();
  Json json = Json::array();
  for (const experiments::BenchmarkResult& result : results) json.push_back(ToJson(result));
  WriteJson(console, options.json, experiments::JsonText(json));
  if (options.json != "-") console.out << ToText(results);
}

}  // namespace

void AddBench(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command =
      parent.add_subcommand("bench", "Measure every speed we claim, beside its peer, in one run");
  CLI::Option* only =
      command->add_option("--only", options->only, "Benchmarks to run; may be given several times")
          ->type_name("NAME")
          ->expected(1)
          ->take_all();
  CLI::Option* list =
      command->add_flag("--list", options->list, "Name the benchmarks and run none");
  CLI::Option* repetitions = AddNumber(*command,
                                       "--repetitions",
                                       options->benchmark.repetitions,
                                       IntegerWithin(1, 1000),
                                       "Times the quick ones are run; the median is kept");
  CLI::Option* data = command
                          ->add_option("--data",
                                       options->benchmark.dataset,
                                       "Labelled image set that gives the pictures to train on")
                          ->type_name("DIR")
                          ->capture_default_str();
  AddJsonFileOption(*command, options->json);
  SetExample(*command, "handcraft bench --only load_model");
  for (CLI::Option* other : {only, repetitions, data, command->get_option("--json")}) {
    list->excludes(other);
  }
  command->callback([options, data, repetitions, &console] {
    options->dataset_given = data->count() > 0;
    options->repetitions_given = repetitions->count() > 0;
    RunBench(*options, console);
  });
}

}  // namespace handcraft::tools
