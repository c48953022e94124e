// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/table_removal.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "lib/core/check.h"
#include "lib/core/option_rules.h"
#include "lib/core/rng.h"

namespace handcraft::perception {
namespace {

bool IsNear(const Plane& plane, const Eigen::Vector3f& point, float epsilon_m) {
  return std::abs(plane.Distance(point)) < epsilon_m;
}

bool IsNearAny(const std::vector<Plane>& planes, const Eigen::Vector3f& point, float epsilon_m) {
  return std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) {
    return IsNear(plane, point, epsilon_m);
  });
}

// What stands on a support lies above one of them, and near none; without any, everything may stay.
bool MayStandOnOne(const std::vector<Plane>& planes,
                   const Eigen::Vector3f& point,
                   float epsilon_m) {
  bool is_above = planes.empty();
  for (const Plane& plane : planes) {
    const float distance_m = plane.Distance(point);
    if (std::abs(distance_m) < epsilon_m) return false;
    is_above = is_above || distance_m > 0.0F;
  }
  return is_above;
}

// Every n-th pixel of every n-th row: so many measured points that the whole cloud need not be
// looked at for each plane.
PixelPoints SampleOf(const CloudView& cloud, int max_samples) {
  const double num_pixels = static_cast<double>(cloud.width) * cloud.height;
  const int step = std::max(
      1, static_cast<int>(std::ceil(std::sqrt(num_pixels / static_cast<double>(max_samples)))));
  PixelPoints sample;
  sample.Reset(cloud.points.size() / static_cast<std::size_t>(step) + 1);
  for (int v = 0; v < cloud.height; v += step) {
    for (int u = 0; u < cloud.width; u += step) {
      const std::int32_t pixel = v * cloud.width + u;
      const Eigen::Vector3f& point = cloud.points[static_cast<std::size_t>(pixel)];
      if (IsMeasured(point)) sample.Add(point, pixel);
    }
  }
  return sample;
}

class TableSearch {
 public:
  TableSearch(const CloudView& cloud, const TableRemovalOptions& options)
      : cloud_(cloud),
        options_(options),
        up_(options.up.normalized()),
        least_cosine_(std::cos(options.max_angle_rad)),
        remaining_(SampleOf(cloud, options.max_samples)),
        num_samples_(static_cast<float>(remaining_.size())) {}

  TablePlanes Run() {
    TablePlanes result;
    if (remaining_.empty()) return result;
    Rng rng = Rng::Stream(options_.seed, "table_removal");
    while (result.num_tries < options_.max_tries && !IsEnough()) {
      ++result.num_tries;
      const auto drawn = static_cast<std::size_t>(rng.UniformInt(remaining_.size()));
      const std::optional<Plane> plane = SupportAround(remaining_.Pixels()[drawn], result.planes);
      if (!plane) continue;
      result.planes.push_back(*plane);
      remaining_.Filter([&](float x, float y, float z) {
        return !IsNear(*plane, {x, y, z}, options_.epsilon_m);
      });
    }
    result.state = result.planes.empty() ? TableState::kNoPlane : TableState::kFound;
    return result;
  }

 private:
  [[nodiscard]] bool IsEnough() const {
    const float share_left = static_cast<float>(remaining_.size()) / num_samples_;
    return remaining_.empty() || 1.0F - share_left >= options_.enough_removed ||
           share_left < options_.min_share;  // no plane can hold its share any more
  }

  [[nodiscard]] bool IsHorizontal(const Plane& plane) const {
    return std::abs(plane.normal.dot(up_)) >= least_cosine_;
  }

  // The plane of the neighbours of a pixel, if it is that of a support.
  [[nodiscard]] std::optional<Plane> SupportAround(std::int32_t pixel,
                                                   const std::vector<Plane>& known) const {
    std::optional<Plane> plane = PlaneOfNeighbours(pixel, known);
    for (int i = 0; i < options_.refinements; ++i) {
      if (!plane || !IsHorizontal(*plane)) return std::nullopt;
      plane = PlaneOfNear(*plane);
    }
    if (!plane || !IsHorizontal(*plane) || Share(*plane) < options_.min_share) return std::nullopt;
    return plane->TurnedTo(up_);
  }

