// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/hold_set.h"
#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/view_set.h"
#include "lib/core/progress.h"

/// What `handcraft data info` tells of a data set.
namespace handcraft::datasets {

/// Of labelled pictures.
struct LabelFigures {
  std::size_t images = 0;
  std::set<std::string> instances;
  std::size_t pixels = 0;
  std::size_t good = 0;  ///< pixels
  std::size_t bad = 0;   ///< pixels

  LabelFigures& operator+=(const LabelFigures& other);
};

/// Of views.
struct ViewFigures {
  std::size_t views = 0;
  std::set<std::string> instances;
  std::set<double> angles_deg;  ///< each that is listed
  std::size_t views_without_angle = 0;
  std::size_t pixels = 0;
  std::size_t object_pixels = 0;
  std::size_t clouds = 0;               ///< views that have one
  std::size_t cloud_object_pixels = 0;  ///< object pixels of these views
  std::size_t measured = 0;             ///< of them, those that were measured

  ViewFigures& operator+=(const ViewFigures& other);
};

/// Of a split: all of it, and each class.
template <class Figures>
struct SplitFigures {
  Figures all;
  std::map<std::string, Figures> by_class;
};

/// Of a set: each split; how many pictures there are of each size, "64x48"; licences, each once.
template <class Figures>
struct SetFigures {
  std::map<std::string, SplitFigures<Figures>> splits;
  std::map<std::string, std::size_t> sizes;
  std::set<std::string> licences;
};

/// Reads every picture with its mask. Throws Error for what cannot be read or does not fit. The
/// number of threads changes nothing.
[[nodiscard]] SetFigures<LabelFigures> CountFigures(const LabelledImageSet& set,
                                                    int num_threads = 1,
                                                    const Progress& progress = {});

/// The same of a view set; of each view its object mask and its cloud are read, and no picture.
[[nodiscard]] SetFigures<ViewFigures> CountFigures(const ViewSet& set,
                                                   int num_threads = 1,
                                                   const Progress& progress = {});

/// Of the poses shown for a class, or the holds of it.
struct PoseFigures {
  std::size_t poses = 0;  ///< rows
  std::set<std::string> instances;
  std::size_t views = 0;  ///< with a pose
  std::size_t least_per_view = std::numeric_limits<std::size_t>::max();
  std::size_t most_per_view = 0;

  PoseFigures& operator+=(const PoseFigures& other);
};

/// The figures by class.
[[nodiscard]] std::map<std::string, PoseFigures> CountPoses(const DemonstrationSet& set);
[[nodiscard]] std::map<std::string, PoseFigures> CountPoses(const HoldSet& set);

}  // namespace handcraft::datasets
