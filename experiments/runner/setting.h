// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace handcraft::experiments {

/// A setting of a cell as a study writes it: "samples" and "20000".
struct Setting {
  std::string key;
  std::string value;
  bool operator==(const Setting&) const = default;
};

/// A named bundle of settings that belong together: what the columns of a figure compare.
struct Method {
  std::string name;
  std::vector<Setting> settings;
};

/// A setting that takes each of its values in turn, with every method and every other factor.
struct Factor {
  std::string key;
  std::vector<std::string> values;
};

}  // namespace handcraft::experiments
