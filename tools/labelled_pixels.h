// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>

#include <CLI/App.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/grasp_point_samples.h"
#include "lib/features/feature_spec.h"
#include "tools/console.h"

namespace handcraft::tools {

/// Which labelled pixels of an image set a command takes, and as which features.
struct LabelledPixelsOptions {
  std::string dataset;
  std::string features = "all500,energy=log";
  std::string split = "train";
  datasets::SamplingOptions sampling;
};

/// Adds DATASET, --features, --split, --seed, --threads and the group "Sampling".
void AddLabelledPixelsOptions(CLI::App& command, LabelledPixelsOptions& options);

/// Throws Error(kUsage) that names an option given to `command` though nothing reads it, for
/// --samples 0 takes every pixel.
void RefuseUnreadOptions(const CLI::App& command, const LabelledPixelsOptions& options);

struct LabelledPixels {
  features::FeatureSpec spec;
  datasets::LabelledImageSet set;  ///< the images of the split
  std::size_t num_images = 0;      ///< of them, those that gave samples
  datasets::GraspPointSamples samples;
};

/// Draws the pixels and computes their features, with a progress bar. Warns of images left out and
/// of fewer samples than were asked for. Throws Error as DrawSamples does.
[[nodiscard]] LabelledPixels DrawLabelledPixels(const LabelledPixelsOptions& options,
                                                const datasets::LabelledImageSet& whole_set,
                                                const Console& console);

}  // namespace handcraft::tools
