// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/cloud_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "datasets/formats/listing_rules.h"
#include "datasets/parallel_reporting.h"
#include "lib/core/error.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

constexpr float kDepthUnitM = 0.001F;

// What is known of one or more views.
struct Errors {
  std::size_t num_views = 0;
  std::size_t num_pixels = 0;
  std::vector<float> errors_m;           // of the measured ones
  std::vector<float> textured_errors_m;  // of these with texture about them

  void Add(const Errors& other) {
    num_views += other.num_views;
    num_pixels += other.num_pixels;
    errors_m.insert(errors_m.end(), other.errors_m.begin(), other.errors_m.end());
    textured_errors_m.insert(
        textured_errors_m.end(), other.textured_errors_m.begin(), other.textured_errors_m.end());
  }
};

// Half the difference of the pixel's neighbours in its row, the mean of the channels; 0 at the
// ends.
double RowGradient(const Image& image, int u, int v) {
  if (u < 1 || u + 1 >= image.width()) return 0.0;
  int difference = 0;
  for (int c = 0; c < image.channels(); ++c)
    difference += image.At(u + 1, v, c) - image.At(u - 1, v, c);
  return difference / (2.0 * image.channels());
}

bool IsTextured(const Image& image, int u, int v) {
  constexpr int kRadius = 2;
  double sum = 0.0;
  int count = 0;
  for (int y = std::max(v - kRadius, 0); y <= std::min(v + kRadius, image.height() - 1); ++y) {
    for (int x = std::max(u - kRadius, 0); x <= std::min(u + kRadius, image.width() - 1); ++x) {
      const double gradient = RowGradient(image, x, y);
      sum += gradient * gradient;
      ++count;
    }
  }
  return sum >= kTexturedGradient * kTexturedGradient * count;
}

Errors ErrorsOf(const ViewSet& set, std::size_t index) {
  const ObjectView& item = set.items[index];
  const std::string list = (set.root / kViewsFileName).string();
  if (item.cloud.empty())
    throw Error({.path = list, .reason = "'" + item.image + "' has no cloud"});
  if (item.depth.empty())
    throw Error({.path = list, .reason = "'" + item.image + "' has no true depth"});
  const LoadedView view = ReadView(set, index);
  const BasicImage<std::uint16_t> depth = perception::ReadImage16(set.root / item.depth);
  RequireSameSize(set.root / item.depth, "the depth", SizeOf(depth), SizeOf(view.image));
  const Eigen::Isometry3f camera_from_base = view.cloud->base_from_camera.inverse();
  Errors errors;
  errors.num_views = 1;
  for (std::size_t i = 0; i < depth.values().size(); ++i) {
    if (view.object_mask.values()[i] != kObject || depth.values()[i] == 0) continue;
    ++errors.num_pixels;
    const Eigen::Vector3f& point = view.cloud->points[i];
    if (!IsMeasured(point)) continue;
    const float truth_m = kDepthUnitM * static_cast<float>(depth.values()[i]);
    errors.errors_m.push_back(std::abs((camera_from_base * point).z() - truth_m));
    const int u = static_cast<int>(i) % depth.width();
    const int v = static_cast<int>(i) / depth.width();
    if (IsTextured(view.image, u, v)) errors.textured_errors_m.push_back(errors.errors_m.back());
  }
  return errors;
}

// The smallest error that is not less than the share of all.
double Percentile(std::vector<float>& errors_m, double share) {
  if (errors_m.empty()) return 0.0;
  const auto rank =
      static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(errors_m.size()))) - 1;
  std::nth_element(errors_m.begin(), errors_m.begin() + rank, errors_m.end());
  return static_cast<double>(errors_m[static_cast<std::size_t>(rank)]);
}

CloudFigures Summarise(std::string object_class, Errors errors) {
  CloudFigures figures{.object_class = std::move(object_class),
                       .num_views = errors.num_views,
                       .num_pixels = errors.num_pixels,
                       .num_measured = errors.errors_m.size(),
                       .num_textured = errors.textured_errors_m.size()};
  if (errors.errors_m.empty()) return figures;
  const auto num_beyond =
      std::count_if(errors.errors_m.begin(), errors.errors_m.end(), [](float error_m) {
        return static_cast<double>(error_m) > kGrossErrorM;
      });
  figures.share_beyond =
      static_cast<double>(num_beyond) / static_cast<double>(errors.errors_m.size());
  figures.median_error_m = Percentile(errors.errors_m, 0.5);
  figures.percentile90_error_m = Percentile(errors.errors_m, 0.9);
  figures.textured_median_error_m = Percentile(errors.textured_errors_m, 0.5);
  return figures;
}

}  // namespace

std::vector<CloudFigures> CompareClouds(const ViewSet& set,
                                        int num_threads,
                                        const Progress& progress) {
  std::vector<Errors> of_views(set.items.size());
  ParallelForReporting(
      set.items.size(), num_threads, progress, "comparing clouds", [&](std::size_t i) {
        of_views[i] = ErrorsOf(set, i);
      });
  std::vector<std::pair<std::string, Errors>> classes;
  Errors all;
  for (std::size_t i = 0; i < of_views.size(); ++i) {
    const std::string& name = set.items[i].object_class;
    auto found = std::find_if(
        classes.begin(), classes.end(), [&](const auto& entry) { return entry.first == name; });
    if (found == classes.end()) found = classes.insert(classes.end(), {name, {}});
    found->second.Add(of_views[i]);
    all.Add(of_views[i]);
  }
  std::vector<CloudFigures> figures;
  figures.reserve(classes.size() + 1);
  for (auto& [name, errors] : classes) figures.push_back(Summarise(name, std::move(errors)));
  figures.push_back(Summarise("", std::move(all)));
  return figures;
}

}  // namespace handcraft::datasets
