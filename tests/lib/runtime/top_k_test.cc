// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/top_k.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::runtime {
namespace {

using ::testing::ElementsAre;

struct Place {
  std::int32_t u, v;
  bool operator==(const Place&) const = default;
};

std::vector<Place> Find(const ProbabilityMap& map,
                        float above,
                        std::int32_t radius,
                        std::size_t k) {
  std::vector<hc_point> points(k);
  points.resize(radius == 0 ? FindBest(map, above, points)
                            : FindBestApart(map, above, radius, points));
  std::vector<Place> places;
  for (const hc_point& point : points) {
    EXPECT_EQ(point.probability, map.Row(point.v)[point.u]);
    places.push_back({point.u, point.v});
  }
  return places;
}

// The definition, word for word: sort every pixel, then take or suppress one after another.
std::vector<Place> FindByDefinition(const ProbabilityMap& map,
                                    float above,
                                    std::int32_t radius,
                                    std::size_t k) {
  std::vector<Place> order;
  for (std::int32_t v = 0; v < map.height; ++v) {
    for (std::int32_t u = 0; u < map.width; ++u) {
      if (map.Row(v)[u] > above) order.push_back({u, v});
    }
  }
  std::stable_sort(order.begin(), order.end(), [&](const Place& a, const Place& b) {
    return map.Row(a.v)[a.u] > map.Row(b.v)[b.u];
  });
  std::vector<Place> taken;
  for (const Place& place : order) {
    if (taken.size() == k) break;
    const bool suppressed = std::any_of(taken.begin(), taken.end(), [&](const Place& other) {
      return radius > 0 &&
             std::max(std::abs(other.u - place.u), std::abs(other.v - place.v)) <= radius;
    });
    if (!suppressed) taken.push_back(place);
  }
  return taken;
}

// 5 x 3 by hand.
const std::vector<float> kHandMap = {0.9F,
                                     0.8F,
                                     0.0F,
                                     0.1F,
                                     0.7F,  //
                                     0.2F,
                                     0.9F,
                                     0.0F,
                                     0.7F,
                                     0.95F,  //
                                     0.0F,
                                     0.0F,
                                     0.0F,
                                     0.0F,
                                     0.3F};

TEST(FindBest, OrdersByProbabilityThenRowThenColumn) {
  const ProbabilityMap map{kHandMap.data(), 5, 3, 5};
  EXPECT_THAT(Find(map, 0.5F, 0, 4),
              ElementsAre(Place{4, 1}, Place{0, 0}, Place{1, 1}, Place{1, 0}));
  EXPECT_THAT(Find(map, 0.5F, 0, 100).size(), 6U);
  EXPECT_THAT(Find(map, 0.9F, 0, 100), ElementsAre(Place{4, 1}));
}

TEST(FindBestApart, SuppressesNeighboursOfWhatItTook) {
  const ProbabilityMap map{kHandMap.data(), 5, 3, 5};
  EXPECT_THAT(Find(map, 0.5F, 1, 10), ElementsAre(Place{4, 1}, Place{0, 0}));
  EXPECT_THAT(Find(map, 0.05F, 1, 10), ElementsAre(Place{4, 1}, Place{0, 0}));
  EXPECT_THAT(Find(map, 0.05F, std::numeric_limits<std::int32_t>::max(), 10),
              ElementsAre(Place{4, 1}));
}

TEST(FindBestApart, AgreesWithTheDefinitionOnRandomMaps) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    Rng rng = Rng::Stream(1, "top_k", i);
    const auto width = static_cast<std::int32_t>(1 + rng.UniformInt(i % 10 == 0 ? 300 : 40));
    const auto height = static_cast<std::int32_t>(1 + rng.UniformInt(40));
    const auto stride = width + static_cast<std::int32_t>(rng.UniformInt(5));
    // Few levels make many ties; some maps hold NaN.
    const double num_levels = i % 3 == 0 ? 4.0 : 1000.0;
    std::vector<float> values(static_cast<std::size_t>(stride * height));
    for (float& value : values) {
      value = static_cast<float>(std::floor(rng.Uniform() * num_levels) / num_levels);
      if (i % 7 == 0 && rng.Uniform() < 0.1) value = std::numeric_limits<float>::quiet_NaN();
    }
    const ProbabilityMap map{values.data(), width, height, stride};
    const auto above = static_cast<float>(rng.Uniform() * 0.9);
    const std::size_t k = 1 + rng.UniformInt(60);
    for (const std::int32_t radius : {0, 1, 2, 5, 1000}) {
      ASSERT_EQ(Find(map, above, radius, k), FindByDefinition(map, above, radius, k))
          << "map " << i << ", radius " << radius;
    }
  }
}

TEST(FindBestApart, TakesAPlateauInReadingOrder) {
  const std::vector<float> values(100 * 80, 1.0F);
  const ProbabilityMap map{values.data(), 100, 80, 100};
  EXPECT_EQ(Find(map, 0.0F, 3, 1000), FindByDefinition(map, 0.0F, 3, 1000));
}

// More points near a tile than are listed for it.
TEST(FindBestApart, TakesAPlateauOfLargeTiles) {
  const std::vector<float> values(1000 * 700, 1.0F);
  const ProbabilityMap map{values.data(), 1000, 700, 1000};
  EXPECT_EQ(Find(map, 0.0F, 1, 3000), FindByDefinition(map, 0.0F, 1, 3000));
}

TEST(FindBest, FindsNothingInNaN) {
  const std::vector<float> values(12, std::numeric_limits<float>::quiet_NaN());
  const ProbabilityMap map{values.data(), 4, 3, 4};
  EXPECT_TRUE(Find(map, -1.0F, 0, 5).empty());
  EXPECT_TRUE(Find(map, -1.0F, 2, 5).empty());
}

TEST(FindBest, FitsIntoNoPlace) {
  const ProbabilityMap map{kHandMap.data(), 5, 3, 5};
  EXPECT_TRUE(Find(map, 0.0F, 0, 0).empty());
  EXPECT_TRUE(Find(map, 0.0F, 1, 0).empty());
}

TEST(FindBest, ReadsMapsFromBelow) {
  const ProbabilityMap upside_down{kHandMap.data() + 10, 5, 3, -5};
  EXPECT_THAT(Find(upside_down, 0.9F, 0, 5), ElementsAre(Place{4, 1}));
  EXPECT_THAT(Find(upside_down, 0.85F, 0, 5), ElementsAre(Place{4, 1}, Place{1, 1}, Place{0, 2}));
}

}  // namespace
}  // namespace handcraft::runtime
