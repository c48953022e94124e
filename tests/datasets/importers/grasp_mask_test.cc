// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/grasp_mask.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;

// One letter a pixel: G good, . bad, - don't care.
std::vector<std::string> Letters(const Image& mask) {
  std::vector<std::string> rows;
  for (int v = 0; v < mask.height(); ++v) {
    rows.emplace_back();
    for (int u = 0; u < mask.width(); ++u) {
      const std::uint8_t value = mask.At(u, v);
      rows.back() += value == kMaskGood ? 'G' : value == kMaskBad ? '.' : '-';
    }
  }
  return rows;
}

GraspMaskOptions NoMargin() { return {.dont_care_margin_px = 0}; }

// Opens along u from 1 to 7, closes over v from 1 to 3.
constexpr GraspRectangle kFlat = {{{1, 1}, {7, 1}, {7, 3}, {1, 3}}};

TEST(MakeGraspMask, PutsTheGoodStripeAcrossTheOpening) {
  EXPECT_EQ(
      Letters(MakeGraspMask(9, 5, {kFlat}, {}, NoMargin())),
      (std::vector<std::string>{".........", ".--GGG--.", ".--GGG--.", ".--GGG--.", "........."}));
}

TEST(MakeGraspMask, TurnsTheStripeWithTheRectangle) {
  const GraspRectangle tall = {{{1, 1}, {1, 7}, {3, 7}, {3, 1}}};
  EXPECT_EQ(Letters(MakeGraspMask(5, 9, {tall}, {}, NoMargin())),
            (std::vector<std::string>{
                ".....", ".---.", ".---.", ".GGG.", ".GGG.", ".GGG.", ".---.", ".---.", "....."}));
}

TEST(MakeGraspMask, KeepsAMargin) {
  GraspMaskOptions options;
  options.dont_care_margin_px = 2;
  EXPECT_EQ(Letters(MakeGraspMask(11, 7, {{{{3, 3}, {7, 3}, {7, 4}, {3, 4}}}}, {}, options)),
            (std::vector<std::string>{"...........",
                                      "...........",
                                      "..-------..",
                                      "..---G---..",  // a third of 4 px: 5 ± 0.67 px
                                      "..---G---..",
                                      "..-------..",
                                      "..........."}));
}

TEST(MakeGraspMask, LetsTheLaterRuleOverrule) {
  GraspMaskOptions options;
  options.dont_care_margin_px = 20;
  const GraspRectangle left = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  const std::vector<std::string> expected = {
      "--GGG--..", "--GGG--..", "--GGG--..", "--GGG--..", "---------", "---------"};
  GraspRectangle positive = {{{0, 0}, {6, 0}, {6, 3}, {0, 3}}};
  GraspRectangle negative = {{{5, 0}, {8, 0}, {8, 3}, {5, 3}}};
  EXPECT_EQ(Letters(MakeGraspMask(9, 6, {positive}, {negative}, options)), expected);
  EXPECT_EQ(Letters(MakeGraspMask(9, 6, {positive}, {}, options))[0], "--GGG----");
  // A good pixel stays good inside another rectangle's don't care.
  EXPECT_EQ(MakeGraspMask(9, 6, {positive, left}, {}, options).At(3, 0), kMaskGood);
  EXPECT_EQ(MakeGraspMask(9, 6, {left, positive}, {}, options).At(3, 0), kMaskGood);
}

TEST(MakeGraspMask, CallsEverythingBadWithoutRectangles) {
  const Image mask = MakeGraspMask(3, 2, {}, {}, {});
  EXPECT_EQ(mask.values(), std::vector<std::uint8_t>(6, kMaskBad));
}

