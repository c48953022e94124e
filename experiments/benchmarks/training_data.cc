// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/training_data.h"

#include <stdlib.h>

#include <string>
#include <system_error>

#include "experiments/benchmarks/turned_pictures.h"
#include "lib/core/error.h"
#include "lib/core/parallel.h"
#include "lib/features/feature_spec.h"

namespace handcraft::experiments {

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "handcraft-").string();
  name += std::string(6, 'X');  // mkdtemp fills in
  if (::mkdtemp(name.data()) == nullptr) {
    throw Error({.path = name,
                 .reason = "cannot make a folder there",
                 .remedy = "set TMPDIR to a folder that can be written"});
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

TrainingData::TrainingData(const BenchmarkOptions& options,
                           std::size_t num_samples,
                           const std::filesystem::path& scratch)
    : sampling_{.num_samples = num_samples,
                .num_threads = NumHardwareThreads(),
                .progress = options.progress},
      pictures_(WriteTurnedPictures(
          datasets::ReadLabelledImageSet(options.dataset), (num_samples + 1) / 2, scratch)),
      pixels_(datasets::DrawSamples(pictures_, sampling_)) {}

datasets::GraspPointSamples TrainingData::FeaturesOf(const char* specification) const {
  return datasets::ComputeSampleFeatures(
      pictures_, pixels_, features::ParseFeatureSpec(specification), sampling_);
}

}  // namespace handcraft::experiments
