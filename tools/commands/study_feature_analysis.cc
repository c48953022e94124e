// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "datasets/formats/labelled_image_set.h"
#include "experiments/feature_analysis/feature_analysis.h"
#include "experiments/feature_analysis/feature_analysis_report.h"
#include "experiments/feature_analysis/feature_analysis_tables.h"
#include "experiments/runner/pinned_inputs.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/model_io/model_writer.h"
#include "lib/model_io/pca_models.h"
#include "lib/runtime/handcraft_runtime.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/feature_names.h"
#include "tools/number_option.h"
#include "tools/output_folder.h"
#include "tools/progress_bar.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using experiments::FeatureAnalysis;
using experiments::FeatureAnalysisOptions;

struct StudyOptions {
  std::string data;
  std::string out;
  std::string features = "all500";
  std::string split = "train";
  FeatureAnalysisOptions analysis;
};

// Principal components that hold 99 % of the raw features' energy.
std::vector<std::uint8_t> PcaModelBytes(const FeatureAnalysis& analysis) {
  const pca::Result& pca = analysis.pca;
  const std::size_t count = pca.NumComponentsFor(experiments::kEnergyShares.back());
  const auto end = pca.components.begin() + static_cast<std::ptrdiff_t>(count * pca.num_features);
  return model_io::Serialise(model_io::MakePcaModel(
      FeatureNames(analysis.options.spec),
      {.components = {pca.components.begin(), end},
       .eigenvalues = pca.eigenvalues,
       .feature_mean = pca.mean,
       .feature_scale = pca.scale},
      {.name = "feature_analysis",
       .task = "pca",
       .intended_use = "principal components of grasp-point features, for analysis",
       .algorithm = "pca",
       .data_fingerprint = analysis.data_fingerprint,
       .hyper_parameters = FieldsToText(analysis.options, "feature_analysis."),
       .metrics = {{"train.num_samples", NumberToText(pca.num_samples)}}}));
}

FeatureAnalysis Analyse(const StudyOptions& options,
                        const datasets::LabelledImageSet& set,
                        const Console& console) {
  std::vector<std::string> left_out;
  FeatureAnalysisOptions analysis = options.analysis;
  analysis.left_out = [&](const std::string& image, std::string_view reason) {
    left_out.push_back(fmt::format("left out: {}, {}", image, reason));
  };
  ProgressBar bar(console);
  analysis.progress = bar.Callback();
  FeatureAnalysis result = experiments::AnalyseFeatures(set, analysis);
  bar.Clear();
  for (const std::string& warning : left_out) console.Warn(warning);
  return result;
}

void PrintSummary(const FeatureAnalysis& analysis, const std::string& out, const Console& console) {
  TextTable table(
      {"hypothesis", "features", "held-out log-loss", "AUC", "above all features", "keeps"});
  for (const experiments::TestedHypothesis& tested : analysis.hypotheses) {
    table.AddRow({tested.name,
                  std::to_string(tested.spec.NumFeatures()),
                  fmt::format("{:.4f}", tested.log_loss),
                  fmt::format("{:.3f}", tested.auc),
                  fmt::format("{:+.4f}", tested.increase.value),
                  fmt::format("{}; {}×{}",
                              experiments::KeptFiltersText(tested.spec, analysis.options.spec),
                              tested.spec.window,
                              tested.spec.window)});
  }
  console.out << table.ToText() << "\nReport written to " << out << '\n';
}

// Under the names that other studies use, so that neither takes up a folder of the other.
void PinInputs(const StudyOptions& options, const datasets::LabelledImageSet& set) {
  std::vector<std::string> lines = {"study = feature-analysis",
                                    "features = " + features::ToString(options.analysis.spec),
                                    "split = " + options.split};
  for (const auto& [name, value] : FieldsToText(options.analysis)) {
    lines.push_back(fmt::format("{} = {}", name, value));
  }
  const experiments::PinnedInputs inputs(options.out);
  inputs.Pin("version", fmt::format("{}\n", hc_version()));
  inputs.Pin("study", fmt::format("{}\n", fmt::join(lines, "\n")));
  inputs.Pin("data.train", datasets::Fingerprint(set) + "\n");
}

