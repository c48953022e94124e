// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/runner/cell_settings.h"

namespace handcraft::experiments {

/// Where pictures come from: a folder, or made to order.
struct DataSource {
  std::string folder = {};         ///< labelled image set; empty: made
  std::string family = "trained";  ///< of objects (docs/synthetic_data.md); of made pictures
  int num_images = 0;              ///< of made pictures, > 0
  std::uint64_t seed = 1;          ///< of made pictures
};

/// What stays together when pictures are divided into those to train on and those to test with.
enum class StudySplit {
  kInstance,  ///< all pictures of an object
  kClass,     ///< all pictures of a class
  kPicture,   ///< nothing
  kManifest,  ///< the splits "train" and "test" of the manifest
};

/// What a publication says of the methods, for the report to say whether it is so here.
struct Claim {
  std::string source;              ///< "Section 3.3.1"
  double worst_loss_points = 0.0;  ///< no method's accuracy is farther below the baseline's [%]
};

/// A study: data, how it is divided, the methods and factors whose every combination is a cell.
struct Study {
  std::string name;
  std::string title;
  std::string question = {};
  DataSource train;
  std::optional<DataSource> test = {};  ///< none: what training leaves of `train`
  StudySplit split = StudySplit::kInstance;
  std::uint64_t seed = 1;                  ///< of the first repetition; the next has the next
  int repetitions = 1;                     ///< each divides and draws anew
  std::size_t pixels_per_image = 4000;     ///< EvaluationOptions
  std::size_t bootstrap_resamples = 1000;  ///< EvaluationOptions
  std::vector<Setting> settings = {};      ///< of all cells, before their own
  std::vector<Method> methods = {};        ///< at least one
  std::vector<Factor> factors = {};
  std::string baseline = {};  ///< the method that others are compared with
  std::optional<Claim> claim = {};
};

/// Leaves out all methods but these, in the study's order. Throws Error(kUsage) for a name that is
/// none of them, which it lists, and when the baseline would be left out.
void KeepMethods(std::span<const std::string> names, Study& study);

/// One line an entry that results depend on, "key = value", in a fixed order: two studies that
/// agree in these give the same results on the same data. Title, question and claim are left out.
[[nodiscard]] std::vector<std::string> CanonicalLines(const Study& study);

}  // namespace handcraft::experiments
