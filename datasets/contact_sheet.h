// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "lib/core/image.h"
#include "lib/core/progress.h"

/// Pictures of many pictures, to look a data set over. Each is scaled to fit its tile, three
/// quarters as high as wide, on black; colours are rounded to 32 levels, so that files stay small.
/// Same pictures, same bytes for any number of threads; Error for what cannot be read or drawn.
namespace handcraft::datasets {

/// A picture that a sheet may show.
struct SheetPicture {
  std::string row;         ///< pictures of the same name stand in one row: the class
  std::string split = {};  ///< train, test or any other name
  std::string caption;     ///< what a page writes under it
  /// The picture and what is known of it, side by side: as many for each of a set, in blue, green,
  /// red. Called at most once a sheet, from any thread.
  std::function<std::vector<Image>()> draw;
};

/// Those of one split and one class; an empty name takes all. Throws Error(kUsage) naming the ones
/// that there are when none is left.
[[nodiscard]] std::vector<SheetPicture> Choose(const std::vector<SheetPicture>& pictures,
                                               const std::string& split,
                                               const std::string& object_class);

struct OverviewOptions {
  int images_per_class = 2;  ///< at most this many of each row, evenly spread over it; 1 ... 100
  int tile_width_px = 128;   ///< 16 ... 640
  int num_threads = 1;
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// One sheet for all: a row for each name, in alphabetical order. Throws Error when there are no
/// pictures.
[[nodiscard]] Image DrawOverview(const std::vector<SheetPicture>& pictures,
                                 const OverviewOptions& options);

struct PageOptions {
  int page = 1;              ///< which, from 1
  int columns = 6;           ///< pictures side by side; 1 ... 100
  int rows = 8;              ///< 1 ... 100
  int tile_width_px = 160;   ///< 16 ... 640
  bool shows_first = false;  ///< beside the last picture that it draws the first: the whole
  int num_threads = 1;
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// How many pages of columns × rows hold so many pictures.
[[nodiscard]] int NumPages(std::size_t num_pictures, const PageOptions& options);

/// One page of all the pictures in their order, each with its labels alone (the last that it draws)
/// or with `shows_first` the whole picture before them, and its caption. Draws no picture but those
/// of the page, so a large set can be leafed through. Throws Error(kUsage) for a page that is not
/// there.
[[nodiscard]] Image DrawPage(const std::vector<SheetPicture>& pictures, const PageOptions& options);

}  // namespace handcraft::datasets
