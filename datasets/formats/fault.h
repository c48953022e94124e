// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace handcraft::datasets {

/// Something wrong with a data set, and the file that it is wrong with.
struct Fault {
  std::string path;  ///< relative to the set's folder
  std::string reason;
};

}  // namespace handcraft::datasets
