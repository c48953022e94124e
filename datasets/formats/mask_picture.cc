// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/mask_picture.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "lib/core/error.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

// "255 (good), 0 (bad) or 128 (don't care)"
std::string Listed(std::span<const MaskValue> values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += i + 1 == values.size() ? " or " : ", ";
    text += std::to_string(values[i].value);
    text.append(" (").append(values[i].meaning).append(")");
  }
  return text;
}

}  // namespace

Image ReadMaskPicture(const fs::path& path, std::span<const MaskValue> values) {
  Image mask = perception::ReadImage(path, perception::Channels::kGray);
  std::array<bool, 256> is_due{};
  for (const MaskValue& value : values) is_due[value.value] = true;
  const auto& pixels = mask.values();
  const auto other =
      std::find_if(pixels.begin(), pixels.end(), [&](std::uint8_t v) { return !is_due[v]; });
  if (other == pixels.end()) return mask;
  const auto at = static_cast<int>(other - pixels.begin());
  throw Error({.path = path.string(),
               .reason = "value " + std::to_string(*other) + " at column " +
                         std::to_string(at % mask.width()) + ", row " +
                         std::to_string(at / mask.width()) + "; " + Listed(values) + " is due",
               .remedy = "save the mask without smoothing, as PNG"});
}

Image ReadObjectMask(const fs::path& path) {
  static constexpr std::array<MaskValue, 2> kValues = {
      {{kObject, "object"}, {kNoObject, "something else"}}};
  return ReadMaskPicture(path, kValues);
}

void RequireSameSize(const fs::path& path,
                     std::string_view what,
                     const PixelSize& size,
                     const PixelSize& picture_size) {
  if (size == picture_size) return;
  const auto text = [](const PixelSize& pixels) {
    return std::to_string(pixels[0]) + "x" + std::to_string(pixels[1]);
  };
  throw Error({.path = path.string(),
               .reason = std::string(what) + " is " + text(size) + " pixels, its picture " +
                         text(picture_size)});
}

}  // namespace handcraft::datasets
