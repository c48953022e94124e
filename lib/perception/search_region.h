// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lib/core/image.h"
#include "lib/perception/cloud_outliers.h"
#include "lib/perception/cloud_view.h"
#include "lib/perception/table_removal.h"

namespace handcraft::perception {

/// Where in the crop edges are looked for.
enum class CropShape {
  kBox,      ///< everywhere in the bounding box of the object's pixels
  kOutline,  ///< within margin_px of them: no edges of what is around the object
};

struct SearchRegionOptions {
  TableRemovalOptions table = {};
  CloudOutlierOptions outliers = {};
  CropShape shape = CropShape::kOutline;
  int margin_px = 4;          ///< the crop is so much larger than the object's pixels; 0…100
  float canny_low = 50.0F;    ///< thresholds of the gradient's length, 8 bit, Sobel 3 × 3:
  float canny_high = 150.0F;  ///< 0 ≤ low ≤ high ≤ 10000

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// What the reduction came to.
enum class SearchState {
  kFound,
  kNoTable,      ///< no support was found: the region is that of all points
  kNoPoints,     ///< nothing was measured: no region
  kNothingLeft,  ///< every point lies on the support: no region
  kNoEdges,      ///< the crop shows no edge: no region
};

/// One sentence for people.
[[nodiscard]] std::string_view MessageOf(SearchState state) noexcept;

/// A step of the reduction: how many pixels it left, and what it took.
struct SearchStage {
  std::string_view name;
  std::size_t num_pixels = 0;
  double time_ms = 0.0;
};

struct PixelBox {
  int u_px = 0;  ///< first column
  int v_px = 0;  ///< first row
  int width = 0;
  int height = 0;
};

struct SearchRegion {
  SearchState state = SearchState::kNoPoints;
  Image mask;     ///< region R: 255 inside, 0 outside, of the picture's size
  PixelBox crop;  ///< the box R lies in; empty when there is none
  std::vector<Plane> table;
  std::vector<SearchStage> stages;  ///< "picture", "measured", …, "region"; those that were reached

  [[nodiscard]] bool HasRegion() const noexcept {
    return state == SearchState::kFound || state == SearchState::kNoTable;
  }
};

/// Pixels of a mask that are not 0, as v · width + u, ascending.
[[nodiscard]] std::vector<std::int32_t> PixelsOf(const Image& mask);

/// Search-space reduction: where in a picture grasp points are worth looking for. The points on the
/// support are removed, then the outliers; the pixels of what is left are the object; in their box,
/// Canny's edges; region R is the 3 × 3 neighbourhood of each edge pixel.
///
/// Keeps its memory from picture to picture; one object a thread. Deterministic but for the times.
/// Source: dissertation section 3.2.2, Figures 3.4 and 3.5, Table 3.1; J. Canny, "A computational
/// approach to edge detection", 1986, as OpenCV has it.
class SearchRegionFinder {
 public:
  /// Throws Error(kUsage) when the options are not valid.
  explicit SearchRegionFinder(SearchRegionOptions options);

  /// `image`: gray or BGR, of the cloud's size (else std::logic_error).
  [[nodiscard]] SearchRegion Find(const Image& image, const CloudView& cloud);

 private:
  void FindObject(const CloudView& cloud, SearchRegion& region);
  void FindEdges(const Image& image, SearchRegion& region) const;

  SearchRegionOptions options_;
  PixelPoints points_;
};

}  // namespace handcraft::perception