void RunStudy(StudyOptions options, const Console& console) {
  options.analysis.spec = features::ParseFeatureSpec(options.features);
  options.analysis.Validate();
  const datasets::LabelledImageSet set =
      datasets::ReadLabelledImageSet(options.data).Only(options.split);
  const std::string data_name =
      std::filesystem::absolute(options.data).lexically_normal().filename().string();
  const std::vector<std::filesystem::path> inputs = FilesOf(set);
  PinInputs(options, set);
  OutputFolder folder(options.out);
  const FeatureAnalysis analysis = Analyse(options, set, console);
  const auto claim = [&](const std::string& name) {
    std::filesystem::path path = folder.Claim(name);
    RequireNotAnInput(path, inputs);
    return path;
  };
  for (const auto& [name, text] : experiments::FeatureAnalysisFiles(analysis, data_name)) {
    WriteFileAtomically(claim(name), text);
  }
  WriteFileAtomically(claim("pca.safetensors"), PcaModelBytes(analysis));
  folder.Keep();
  PrintSummary(analysis, options.out, console);
}

void AddAnalysisOptions(CLI::App& command, FeatureAnalysisOptions& options) {
  AddNumber(command,
            "--samples",
            options,
            &FeatureAnalysisOptions::num_samples,
            "Pixels for the principal components");
  AddNumber(command,
            "--classifier-samples",
            options,
            &FeatureAnalysisOptions::num_classifier_samples,
            "Pixels to fit and to measure the classifier on");
  AddNumber(command,
            "--held-out-share",
            options,
            &FeatureAnalysisOptions::held_out_share,
            "Share of the objects that the classifier is measured on, (0, 1)");
  AddNumber(
      command,
      "--max-loss-increase",
      options,
      &FeatureAnalysisOptions::max_loss_increase,
      "Share by which the held-out log-loss may lie above the least when filters are dropped");
  AddNumber(
      command, "--ridge", options, &FeatureAnalysisOptions::ridge, "Penalty of the fits, above 0");
  AddNumber(command,
            "--min-filter-share",
            options.rule,
            &experiments::HypothesisRule::min_filter_share,
            "Filters with a smaller share of the energy are dropped");
  AddNumber(command,
            "--min-ring-strength",
            options.rule,
            &experiments::HypothesisRule::min_ring_strength,
            "Outer rings of the window with lower peaks are dropped");
}

}  // namespace

void AddStudyFeatureAnalysis(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<StudyOptions>();
  CLI::App* command = parent.add_subcommand(
      "feature-analysis",
      "Which filters and which window pixels matter, and what dropping them costs");
  command->add_option("--data", options->data, "Labelled image set: folder with manifest.csv")
      ->type_name("DIR")
      ->required();
  command
      ->add_option(
          "--out", options->out, "Folder for the report, a new one or that of the same analysis")
      ->type_name("DIR")
      ->required();
  command
      ->add_option("--features",
                   options->features,
                   "Features in question: all500, saxena459, …, then changes such as energy=log")
      ->type_name("SPEC")
      ->capture_default_str();
  command->add_option("--split", options->split, "Split to take pixels from; '' for all images")
      ->capture_default_str();
  AddAnalysisOptions(*command, options->analysis);
  AddSeedOption(*command, options->analysis.seed);
  AddThreadsOption(*command, options->analysis.num_threads);
  SetExample(*command,
             "handcraft study run feature-analysis --data datasets/samples/cornell_mini "
             "--features edges54 --out out/feature_analysis");
  command->callback([options, &console] { RunStudy(*options, console); });
}

}  // namespace handcraft::tools
