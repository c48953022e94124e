// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/binary_labels.h"

#include <algorithm>
#include <string>

#include "lib/core/error.h"

namespace handcraft {

std::size_t CountPositive(std::span<const std::uint8_t> labels) {
  const auto wrong = std::find_if(labels.begin(), labels.end(), [](auto y) { return y > 1; });
  if (wrong != labels.end()) {
    throw Error({.kind = Error::Kind::kBadInput,
                 .reason = "label of row " + std::to_string(wrong - labels.begin()) +
                           " (counted from 0) is " + std::to_string(*wrong) + ": labels are 0 or 1",
                 .remedy = "map the two classes to 0 and 1"});
  }
  const auto count =
      static_cast<std::size_t>(std::count(labels.begin(), labels.end(), std::uint8_t{1}));
  if (count == 0 || count == labels.size()) {
    throw Error({.kind = Error::Kind::kBadInput,
                 .reason = "all " + std::to_string(labels.size()) + " labels are " +
                           (count == 0 ? "0" : "1") + ": there is nothing to tell apart",
                 .remedy = "add samples of the other class"});
  }
  return count;
}

}  // namespace handcraft
