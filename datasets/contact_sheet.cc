// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/contact_sheet.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "datasets/parallel_reporting.h"
#include "lib/core/check.h"
#include "lib/core/counted.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/perception/image_header.h"

namespace handcraft::datasets {
namespace {

constexpr int kCaptionPx = 16;
constexpr int kGapPx = 4;

// A part of a sheet that a picture is scaled into.
struct Tile {
  int left = 0;
  int top = 0;
  int width = 0;

  [[nodiscard]] int Height() const { return width * 3 / 4; }
};

// Throws Error for a sheet larger than a picture may be.
Image BlackSheet(int width, int height) {
  if (width > perception::kMaxImageSide_px || height > perception::kMaxImageSide_px ||
      width > perception::kMaxImagePixels / height) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = fmt::format("a sheet of {}x{} pixels is too large", width, height),
                 .remedy = "show fewer pictures, or smaller ones"});
  }
  return {width, height, 3};
}

cv::Mat Pixels(Image& image) { return {image.height(), image.width(), CV_8UC3, image.Row(0)}; }

void Place(const Image& picture, const Tile& tile, Image& sheet) {
  HC_CHECK(picture.channels() == 3 && !picture.empty(), picture.channels(), picture.width());
  // OpenCV takes no pointer to const, but only reads.
  const cv::Mat pixels(
      picture.height(), picture.width(), CV_8UC3, const_cast<std::uint8_t*>(picture.Row(0)));
  const double scale = std::min(static_cast<double>(tile.width) / picture.width(),
                                static_cast<double>(tile.Height()) / picture.height());
  const cv::Size size(std::max(cvRound(scale * picture.width()), 1),
                      std::max(cvRound(scale * picture.height()), 1));
  cv::Mat target = Pixels(sheet)(cv::Rect(tile.left + (tile.width - size.width) / 2,
                                          tile.top + (tile.Height() - size.height) / 2,
                                          size.width,
                                          size.height));
  cv::resize(pixels, target, size, 0.0, 0.0, cv::INTER_AREA);
}

// OpenCV's letters are ASCII; of a longer text the end tells more than the beginning.
void WriteCaption(std::string text, const cv::Rect& place, Image& sheet) {
  constexpr double kFontScale = 0.35;
  constexpr int kLetterPx = 7;  // the widest letter at that scale
  const auto room = static_cast<std::size_t>(std::max(place.width / kLetterPx, 2));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  if (text.size() > room) text = ".." + text.substr(text.size() - (room - 2));
  cv::Mat strip = Pixels(sheet)(place);
  cv::putText(strip,
              text,
              {1, kCaptionPx - 5},
              cv::FONT_HERSHEY_SIMPLEX,
              kFontScale,
              cv::Scalar::all(220),
              1,
              cv::LINE_AA);
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

// The pictures of each row that are shown.
std::map<std::string_view, std::vector<const SheetPicture*>> ChooseByRow(
    const std::vector<SheetPicture>& pictures, std::size_t count) {
  std::map<std::string_view, std::vector<const SheetPicture*>> rows;
  for (const SheetPicture& picture : pictures) rows[picture.row].push_back(&picture);
  for (auto& [name, row] : rows) {
    std::vector<const SheetPicture*> chosen;
    const std::size_t num_chosen = std::min(count, row.size());
    for (std::size_t i = 0; i < num_chosen; ++i) chosen.push_back(row[i * row.size() / num_chosen]);
    row = std::move(chosen);
  }
  return rows;
}

// Those whose field has this value; all when it is empty.
std::vector<SheetPicture> Keep(const std::vector<SheetPicture>& pictures,
                               std::string SheetPicture::*field,
                               std::string_view what,
                               const std::string& value) {
  if (value.empty()) return pictures;
  std::vector<SheetPicture> kept;
  std::set<std::string> values;
  for (const SheetPicture& picture : pictures) {
    values.insert("'" + picture.*field + "'");
    if (picture.*field == value) kept.push_back(picture);
  }
  if (kept.empty()) {
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = fmt::format("no {} '{}'; there are: {}", what, value, fmt::join(values, ", "))});
  }
  return kept;
}

void RequireTileWidth(const std::string& field, int width_px) {
  RequireOption(width_px >= 16 && width_px <= 640, field, width_px, "from 16 to 640");
}

void RequireUpTo100(const std::string& field, int value) {
  RequireOption(value >= 1 && value <= 100, field, value, "from 1 to 100");
}

// The pictures of a page.
struct PageRange {
  std::size_t first = 0;
  std::size_t count = 0;
};

// Throws Error for a page that is not there.
PageRange PicturesOf(const PageOptions& options, std::size_t num_pictures) {
  const int num_pages = NumPages(num_pictures, options);
  if (options.page > num_pages) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = fmt::format("no page {}; the last is page {} ({}, {} a page)",
                                       options.page,
                                       num_pages,
                                       Counted(num_pictures, "picture"),
                                       options.columns * options.rows)});
  }
  const auto per_page = static_cast<std::size_t>(options.columns * options.rows);
  const std::size_t first = per_page * static_cast<std::size_t>(options.page - 1);
  return {first, std::min(per_page, num_pictures - first)};
}

