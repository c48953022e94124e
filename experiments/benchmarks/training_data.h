// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "datasets/grasp_point_samples.h"
#include "experiments/benchmarks/benchmark.h"

namespace handcraft::experiments {

/// A folder for files in between; goes with the object. Throws Error when it cannot be made.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

/// The pixels that the training benchmarks draw (from the pictures of options.dataset and as many
/// of their mirror images as it takes), and their features for any specification.
class TrainingData {
 public:
  TrainingData(const BenchmarkOptions& options,
               std::size_t num_samples,
               const std::filesystem::path& scratch);

  [[nodiscard]] datasets::GraspPointSamples FeaturesOf(const char* specification) const;

 private:
  datasets::SamplingOptions sampling_;
  datasets::LabelledImageSet pictures_;
  std::vector<datasets::PixelSample> pixels_;
};

}  // namespace handcraft::experiments
