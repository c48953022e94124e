// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lib/features/feature_spec.h"

namespace handcraft::tools {

/// The names of all features of a specification, in order.
[[nodiscard]] std::vector<std::string> FeatureNames(const features::FeatureSpec& spec);

/// The names at these indices as a list for a message, the first five of them: "a, b and 3 more".
[[nodiscard]] std::string FirstNames(const std::vector<std::size_t>& indices,
                                     const std::vector<std::string>& names);

}  // namespace handcraft::tools