// Where things stand on a page: a cell a picture, tiles above and the caption below.
class PageCells {
 public:
  explicit PageCells(const PageOptions& options)
      : columns_(options.columns),
        tile_width_px_(options.tile_width_px),
        width_px_(options.tile_width_px * (options.shows_first ? 2 : 1)) {}

  [[nodiscard]] Image SheetFor(std::size_t count) const {
    const int num_cells = static_cast<int>(count);
    const int num_rows = (num_cells + columns_ - 1) / columns_;
    return BlackSheet((width_px_ + kGapPx) * std::min(columns_, num_cells), Height() * num_rows);
  }

  [[nodiscard]] Tile FirstTile(std::size_t index) const {
    const int i = static_cast<int>(index);
    return {.left = (width_px_ + kGapPx) * (i % columns_),
            .top = Height() * (i / columns_),
            .width = tile_width_px_};
  }

  [[nodiscard]] cv::Rect Caption(std::size_t index) const {
    const Tile tile = FirstTile(index);
    return {tile.left, tile.top + tile.Height(), width_px_, kCaptionPx};
  }

 private:
  [[nodiscard]] int Height() const {
    return Tile{.width = tile_width_px_}.Height() + kCaptionPx + kGapPx;
  }

  int columns_ = 1;
  int tile_width_px_ = 0;
  int width_px_ = 0;  // of what a cell shows
};

}  // namespace

std::vector<SheetPicture> Choose(const std::vector<SheetPicture>& pictures,
                                 const std::string& split,
                                 const std::string& object_class) {
  return Keep(Keep(pictures, &SheetPicture::split, "split", split),
              &SheetPicture::row,
              "class",
              object_class);
}

void OverviewOptions::Validate() const {
  RequireUpTo100("OverviewOptions.images_per_class", images_per_class);
  RequireTileWidth("OverviewOptions.tile_width_px", tile_width_px);
  RequireOption(num_threads >= 1, "OverviewOptions.num_threads", num_threads, "1 or more");
}

Image DrawOverview(const std::vector<SheetPicture>& pictures, const OverviewOptions& options) {
  options.Validate();
  if (pictures.empty()) throw Error({.reason = "the set has no pictures to show"});
  const auto rows = ChooseByRow(pictures, static_cast<std::size_t>(options.images_per_class));
  std::vector<std::pair<const SheetPicture*, Tile>> places;  // of each the first of its tiles
  std::size_t most = 0;
  int top = 0;
  for (const auto& [name, row] : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      places.push_back({row[i], {static_cast<int>(i), top, options.tile_width_px}});
    most = std::max(most, row.size());
    top += places.back().second.Height();
  }
  const std::vector<Image> first = places.front().first->draw();
  const int tiles_each = static_cast<int>(first.size());
  Image sheet = BlackSheet(options.tile_width_px * tiles_each * static_cast<int>(most), top);
  const auto draw = [&](std::size_t i) {  // tiles do not overlap, so threads may draw at once
    Tile tile = places[i].second;
    tile.left *= tiles_each * tile.width;
    const std::vector<Image> drawn = i == 0 ? first : places[i].first->draw();
    for (const Image& picture : drawn) {
      Place(picture, tile, sheet);
      tile.left += tile.width;
    }
  };
  ParallelForReporting(
      places.size(), options.num_threads, options.progress, "drawing pictures", draw);
  RoundColours(sheet);
  return sheet;
}

void PageOptions::Validate() const {
  RequireOption(page >= 1, "PageOptions.page", page, "1 or more");
  RequireUpTo100("PageOptions.columns", columns);
  RequireUpTo100("PageOptions.rows", rows);
  RequireTileWidth("PageOptions.tile_width_px", tile_width_px);
  RequireOption(num_threads >= 1, "PageOptions.num_threads", num_threads, "1 or more");
}

int NumPages(std::size_t num_pictures, const PageOptions& options) {
  const auto per_page = static_cast<std::size_t>(options.columns * options.rows);
  return static_cast<int>((num_pictures + per_page - 1) / per_page);
}

Image DrawPage(const std::vector<SheetPicture>& pictures, const PageOptions& options) {
  options.Validate();
  const PageRange shown = PicturesOf(options, pictures.size());
  const PageCells cells(options);
  Image sheet = cells.SheetFor(shown.count);
  const auto draw = [&](std::size_t i) {
    const SheetPicture& picture = pictures[shown.first + i];
    const std::vector<Image> drawn = picture.draw();
    Tile tile = cells.FirstTile(i);
    if (options.shows_first) {
      Place(drawn.front(), tile, sheet);
      tile.left += tile.width;
    }
    Place(drawn.back(), tile, sheet);
    WriteCaption(picture.caption, cells.Caption(i), sheet);
  };
  ParallelForReporting(
      shown.count, options.num_threads, options.progress, "drawing pictures", draw);
  RoundColours(sheet);
  return sheet;
}

}  // namespace handcraft::datasets