  [[nodiscard]] std::optional<Plane> PlaneOfNeighbours(std::int32_t pixel,
                                                       const std::vector<Plane>& known) const {
    const int reach = options_.neighbourhood_px;
    const int u = pixel % cloud_.width;
    const int v = pixel / cloud_.width;
    const Eigen::Vector3f& centre = cloud_.points[static_cast<std::size_t>(pixel)];
    const float radius2 = options_.neighbourhood_m * options_.neighbourhood_m;
    PlaneFit fit;
    for (int y = std::max(0, v - reach); y <= std::min(cloud_.height - 1, v + reach); ++y) {
      const Eigen::Vector3f* const row =
          &cloud_.points[static_cast<std::size_t>(y) * static_cast<std::size_t>(cloud_.width)];
      for (int x = std::max(0, u - reach); x <= std::min(cloud_.width - 1, u + reach); ++x) {
        // Not measured: the distance is NaN, and not within the radius.
        if (!((row[x] - centre).squaredNorm() <= radius2)) continue;
        if (!IsNearAny(known, row[x], options_.epsilon_m)) fit.Add(row[x]);
      }
    }
    if (fit.count() < static_cast<std::size_t>(options_.min_neighbours)) return std::nullopt;
    return fit.Solve();
  }

  [[nodiscard]] std::optional<Plane> PlaneOfNear(const Plane& plane) const {
    PlaneFit fit;
    for (std::size_t i = 0; i < remaining_.size(); ++i) {
      const Eigen::Vector3f point = remaining_.Point(i);
      if (IsNear(plane, point, options_.epsilon_m)) fit.Add(point);
    }
    return fit.Solve();
  }

  [[nodiscard]] float Share(const Plane& plane) const {
    std::size_t num_near = 0;
    for (std::size_t i = 0; i < remaining_.size(); ++i) {
      num_near += IsNear(plane, remaining_.Point(i), options_.epsilon_m) ? 1 : 0;
    }
    return static_cast<float>(num_near) / num_samples_;
  }

  const CloudView& cloud_;
  const TableRemovalOptions& options_;
  Eigen::Vector3f up_;
  float least_cosine_;
  PixelPoints remaining_;
  float num_samples_;
};

}  // namespace

void TableRemovalOptions::Validate() const {
  const auto require = [](bool holds, const std::string& field, auto value, const char* rule) {
    RequireOption(holds, "TableRemovalOptions." + field, value, rule);
  };
  constexpr float kRightAngle = std::numbers::pi_v<float> / 2.0F;
  require(up.allFinite() && up.norm() > 0.0F, "up", up.norm(), "of a finite length above 0");
  require(max_angle_rad > 0.0F && max_angle_rad <= kRightAngle * 1.0001F,
          "max_angle_rad",
          max_angle_rad,
          "in (0, pi/2]");
  require(epsilon_m > 0.0F && epsilon_m <= 1.0F, "epsilon_m", epsilon_m, "in (0, 1]");
  require(neighbourhood_px >= 1 && neighbourhood_px <= 100,
          "neighbourhood_px",
          neighbourhood_px,
          "1 to 100");
  require(neighbourhood_m > 0.0F && neighbourhood_m <= 10.0F,
          "neighbourhood_m",
          neighbourhood_m,
          "in (0, 10]");
  require(min_neighbours >= 3 && min_neighbours <= 40000,
          "min_neighbours",
          min_neighbours,
          "3 to 40000");
  require(max_tries >= 1 && max_tries <= 100000, "max_tries", max_tries, "1 to 100000");
  require(enough_removed > 0.0F && enough_removed <= 1.0F,
          "enough_removed",
          enough_removed,
          "in (0, 1]");
  require(min_share >= 0.0F && min_share <= 1.0F, "min_share", min_share, "in [0, 1]");
  require(refinements >= 0 && refinements <= 10, "refinements", refinements, "0 to 10");
  require(max_samples >= 100, "max_samples", max_samples, "100 or more");
}

TablePlanes FindTable(const CloudView& cloud, const TableRemovalOptions& options) {
  HC_CHECK(cloud.points.size() ==
               static_cast<std::size_t>(cloud.width) * static_cast<std::size_t>(cloud.height),
           cloud.points.size(),
           cloud.width,
           cloud.height);
  return TableSearch(cloud, options).Run();
}

std::size_t TakePointsOffPlanes(const CloudView& cloud,
                                const std::vector<Plane>& planes,
                                float epsilon_m,
                                PixelPoints& rest) {
  rest.Reset(cloud.points.size());
  std::size_t num_measured = 0;
  std::int32_t pixel = 0;
  for (const Eigen::Vector3f& point : cloud.points) {
    if (IsMeasured(point)) {
      ++num_measured;
      if (MayStandOnOne(planes, point, epsilon_m)) rest.Add(point, pixel);
    }
    ++pixel;
  }
  return num_measured;
}

}  // namespace handcraft::perception
