// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/object_rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "tests/lib/features/some_cloud.h"

namespace handcraft::features {
namespace {

using testing::SomeCloud;

// Views that own their numbers.
struct Views {
  std::vector<double> normals = {};
  std::vector<double> moments = {};
  HalvesMoments scales = {};

  void Add(const ViewDescription& view) {
    normals.insert(normals.end(), view.normal.begin(), view.normal.end());
    moments.insert(moments.end(), view.moments.begin(), view.moments.end());
    scales = MomentScales(moments);
  }
  [[nodiscard]] KnownViews View() const { return {normals, moments, scales}; }
};

ViewDescription Upright(double angle_rad) {
  ViewDescription view;
  view.normal = {std::cos(angle_rad), std::sin(angle_rad), 0.0};
  view.moments.fill(0.1);
  view.moments[0] = view.moments[kMomentsPerHalf] = 50.0;
  return view;
}

ViewDescription SomeView(Rng& rng) {
  ViewDescription view = Upright(2.0 * rng.Normal());
  for (double& moment : view.moments) moment = 0.1 * rng.Normal();
  view.moments[0] = 100.0 + 50.0 * rng.Uniform();
  view.moments[kMomentsPerHalf] = 100.0 + 50.0 * rng.Uniform();
  return view;
}

// Eqs. 4.3 to 4.5 with sorting and lists.
std::size_t ByDefinition(const ViewDescription& query,
                         const std::vector<ViewDescription>& views,
                         std::size_t num_candidates) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < views.size(); ++i) {
    double dot = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) dot += query.normal[axis] * views[i].normal[axis];
    order.emplace_back(std::acos(std::min(1.0, std::fabs(dot))), i);
  }
  std::sort(order.begin(), order.end());
  std::pair<double, std::size_t> best = {1e300, 0};
  for (std::size_t c = 0; c < num_candidates; ++c) {
    const HalvesMoments& a = query.moments;
    const HalvesMoments& b = views[order[c].second].moments;
    const double sum =
        std::pow(a[0] - b[0], 2) + std::pow(a[1] * a[0] * a[0] - b[1] * b[0] * b[0], 2) +
        std::pow(a[8] - b[8], 2) + std::pow(a[9] * a[8] * a[8] - b[9] * b[8] * b[8], 2);
    best = std::min(best, {std::sqrt(sum / 4.0), order[c].second});
  }
  return best.second;
}

TEST(AngleBetweenLines, KnowsNoDirection) {
  EXPECT_EQ(AngleBetweenLines({1, 0, 0}, {1, 0, 0}), 0.0);
  EXPECT_EQ(AngleBetweenLines({1, 0, 0}, {-1, 0, 0}), 0.0);
  EXPECT_NEAR(AngleBetweenLines({1, 0, 0}, {0, 1, 0}), std::numbers::pi / 2.0, 1e-15);
  EXPECT_NEAR(
      AngleBetweenLines(Upright(0.1).normal, Upright(3.0).normal), std::numbers::pi - 2.9, 1e-14);
  EXPECT_NEAR(AngleBetweenLines(Upright(0.0).normal, Upright(1e-9).normal), 1e-9, 1e-24);
}

TEST(NearestView, IsThePrintedRules) {
  Rng rng(1);
  for (int repeat = 0; repeat < 50; ++repeat) {
    std::vector<ViewDescription> all;
    Views views;
    for (int i = 0; i < 36; ++i) {
      all.push_back(SomeView(rng));
      views.Add(all.back());
    }
    const ViewDescription query = SomeView(rng);
    const RotationRule printed{
        .moments = ComparedMoments::kPrinted, .num_candidates = 6, .angle_weight = 0.0};
    EXPECT_EQ(NearestView(query, views.View(), printed), ByDefinition(query, all, 6));
  }
}

TEST(NearestView, IsTheViewItselfByEveryRule) {
  Rng rng(2);
  Views views;
  std::vector<ViewDescription> all;
  for (int i = 0; i < 20; ++i) {
    all.push_back(SomeView(rng));
    views.Add(all.back());
  }
  for (const ComparedMoments moments :
       {ComparedMoments::kPrinted, ComparedMoments::kScaleFree, ComparedMoments::kAll}) {
    for (const std::size_t num_candidates : {0, 1, 6, 100}) {
      for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(NearestView(all[i], views.View(), {moments, num_candidates, 1.0}), i)
            << NameOf(moments);
      }
    }
  }
}