// Oracle: a dense walk over the rectangle gives the distance, and its own coordinates the stripe.
TEST(MakeGraspMask, AgreesWithADenseWalk) {
  Rng rng(17);
  for (int round = 0; round < 5; ++round) {
    const double angle = 6.28 * rng.Uniform();
    const double half_opening = 4 + 10 * rng.Uniform();
    const double half_closing = 2 + 5 * rng.Uniform();
    const double x = 5 + 30 * rng.Uniform();
    const double y = 5 + 20 * rng.Uniform();
    const auto point = [&](double s, double t) {
      return std::array{
          x + s * half_opening * std::cos(angle) - t * half_closing * std::sin(angle),
          y + s * half_opening * std::sin(angle) + t * half_closing * std::cos(angle)};
    };
    const GraspRectangle corners = {point(-1, -1), point(1, -1), point(1, 1), point(-1, 1)};
    const GraspMaskOptions options{.good_share = 0.5, .dont_care_margin_px = 6};
    const Image mask = MakeGraspMask(40, 30, {corners}, {}, options);
    for (int v = 0; v < 30; ++v) {
      for (int u = 0; u < 40; ++u) {
        double nearest = 1e9;       // to the rectangle
        double nearest_good = 1e9;  // to its central half
        for (double s = -1; s <= 1; s += 1.0 / 64) {
          for (double t = -1; t <= 1; t += 1.0 / 32) {
            const double gap = std::hypot(point(s, t)[0] - u, point(s, t)[1] - v);
            nearest = std::min(nearest, gap);
            if (std::abs(s) <= 0.5) nearest_good = std::min(nearest_good, gap);
          }
        }
        constexpr double kStep = 0.35;  // the walk's own resolution [px]
        if (mask.At(u, v) == kMaskGood) {
          EXPECT_LE(nearest_good, kStep);
        } else if (mask.At(u, v) == kMaskDontCare) {
          EXPECT_LE(nearest, 6 + kStep);
        } else {
          EXPECT_GE(nearest, 6 - kStep);
        }
      }
    }
  }
}

TEST(MakeGraspMask, TakesRectanglesOutsideThePicture) {
  const GraspRectangle far = {{{-900, -900}, {-890, -900}, {-890, -880}, {-900, -880}}};
  const GraspRectangle wide = {{{-1e5, -1e5}, {1e5, -1e5}, {1e5, 1e5}, {-1e5, 1e5}}};
  EXPECT_EQ(MakeGraspMask(4, 4, {far}, {}, {}).At(0, 0), kMaskBad);
  EXPECT_EQ(MakeGraspMask(4, 4, {wide}, {}, {}).At(3, 3), kMaskGood);
  EXPECT_EQ(MakeGraspMask(1, 1, {kFlat}, {}, {}).At(0, 0), kMaskDontCare);
  EXPECT_THROW(static_cast<void>(MakeGraspMask(4, 4, {GraspRectangle{}}, {}, {})),
               std::logic_error);
}

TEST(RectangleArea, MultipliesTheEdges) {
  EXPECT_DOUBLE_EQ(RectangleArea(kFlat), 12.0);
  EXPECT_DOUBLE_EQ(RectangleArea({}), 0.0);
  EXPECT_TRUE(std::isnan(RectangleArea({{{NAN, 1}, {7, 1}, {7, 3}, {1, 3}}})));
}

TEST(GraspMaskOptions, NamesTheFieldAtFault) {
  EXPECT_THROWS_MESSAGE((GraspMaskOptions{.good_share = 0.0}.Validate(), 0),
                        Error,
                        HasSubstr("GraspMaskOptions.good_share is 0; it must be in (0, 1]"));
  EXPECT_THROWS_MESSAGE((GraspMaskOptions{.dont_care_margin_px = -1}.Validate(), 0),
                        Error,
                        HasSubstr("GraspMaskOptions.dont_care_margin_px is -1"));
}

TEST(RequireWithinPicture, NamesTheRectangleThatReachesNoPixel) {
  const auto box = [](double left, double top) {
    return GraspRectangle{{{left, top}, {left + 10, top}, {left + 10, top + 4}, {left, top + 4}}};
  };
  RequireWithinPicture("a.txt", {}, 20, 10);
  RequireWithinPicture("a.txt", {box(-9, -3), box(19, 9)}, 20, 10);
  for (const GraspRectangle& outside : {box(-11, 0), box(0, -5), box(21, 0), box(0, 11)}) {
    EXPECT_THROWS_MESSAGE(
        (RequireWithinPicture("a.txt", {box(0, 0), outside}, 20, 10), 0),
        Error,
        ::testing::HasSubstr("a.txt: rectangle 2 lies outside its picture of 20x10 pixels"));
  }
}

}  // namespace
}  // namespace handcraft::datasets
