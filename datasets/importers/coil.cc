// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/coil.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <regex>
#include <string>

#include "datasets/importers/object_mask.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr int kLastStep = 71;

}  // namespace

void CoilOptions::Validate() const {
  RequireOption(
      threshold >= 0 && threshold <= 255, "CoilOptions.threshold", threshold, "from 0 to 255");
}

SourceSet ListCoil(const fs::path& source, const CoilOptions& options) {
  options.Validate();
  static const std::regex kPattern("(obj[0-9]+)__([0-9]{1,3})");
  const auto threshold = static_cast<std::uint8_t>(options.threshold);
  SourceSet set;
  int last = 0;
  for (const fs::path& file : ListFiles(source, std::numeric_limits<int>::max())) {
    const std::string stem = file.stem().string();
    std::smatch match;
    if (!IsNamedLikeAPicture(file) || !std::regex_match(stem, match, kPattern)) continue;
    const int number = std::stoi(match[2]);
    last = std::max(last, number);
    const fs::path relative = file.lexically_relative(source);
    set.pictures.push_back({.path = file,
                            .image = relative.generic_string(),
                            .mask = fs::path(relative).replace_extension(".png").generic_string(),
                            .object_class = match[1],
                            .instance = match[1],
                            .angle_deg = number,
                            .make_mask = [file, threshold](int, int) {
                              return MaskBeforeDarkness(perception::ReadImage(file), threshold);
                            }});
  }
  if (set.pictures.empty()) {
    throw Error({.path = source.string(),
                 .reason = "no objN__K.png in it",
                 .remedy = "give the folder of the unpacked pictures"});
  }
  for (SourcePicture& picture : set.pictures) {
    constexpr double kStep_deg = 5.0;
    picture.angle_deg = std::fmod(*picture.angle_deg * (last > kLastStep ? 1.0 : kStep_deg), 360.0);
  }
  return set;
}

}  // namespace handcraft::datasets