// The one with the right moments is among the candidates only when there are enough of them.
TEST(NearestView, LooksAtTheCandidatesAlone) {
  Views views;
  for (int i = 0; i < 8; ++i) {
    ViewDescription view = Upright(0.1 * i);
    view.moments[1] = i == 5 ? 0.1 : 0.5;
    views.Add(view);
  }
  const ViewDescription query = Upright(0.0);
  RotationRule rule{.moments = ComparedMoments::kScaleFree, .num_candidates = 5, .angle_weight = 0};
  EXPECT_EQ(NearestView(query, views.View(), rule), 0U);
  rule.num_candidates = 6;
  EXPECT_EQ(NearestView(query, views.View(), rule), 5U);
  rule.angle_weight = 10.0;
  EXPECT_EQ(NearestView(query, views.View(), rule), 0U);
}

TEST(NearestView, OfEqualOnesIsTheFirst) {
  Views views;
  for (int i = 0; i < 9; ++i) views.Add(Upright(0.3));
  EXPECT_EQ(NearestView(Upright(0.1), views.View(), {ComparedMoments::kAll, 4, 1.0}), 0U);
}

TEST(NearestView, ScaleFreeMomentsDoNotSeeTheDistance) {
  Rng rng(3);
  Views views;
  std::vector<ViewDescription> all;
  for (int i = 0; i < 12; ++i) {
    all.push_back(SomeView(rng));
    views.Add(all.back());
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    ViewDescription nearer = all[i];
    nearer.moments[0] *= 4.0;  // twice as near
    nearer.moments[kMomentsPerHalf] *= 4.0;
    EXPECT_EQ(NearestView(nearer, views.View(), {ComparedMoments::kScaleFree, 0, 0.0}), i);
    EXPECT_EQ(NearestView(nearer, views.View(), {ComparedMoments::kAll, 0, 0.0}), i);
  }
}

TEST(MomentScales, AreStandardDeviationsOrOne) {
  std::vector<double> moments(2 * kNumMoments, 0.5);
  moments[0] = 10.0;
  moments[kMomentsPerHalf] = 30.0;  // shares ¼ and ¾
  moments[kNumMoments] = 30.0;
  moments[kNumMoments + kMomentsPerHalf] = 10.0;
  moments[3] = 0.1;
  const HalvesMoments scales = MomentScales(moments);
  EXPECT_NEAR(scales[0], 0.25, 1e-15);
  EXPECT_NEAR(scales[3], 0.2, 1e-15);
  EXPECT_EQ(scales[5], 1.0);
}

TEST(DescribeView, HoldsPlaneMeanAndMoments) {
  SomeCloud cloud(20, 10);
  for (int v = 2; v < 8; ++v) {
    for (int u = 3; u < 15; ++u) cloud.Set(u, v, {0.01 * u, 0.01 * v, 0.2});
  }
  std::vector<float> scratch(ObjectPlaneScratch(20, 10));
  ViewDescription view;
  ASSERT_EQ(DescribeView(cloud.View(), scratch, view), CloudFault::kNone);
  EXPECT_NEAR(view.normal[2], 1.0, 1e-9);
  EXPECT_NEAR(view.mean_m[0], 0.085, 1e-7);
  EXPECT_EQ(view.moments[0], 36.0);
}

TEST(DescribeView, SaysWhatIsWrong) {
  SomeCloud cloud(5, 5);
  std::vector<float> scratch(ObjectPlaneScratch(5, 5));
  ViewDescription view;
  EXPECT_EQ(DescribeView(cloud.View(), scratch, view), CloudFault::kTooFewPoints);
  cloud.Set(2, 0, {0, 0, 0});
  cloud.Set(2, 1, {1, 0, 0});
  cloud.Set(2, 2, {0, 1, 0});
  EXPECT_EQ(DescribeView(cloud.View(), scratch, view), CloudFault::kEmptyHalf);
}

}  // namespace
}  // namespace handcraft::features
