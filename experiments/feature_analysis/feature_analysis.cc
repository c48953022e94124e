// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/feature_analysis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "datasets/grasp_point_samples.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/core/rng.h"

namespace handcraft::experiments {
namespace {

using features::FeatureSpec;
using features::Filter;

datasets::SamplingOptions SamplingOf(const FeatureAnalysisOptions& options,
                                     std::size_t num_samples) {
  return {.num_samples = num_samples,
          .seed = options.seed,
          .num_threads = options.num_threads,
          .progress = options.progress};
}

// The objects (instances) to measure on: a share of them, at least one, at random.
std::set<std::string> DrawHeldOut(const datasets::LabelledImageSet& set,
                                  const FeatureAnalysisOptions& options) {
  std::set<std::string> sorted;
  for (const datasets::LabelledImage& item : set.items) sorted.insert(item.instance);
  if (sorted.size() < 2) {
    throw Error({.kind = Error::Kind::kBadInput,
                 .path = set.root.string(),
                 .reason = "the set shows one object alone: none would be left to measure on",
                 .remedy = "give pictures of at least two instances"});
  }
  std::vector<std::string> names(sorted.begin(), sorted.end());
  Rng rng = Rng::Stream(options.seed, "feature_analysis.held_out", 0);
  rng.Shuffle(std::span(names));
  const auto wanted = static_cast<std::size_t>(
      std::lround(options.held_out_share * static_cast<double>(names.size())));
  names.resize(std::clamp<std::size_t>(wanted, 1, names.size() - 1));
  return {names.begin(), names.end()};
}

void RequireBothClasses(const std::vector<std::uint8_t>& labels, std::string_view side) {
  const bool has_good = std::find(labels.begin(), labels.end(), 1) != labels.end();
  const bool has_bad = std::find(labels.begin(), labels.end(), 0) != labels.end();
  if (has_good && has_bad) return;
  throw Error(
      {.kind = Error::Kind::kBadInput,
       .reason = fmt::format("the {} objects give no {} pixels", side, has_good ? "bad" : "good"),
       .remedy = "give more objects, or another --seed"});
}

// Draws the classifier's samples and divides them by object.
HeldOutData DrawHeldOutData(const datasets::LabelledImageSet& set,
                            const FeatureAnalysisOptions& options) {
  const datasets::SamplingOptions sampling = SamplingOf(options, options.num_classifier_samples);
  const auto pixels = datasets::DrawSamples(set, sampling);
  const auto samples = datasets::ComputeSampleFeatures(set, pixels, options.spec, sampling);
  const std::set<std::string> held_out = DrawHeldOut(set, options);
  HeldOutData data{.num_features = samples.num_features, .num_held_out_groups = held_out.size()};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto found = held_out.find(set.items[pixels[i].image].instance);
    const bool is_held_out = found != held_out.end();
    auto& features = is_held_out ? data.held_out_features : data.features;
    const float* row = samples.features.data() + i * samples.num_features;
    features.insert(features.end(), row, row + samples.num_features);
    (is_held_out ? data.held_out_labels : data.labels).push_back(samples.labels[i]);
    if (is_held_out) {
      data.held_out_groups.push_back(
          static_cast<std::size_t>(std::distance(held_out.begin(), found)));
    }
  }
  RequireBothClasses(data.labels, "fitted");
  RequireBothClasses(data.held_out_labels, "held-out");
  return data;
}

// The dissertation's three, as far as the specification has their filters and its window is larger.
void AddNamedPresets(const FeatureSpec& spec, std::vector<TestedHypothesis>& hypotheses) {
  FeatureSpec edges = spec;
  std::erase_if(edges.filters, [](Filter f) { return f < Filter::kEdge0 || f > Filter::kEdge150; });
  FeatureSpec window = spec;
  window.window = std::min(spec.window, 3);
  FeatureSpec both = edges;
  both.window = window.window;
  const bool has_edges = !edges.filters.empty();
  if (has_edges) hypotheses.push_back({.name = "dissertation 1: edge filters", .spec = edges});
  hypotheses.push_back({.name = "dissertation 2: 3×3 window", .spec = window});
  if (has_edges) hypotheses.push_back({.name = "dissertation 3: both", .spec = both});
}

// The fewest filters whose log-loss is close to the least along the way.
FeatureSpec FewestByElimination(const BackwardElimination& elimination,
                                const FeatureAnalysisOptions& options) {
  double least = elimination.all.log_loss;
  for (const EliminationStep& step : elimination.steps) least = std::min(least, step.log_loss);
  const double limit = least * (1.0 + options.max_loss_increase);
  std::size_t num_gone = 0;
  for (std::size_t s = 0; s < elimination.steps.size(); ++s) {
    if (elimination.steps[s].log_loss <= limit) num_gone = s + 1;
  }
  FeatureSpec spec = options.spec;
  spec.filters.clear();
  for (std::size_t f = 0; f < options.spec.filters.size(); ++f) {
    const auto place = std::find(elimination.order.begin(), elimination.order.end(), f);
    if (static_cast<std::size_t>(place - elimination.order.begin()) >= num_gone) {
      spec.filters.push_back(options.spec.filters[f]);
    }
  }
  return spec;
}

// Fits each hypothesis and compares it with all features. Equal specifications are fitted once.
void TestHypotheses(const HeldOutData& data, FeatureAnalysis& analysis) {
  const FeatureAnalysisOptions& options = analysis.options;
  const HeldOutFit& all = analysis.elimination.all;
  std::map<std::string, HeldOutFit> fits = {{features::ToString(options.spec), all}};
  for (std::size_t h = 0; h < analysis.hypotheses.size(); ++h) {
    Report(options.progress, "testing hypotheses", h, analysis.hypotheses.size());
    TestedHypothesis& hypothesis = analysis.hypotheses[h];
    const std::string text = features::ToString(hypothesis.spec);
    if (!fits.contains(text)) {
      fits[text] = FitColumns(data,
                              ColumnsOf(hypothesis.spec, options.spec),
                              &all,
                              {.ridge = options.ridge, .seed = options.seed});
    }
    hypothesis.log_loss = fits[text].log_loss;
    hypothesis.auc = fits[text].auc;
    hypothesis.increase = LossIncrease(fits[text], all, data, options.seed);
  }
}

// Principal components in every scaling, and what they suggest.
void AnalyseEnergy(const datasets::LabelledImageSet& set, FeatureAnalysis& analysis) {
  const FeatureAnalysisOptions& options = analysis.options;
  datasets::SamplingOptions sampling = SamplingOf(options, options.num_samples);
  sampling.left_out = options.left_out;
  const auto samples = datasets::ComputeSampleFeatures(
      set, datasets::DrawSamples(set, sampling), options.spec, sampling);
  const DesignMatrix<float> X{.data = samples.features.data(),
                              .num_samples = samples.num_samples(),
                              .num_features = samples.num_features,
                              .stride = samples.num_features};
  const Scatter scatter =
      ComputeScatter(X, {}, 1, {.num_threads = options.num_threads, .progress = options.progress});
  analysis.num_samples = samples.num_samples();
  analysis.pca = pca::PcaOfScatter(scatter, std::vector<double>(X.num_features, 1.0));
  for (const FeatureScaling scaling : ScalingsOf(options.spec)) {
    analysis.spectra.push_back(ComputeEnergySpectrum(scatter, options.spec, scaling));
  }
}

void ListHypotheses(FeatureAnalysis& analysis) {
  const FeatureSpec& spec = analysis.options.spec;
  analysis.hypotheses.push_back({.name = "all features", .spec = spec});
  AddNamedPresets(spec, analysis.hypotheses);
  for (const EnergySpectrum& spectrum : analysis.spectra) {
    const Hypotheses derived = DeriveHypotheses(spectrum, spec, analysis.options.rule);
    const std::string prefix = fmt::format("energy, {}, ", NameOf(spectrum.scaling));
    analysis.hypotheses.push_back({.name = prefix + "1: filters", .spec = derived.filters});
    analysis.hypotheses.push_back({.name = prefix + "2: window", .spec = derived.window});
    analysis.hypotheses.push_back({.name = prefix + "3: both", .spec = derived.both});
  }
  analysis.hypotheses.push_back(
      {.name = "usefulness: filters",
       .spec = FewestByElimination(analysis.elimination, analysis.options)});
}

}  // namespace

