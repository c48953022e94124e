// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/formats/labelled_image_set.h"
#include "experiments/feature_analysis/backward_elimination.h"
#include "experiments/feature_analysis/energy_spectrum.h"
#include "lib/core/progress.h"
#include "lib/features/feature_spec.h"
#include "trainers/pca/pca.h"

namespace handcraft::experiments {

struct FeatureAnalysisOptions {
  features::FeatureSpec spec = {};  ///< the features in question
  std::size_t num_samples = 40000;  ///< for the principal components, half of them good, ≥ 100
  std::size_t num_classifier_samples = 8000;  ///< for the fits, held-out ones included, ≥ 100
  double held_out_share = 0.3;                ///< of the objects (instances), (0, 1)
  double max_loss_increase = 0.02;  ///< by which share the held-out log-loss may lie above the
                                    ///< least along the elimination when filters are dropped, ≥ 0
  double ridge = 1.0;               ///< of the fits, > 0
  HypothesisRule rule = {};
  std::uint64_t seed = 1;
  int num_threads = 1;  ///< ≥ 1; changes no bit of the result
  Progress progress = {};
  /// Told each image that gives no samples, and why.
  std::function<void(const std::string& image, std::string_view reason)> left_out = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("num_samples", num_samples);
    visit("num_classifier_samples", num_classifier_samples);
    visit("held_out_share", held_out_share);
    visit("max_loss_increase", max_loss_increase);
    visit("ridge", ridge);
    visit("min_filter_share", rule.min_filter_share);
    visit("min_ring_strength", rule.min_ring_strength);
    visit("seed", seed);
  }
};

/// Features somebody might make do with, and what the classifier loses by it.
struct TestedHypothesis {
  std::string name = {};  ///< "all features", "dissertation 1: edge filters", "derived (raw) 2", …
  features::FeatureSpec spec = {};
  double log_loss = 0.0;  ///< held out
  double auc = 0.0;
  Estimate increase =
      {};  ///< of the log-loss above that of all features, 95 % over held-out objects
};

struct FeatureAnalysis {
  FeatureAnalysisOptions options = {};
  std::string data_fingerprint = {};
  std::size_t num_samples = 0;
  std::size_t num_fit_samples = 0;
  std::size_t num_held_out_samples = 0;
  std::size_t num_fit_objects = 0;
  std::size_t num_held_out_objects = 0;
  pca::Result pca = {};                           ///< of the raw features
  std::vector<EnergySpectrum> spectra = {};       ///< one a scaling
  BackwardElimination elimination = {};           ///< by filter: sets are filters
  std::vector<TestedHypothesis> hypotheses = {};  ///< all features first
};

/// Which filters and which window pixels matter: by the energy of their principal components, and
/// by what logistic regression loses without them on objects it has not seen. Hypotheses are
/// derived from these data (DeriveHypotheses; and by elimination, the fewest filters that cost at
/// most max_loss_increase) and tested beside the dissertation's three. Throws Error as DrawSamples,
/// ComputeEnergySpectrum and EliminateBackward do, and kBadInput for fewer than two objects, or
/// when either side lacks a class. Deterministic for any number of threads. Source: dissertation
/// section 3.2.1; docs/methods/feature_analysis.md.
[[nodiscard]] FeatureAnalysis AnalyseFeatures(const datasets::LabelledImageSet& set,
                                              const FeatureAnalysisOptions& options);

/// Where the features of `part` stand among those of `whole`, ascending. Throws std::logic_error
/// when one is missing there.
[[nodiscard]] std::vector<std::size_t> ColumnsOf(const features::FeatureSpec& part,
                                                 const features::FeatureSpec& whole);

}  // namespace handcraft::experiments
