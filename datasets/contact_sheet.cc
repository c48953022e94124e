// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/contact_sheet.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/perception/overlay.h"

namespace handcraft::datasets {
namespace {

// Which pictures of each class are shown.
std::map<std::string, std::vector<std::size_t>> ChooseByClass(const LabelledImageSet& set,
                                                              std::size_t count) {
  std::map<std::string, std::vector<std::size_t>> by_class;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    by_class[set.items[i].object_class].push_back(i);
  }
  for (auto& [name, indices] : by_class) {
    std::vector<std::size_t> chosen;
    const std::size_t num_chosen = std::min(count, indices.size());
    chosen.reserve(num_chosen);
    for (std::size_t i = 0; i < num_chosen; ++i) {
      chosen.push_back(indices[i * indices.size() / num_chosen]);
    }
    indices = std::move(chosen);
  }
  return by_class;
}

// Scales a picture in colour into its tile, whose corner is at (left, top).
void PlaceTile(const Image& picture, cv::Mat& sheet, const cv::Rect& tile) {
  // OpenCV takes no pointer to const, but only reads.
  const cv::Mat pixels(
      picture.height(), picture.width(), CV_8UC3, const_cast<std::uint8_t*>(picture.Row(0)));
  const double scale = std::min(static_cast<double>(tile.width) / picture.width(),
                                static_cast<double>(tile.height) / picture.height());
  const cv::Size size(std::max(cvRound(scale * picture.width()), 1),
                      std::max(cvRound(scale * picture.height()), 1));
  const cv::Rect place(tile.x + (tile.width - size.width) / 2,
                       tile.y + (tile.height - size.height) / 2,
                       size.width,
                       size.height);
  cv::Mat target = sheet(place);
  cv::resize(pixels, target, size, 0.0, 0.0, cv::INTER_AREA);
}

void RoundColours(Image& sheet) {
  constexpr int kStep = 8;
  for (int v = 0; v < sheet.height(); ++v) {
    std::uint8_t* const row = sheet.Row(v);
    for (int i = 0; i < sheet.width() * sheet.channels(); ++i) {
      row[i] = static_cast<std::uint8_t>(row[i] / kStep * kStep + kStep / 2);
    }
  }
}

}  // namespace

void ContactSheetOptions::Validate() const {
  RequireOption(images_per_class >= 1 && images_per_class <= 100,
                "ContactSheetOptions.images_per_class",
                images_per_class,
                "from 1 to 100");
  RequireOption(tile_width_px >= 16 && tile_width_px <= 640,
                "ContactSheetOptions.tile_width_px",
                tile_width_px,
                "from 16 to 640");
}

Image MakeContactSheet(const LabelledImageSet& set, const ContactSheetOptions& options) {
  options.Validate();
  if (set.items.empty()) {
    throw Error({.path = set.root.string(), .reason = "the set has no pictures to show"});
  }
  const auto by_class = ChooseByClass(set, static_cast<std::size_t>(options.images_per_class));
  std::size_t columns = 0;
  for (const auto& [name, indices] : by_class) columns = std::max(columns, indices.size());
  const int width = options.tile_width_px;
  const int height = width * 3 / 4;
  Image sheet(2 * width * static_cast<int>(columns), height * static_cast<int>(by_class.size()), 3);
  cv::Mat pixels(sheet.height(), sheet.width(), CV_8UC3, sheet.Row(0));
  int row = 0;
  for (const auto& [name, indices] : by_class) {
    Report(options.progress, "drawing classes", static_cast<std::size_t>(row), by_class.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const LabelledPicture picture = ReadLabelledPicture(set, indices[i]);
      const cv::Rect tile(2 * width * static_cast<int>(i), height * row, width, height);
      const Image unlabelled(picture.mask.width(), picture.mask.height());
      PlaceTile(perception::DrawLabelMask(picture.image, unlabelled), pixels, tile);
      PlaceTile(perception::DrawLabelMask(picture.image, picture.mask),
                pixels,
                tile + cv::Point(width, 0));
    }
    ++row;
  }
  RoundColours(sheet);
  return sheet;
}

}  // namespace handcraft::datasets
