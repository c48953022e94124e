// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "datasets/formats/labelled_image_set.h"
#include "experiments/feature_analysis/feature_analysis.h"

namespace handcraft::experiments {

inline datasets::LabelledImageSet SampleSet() {
  return datasets::ReadLabelledImageSet(std::string(HANDCRAFT_SOURCE_DIR) +
                                        "/datasets/samples/cornell_mini")
      .Only("test");
}

/// Three filters on the pictures of the sample set that are for tests, few pixels.
inline FeatureAnalysisOptions SmallOptions() {
  FeatureAnalysisOptions options;
  options.spec = features::ParseFeatureSpec("filters=laws_LL+edge_0+edge_90,window=3");
  options.num_samples = 600;
  options.num_classifier_samples = 600;
  return options;
}

/// Numbers made up by hand for two filters and a window of one pixel: what pages and figures show.
inline FeatureAnalysis HandFilledAnalysis() {
  FeatureAnalysis analysis;
  analysis.options.spec = features::ParseFeatureSpec("filters=laws_LL+edge_0,window=1");
  analysis.data_fingerprint = "abc";
  analysis.num_samples = 1000;
  analysis.num_fit_samples = 70;
  analysis.num_held_out_samples = 30;
  analysis.num_fit_objects = 7;
  analysis.num_held_out_objects = 3;
  analysis.pca.num_features = 2;
  analysis.spectra = {{.scaling = FeatureScaling::kRaw,
                       .eigenvalues = {100.0, 1.0},
                       .first_component = {1.0, 0.0},
                       .num_components = {1, 1, 1},
                       .filter_shares = {0.99, 0.01},
                       .position_shares = {1.0},
                       .ring_strengths = {1.0}},
                      {.scaling = FeatureScaling::kStandard,
                       .eigenvalues = {1.5, 0.5},
                       .first_component = {0.6, -0.8},
                       .num_components = {2, 2, 2},
                       .filter_shares = {0.4, 0.6},
                       .position_shares = {1.0},
                       .ring_strengths = {1.0}}};
  analysis.elimination.all.log_loss = 0.5;
  analysis.elimination.all.auc = 0.8;
  analysis.elimination.order = {0, 1};
  analysis.elimination.steps = {{.removed = 0,
                                 .log_loss = 0.52,
                                 .auc = 0.79,
                                 .increase = {0.02, -0.01, 0.05},
                                 .num_columns = 1}};
  analysis.hypotheses = {{.name = "all features",
                          .spec = analysis.options.spec,
                          .log_loss = 0.5,
                          .auc = 0.8,
                          .increase = {0.0, 0.0, 0.0}},
                         {.name = "energy, raw, 1: filters",
                          .spec = features::ParseFeatureSpec("filters=laws_LL,window=1"),
                          .log_loss = 0.61,
                          .auc = 0.7,
                          .increase = {0.11, 0.02, 0.2}}};
  return analysis;
}

}  // namespace handcraft::experiments
