// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/scaled_set.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgproc.hpp>

#include "datasets/importers/staging_folder.h"
#include "datasets/parallel_reporting.h"
#include "lib/core/check.h"
#include "lib/core/path_kind.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

int ScaledSide(int side, double scale) {
  return std::max(1, static_cast<int>(std::lround(scale * side)));
}

Image Resize(const Image& image, double scale, int interpolation) {
  Image scaled(
      ScaledSide(image.width(), scale), ScaledSide(image.height(), scale), image.channels());
  // OpenCV takes no const data, and only reads this.
  const cv::Mat source(image.height(),
                       image.width(),
                       CV_8UC(image.channels()),
                       const_cast<std::uint8_t*>(image.Row(0)));
  cv::Mat target(scaled.height(), scaled.width(), CV_8UC(scaled.channels()), scaled.Row(0));
  cv::resize(source, target, target.size(), 0.0, 0.0, interpolation);
  return scaled;
}

void WriteScaled(const LabelledImageSet& set,
                 std::size_t index,
                 double scale,
                 const fs::path& root,
                 LabelledImage& item) {
  const LabelledPicture picture = ReadLabelledPicture(set, index);
  item = set.items[index];
  item.others.clear();
  item.image = fmt::format("images/{:06}.png", index);
  item.mask = fmt::format("masks/{:06}.png", index);
  const int interpolation = scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR;
  perception::WritePng(root / item.image, Resize(picture.image, scale, interpolation));
  perception::WritePng(root / item.mask, Resize(picture.mask, scale, cv::INTER_NEAREST));
}

}  // namespace

LabelledImageSet ProvideScaledSet(const LabelledImageSet& set,
                                  double scale,
                                  const fs::path& folder,
                                  int num_threads,
                                  const Progress& progress) {
  HC_CHECK(scale >= 0.1 && scale <= 10.0, scale);
  if (Exists(folder / "manifest.csv")) return ReadLabelledImageSet(folder);
  fs::create_directories(folder.parent_path());
  StagingFolder staging(folder);
  staging.AddFolder("images");
  staging.AddFolder("masks");
  LabelledImageSet scaled{.root = staging.path(), .items = {}};
  scaled.items.resize(set.items.size());
  ParallelForReporting(set.items.size(), num_threads, progress, "scaling", [&](std::size_t i) {
    WriteScaled(set, i, scale, scaled.root, scaled.items[i]);
  });
  WriteManifest(scaled);
  staging.MoveToTarget();
  scaled.root = folder;
  return scaled;
}

}  // namespace handcraft::datasets
