// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/set_figures.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "datasets/formats/mask_picture.h"
#include "datasets/formats/organised_cloud.h"
#include "datasets/parallel_reporting.h"

namespace handcraft::datasets {
namespace {

std::size_t Count(const Image& mask, std::uint8_t value) {
  const auto& values = mask.values();
  return static_cast<std::size_t>(std::count(values.begin(), values.end(), value));
}

std::string SizeText(const Image& mask) {
  return std::to_string(mask.width()) + "x" + std::to_string(mask.height());
}

LabelFigures FiguresOf(const LabelledImage& item, const Image& mask) {
  return {.images = 1,
          .instances = {item.instance},
          .pixels = mask.values().size(),
          .good = Count(mask, kMaskGood),
          .bad = Count(mask, kMaskBad)};
}

ViewFigures FiguresOf(const ViewSet& set, const ObjectView& item, const Image& mask) {
  ViewFigures figures{.views = 1, .instances = {item.instance}, .angles_deg = {}};
  if (item.angle_deg) {
    figures.angles_deg.insert(*item.angle_deg);
  } else {
    figures.views_without_angle = 1;
  }
  figures.pixels = mask.values().size();
  figures.object_pixels = Count(mask, kObject);
  if (item.cloud.empty()) return figures;
  const OrganisedCloud cloud = ReadCloudOfPicture(set.root / item.cloud, SizeOf(mask));
  figures.clouds = 1;
  figures.cloud_object_pixels = figures.object_pixels;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (mask.values()[i] == kObject && IsMeasured(cloud.points[i])) ++figures.measured;
  }
  return figures;
}

// A picture's figures, and its size.
template <class Figures>
using Counted = std::pair<Figures, std::string>;

// Counts picture by picture, then adds up in the set's order.
template <class Figures, class Set>
SetFigures<Figures> AddUp(const Set& set,
                          int num_threads,
                          const Progress& progress,
                          const std::function<Counted<Figures>(std::size_t)>& count) {
  std::vector<Counted<Figures>> counted(set.items.size());
  ParallelForReporting(
      set.items.size(), num_threads, progress, "reading masks", [&](std::size_t i) {
        counted[i] = count(i);
      });
  SetFigures<Figures> figures;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    const auto& [of_item, size] = counted[i];
    SplitFigures<Figures>& split = figures.splits[set.items[i].split];
    split.all += of_item;
    split.by_class[set.items[i].object_class] += of_item;
    ++figures.sizes[size];
    figures.licences.insert(set.items[i].licence);
  }
  return figures;
}

template <class Set>
std::map<std::string, PoseFigures> CountRows(const Set& set) {
  std::map<std::string, std::map<std::string, std::size_t>> rows_of_view;
  std::map<std::string, PoseFigures> figures;
  for (const auto& item : set.items) {
    ++rows_of_view[item.object_class][item.view];
    figures[item.object_class].instances.insert(item.instance);
  }
  for (const auto& [object_class, views] : rows_of_view) {
    for (const auto& [view, rows] : views) {
      figures[object_class] += {.poses = rows,
                                .instances = {},
                                .views = 1,
                                .least_per_view = rows,
                                .most_per_view = rows};
    }
  }
  return figures;
}

}  // namespace

LabelFigures& LabelFigures::operator+=(const LabelFigures& other) {
  images += other.images;
  instances.insert(other.instances.begin(), other.instances.end());
  pixels += other.pixels;
  good += other.good;
  bad += other.bad;
  return *this;
}

ViewFigures& ViewFigures::operator+=(const ViewFigures& other) {
  views += other.views;
  instances.insert(other.instances.begin(), other.instances.end());
  angles_deg.insert(other.angles_deg.begin(), other.angles_deg.end());
  views_without_angle += other.views_without_angle;
  pixels += other.pixels;
  object_pixels += other.object_pixels;
  clouds += other.clouds;
  cloud_object_pixels += other.cloud_object_pixels;
  measured += other.measured;
  return *this;
}

PoseFigures& PoseFigures::operator+=(const PoseFigures& other) {
  poses += other.poses;
  instances.insert(other.instances.begin(), other.instances.end());
  views += other.views;
  least_per_view = std::min(least_per_view, other.least_per_view);
  most_per_view = std::max(most_per_view, other.most_per_view);
  return *this;
}

SetFigures<LabelFigures> CountFigures(const LabelledImageSet& set,
                                      int num_threads,
                                      const Progress& progress) {
  return AddUp<LabelFigures>(
      set, num_threads, progress, [&](std::size_t i) -> Counted<LabelFigures> {
        const Image mask = ReadLabelledPicture(set, i).mask;
        return {FiguresOf(set.items[i], mask), SizeText(mask)};
      });
}

SetFigures<ViewFigures> CountFigures(const ViewSet& set,
                                     int num_threads,
                                     const Progress& progress) {
  return AddUp<ViewFigures>(set, num_threads, progress, [&](std::size_t i) -> Counted<ViewFigures> {
    const Image mask = ReadObjectMask(set, i);
    return {FiguresOf(set, set.items[i], mask), SizeText(mask)};
  });
}

std::map<std::string, PoseFigures> CountPoses(const DemonstrationSet& set) {
  return CountRows(set);
}

std::map<std::string, PoseFigures> CountPoses(const HoldSet& set) { return CountRows(set); }

}  // namespace handcraft::datasets
