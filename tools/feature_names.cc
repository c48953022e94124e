// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/feature_names.h"

#include <algorithm>

namespace handcraft::tools {

std::vector<std::string> FeatureNames(const features::FeatureSpec& spec) {
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(spec.NumFeatures()));
  for (int i = 0; i < spec.NumFeatures(); ++i) names.push_back(features::FeatureName(spec, i));
  return names;
}

std::string FirstNames(const std::vector<std::size_t>& indices,
                       const std::vector<std::string>& names) {
  constexpr std::size_t kMaxNamesShown = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(indices.size(), kMaxNamesShown); ++i) {
    text += (i > 0 ? ", " : "") + names.at(indices[i]);
  }
  if (indices.size() > kMaxNamesShown) {
    text += " and " + std::to_string(indices.size() - kMaxNamesShown) + " more";
  }
  return text;
}

}  // namespace handcraft::tools
