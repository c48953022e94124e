// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string_view>

namespace handcraft::experiments {

/// A study that comes with the program: experiments/studies/NAME/study.toml, which travels inside
/// the library so that it runs from any folder.
struct ShippedStudy {
  std::string_view name;
  std::string_view text;  ///< of its study file
};

/// All of them, by name.
[[nodiscard]] std::span<const ShippedStudy> ShippedStudies();

/// The one of this name; null when there is none.
[[nodiscard]] const ShippedStudy* FindShippedStudy(std::string_view name);

}  // namespace handcraft::experiments
