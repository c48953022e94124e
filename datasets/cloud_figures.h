// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "datasets/formats/view_set.h"
#include "lib/core/progress.h"

namespace handcraft::datasets {

/// How the measured clouds of a class compare with the true depth, over the pixels that show its
/// object and have a true depth. The error is |measured − true depth| along the camera's axis.
struct CloudFigures {
  std::string object_class;  ///< empty: of all classes
  std::size_t num_views = 0;
  std::size_t num_pixels = 0;            ///< of objects
  std::size_t num_measured = 0;          ///< of these
  double median_error_m = 0.0;           ///< of the measured ones; 0 when there are none
  double percentile90_error_m = 0.0;     ///< nine of ten errors are not larger
  double share_beyond = 0.0;             ///< of the measured ones with errors beyond kGrossErrorM
  std::size_t num_textured = 0;          ///< of the measured ones, those with texture about them
  double textured_median_error_m = 0.0;  ///< of these
};

/// A pixel has texture about it when over the 5 × 5 pixels around it, as far as they lie in the
/// picture, √mean(((I(u + 1, v) − I(u − 1, v)) / 2)²) is at least so many gray levels, I the mean
/// of the channels: along the rows is where a stereo pair's matcher finds something to hold on to.
inline constexpr double kTexturedGradient = 3.0;

/// Errors beyond it are gross: another surface was found.
inline constexpr double kGrossErrorM = 0.02;

/// The figures of each class, in the order in which the classes appear, and those of all at the
/// end. Percentiles are those of the nearest rank. Throws Error when a view has no cloud or no true
/// depth, and when files cannot be read or do not fit each other. The number of threads changes
/// nothing.
[[nodiscard]] std::vector<CloudFigures> CompareClouds(const ViewSet& set,
                                                      int num_threads,
                                                      const Progress& progress);

}  // namespace handcraft::datasets
