// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/view_set.h"

namespace handcraft::datasets {

/// A split and the share of the pictures that it is to have.
struct SplitShare {
  std::string name;
  double share = 0.0;
};

/// What stays together.
enum class SplitGroup {
  kInstance,  ///< all pictures of an object: the model is tested on other objects of known classes
  kClass,     ///< all pictures of a class: the model is tested on classes that it has not seen
  kPicture,   ///< nothing: tested on other pictures of objects seen; no list of files may say so
};

struct SplitOptions {
  std::vector<SplitShare> shares = {{"train", 0.7}, {"test", 0.3}};  ///< sum: 1 to within 1e−6
  SplitGroup group = SplitGroup::kInstance;
  std::uint64_t seed = 1;

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Gives each picture's `split` anew. Groups are shuffled and walked through class by class; each
/// goes to the split that would stay farthest behind its share of the pictures walked through,
///   arg max over s of share_s · n − n_s,
/// n with the group's own pictures and n_s without them, ties to the split named first. So every
/// class is spread like the whole, as evenly as the sizes of its groups allow. An instance that is
/// in several classes counts to that of its first picture. Throws Error when a split would be left
/// without pictures. Same set, options and seed, same splits, whatever the order of the manifest.
void AssignSplits(LabelledImageSet& set, const SplitOptions& options);
void AssignSplits(ViewSet& set, const SplitOptions& options);

}  // namespace handcraft::datasets
