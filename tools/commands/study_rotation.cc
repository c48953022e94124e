// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/described_views.h"
#include "experiments/evaluation/json_text.h"
#include "experiments/evaluation/rotation_evaluation.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/progress_bar.h"
#include "tools/rotation_options.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using experiments::RotationCounts;
using experiments::RotationEvaluation;
using Json = nlohmann::ordered_json;

struct StudyRotationOptions {
  std::string views;
  RotationArguments rotation = {};
  int num_threads = 1;
  bool json = false;
};

Json ToJson(const std::vector<RotationCounts>& all) {
  Json list = Json::array();
  for (const RotationCounts& counts : all) {
    Json one = {{"name", counts.name},
                {"symmetry", counts.symmetry},
                {"num_views", counts.num_views},
                {"num_found", counts.num_found},
                {"histogram", counts.histogram}};
    experiments::AddEstimate("found", counts.Found(), one);
    list.push_back(one);
  }
  return list;
}

void AddRow(const RotationCounts& counts, const std::string& name, TextTable& table) {
  const experiments::Estimate found = counts.Found();
  table.AddRow({name,
                counts.symmetry,
                std::to_string(counts.num_views),
                fmt::format("{:.1f} %", 100.0 * found.value),
                fmt::format("{:.1f} to {:.1f}", 100.0 * found.low, 100.0 * found.high)});
}

// The bins that hold anything: "10: 3, 350: 12".
std::string HistogramText(const RotationCounts& counts) {
  std::string text;
  for (std::size_t i = 0; i < counts.histogram.size(); ++i) {
    if (counts.histogram[i] == 0) continue;
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", 10 * i, counts.histogram[i]);
  }
  return text;
}

void RunStudyRotation(const StudyRotationOptions& options, const Console& console) {
  const datasets::ViewSet set = datasets::ReadViewSet(options.views);
  std::vector<features::ViewDescription> descriptions;
  {
    ProgressBar bar(console);
    descriptions = datasets::DescribeViews(set, options.num_threads, bar.Callback());
  }
  const RotationEvaluation evaluation =
      experiments::EvaluateRotation(set, descriptions, RuleOf(options.rotation));
  if (options.json) {
    console.Print({{"views", options.views},
                   {"classes", ToJson(evaluation.classes)},
                   {"symmetries", ToJson(evaluation.symmetries)}});
    return;
  }
  TextTable table({"class", "symmetry", "views", "turn found", "95 %"});
  for (const RotationCounts& counts : evaluation.classes) AddRow(counts, counts.name, table);
  for (const RotationCounts& counts : evaluation.symmetries) AddRow(counts, "all", table);
  console.out << table.ToText() << "\nTurned from the actual view by so many degrees: views\n";
  for (const RotationCounts& counts : evaluation.symmetries) {
    console.out << fmt::format("{}: {}\n", counts.symmetry, HistogramText(counts));
  }
}

}  // namespace

void AddStudyRotation(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<StudyRotationOptions>();
  CLI::App* command = parent.add_subcommand(
      "rotation", "How often an object's turn about z is found, each view left out in turn");
  command->add_option("VIEWS", options->views, "View set with clouds and angles")->required();
  AddRotationOptions(*command, options->rotation);
  AddThreadsOption(*command, options->num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft study rotation out/turntable");
  command->callback([options, &console] { RunStudyRotation(*options, console); });
}

}  // namespace handcraft::tools