void FeatureAnalysisOptions::Validate() const {
  const std::string name = "FeatureAnalysisOptions.";
  RequireOption(num_samples >= 100, name + "num_samples", num_samples, ">= 100");
  RequireOption(num_classifier_samples >= 100,
                name + "num_classifier_samples",
                num_classifier_samples,
                ">= 100");
  RequireOption(held_out_share > 0.0 && held_out_share < 1.0,
                name + "held_out_share",
                held_out_share,
                "in (0, 1)");
  RequireOption(max_loss_increase >= 0.0 && std::isfinite(max_loss_increase),
                name + "max_loss_increase",
                max_loss_increase,
                "a finite number >= 0");
  RequireOption(ridge > 0.0 && std::isfinite(ridge), name + "ridge", ridge, "a finite number > 0");
  RequireOption(num_threads >= 1, name + "num_threads", num_threads, ">= 1");
  rule.Validate();
}

std::vector<std::size_t> ColumnsOf(const FeatureSpec& part, const FeatureSpec& whole) {
  std::map<std::string, std::size_t> column_of;
  for (int j = 0; j < whole.NumFeatures(); ++j) {
    column_of[features::FeatureName(whole, j)] = static_cast<std::size_t>(j);
  }
  std::vector<std::size_t> columns;
  for (int j = 0; j < part.NumFeatures(); ++j) {
    const auto found = column_of.find(features::FeatureName(part, j));
    HC_CHECK(found != column_of.end(), features::FeatureName(part, j));
    columns.push_back(found->second);
  }
  std::sort(columns.begin(), columns.end());
  return columns;
}

FeatureAnalysis AnalyseFeatures(const datasets::LabelledImageSet& set,
                                const FeatureAnalysisOptions& options) {
  options.Validate();
  const std::string_view fault = features::FaultOf(options.spec);
  HC_CHECK(fault.empty(), fault);
  FeatureAnalysis analysis{.options = options, .data_fingerprint = datasets::Fingerprint(set)};
  AnalyseEnergy(set, analysis);
  const HeldOutData data = DrawHeldOutData(set, options);
  analysis.num_fit_samples = data.labels.size();
  analysis.num_held_out_samples = data.held_out_labels.size();
  analysis.num_held_out_objects = data.num_held_out_groups;
  std::set<std::string> objects;
  for (const datasets::LabelledImage& item : set.items) objects.insert(item.instance);
  analysis.num_fit_objects = objects.size() - data.num_held_out_groups;
  std::vector<std::size_t> filter_of_column(data.num_features);
  for (std::size_t j = 0; j < data.num_features; ++j) {
    filter_of_column[j] = j % options.spec.filters.size();
  }
  analysis.elimination = EliminateBackward(data,
                                           filter_of_column,
                                           options.spec.filters.size(),
                                           {.fit = {.ridge = options.ridge, .seed = options.seed},
                                            .num_threads = options.num_threads,
                                            .progress = options.progress});
  ListHypotheses(analysis);
  TestHypotheses(data, analysis);
  return analysis;
}

}  // namespace handcraft::experiments
