// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/cornell_mask.h"

#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/importers/cornell.h"
#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<GraspRectangle> ReadText(std::string_view text) {
  const testing::TemporaryDirectory folder;
  std::ofstream(folder / "pcd0100cpos.txt", std::ios::binary) << text;
  return ReadCornellRectangles(folder / "pcd0100cpos.txt");
}

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

CornellOptions NoMargin() { return {.dont_care_margin_px = 0}; }

// Opens along u from 1 to 7, closes over v from 1 to 3.
constexpr GraspRectangle kFlat = {{{1, 1}, {7, 1}, {7, 3}, {1, 3}}};

TEST(MakeCornellMask, PutsTheGoodStripeAcrossTheOpening) {
  EXPECT_EQ(
      Letters(MakeCornellMask(9, 5, {kFlat}, {}, NoMargin())),
      (std::vector<std::string>{".........", ".--GGG--.", ".--GGG--.", ".--GGG--.", "........."}));
}

TEST(MakeCornellMask, TurnsTheStripeWithTheRectangle) {
  const GraspRectangle tall = {{{1, 1}, {1, 7}, {3, 7}, {3, 1}}};
  EXPECT_EQ(Letters(MakeCornellMask(5, 9, {tall}, {}, NoMargin())),
            (std::vector<std::string>{
                ".....", ".---.", ".---.", ".GGG.", ".GGG.", ".GGG.", ".---.", ".---.", "....."}));
}

TEST(MakeCornellMask, KeepsAMargin) {
  CornellOptions options;
  options.dont_care_margin_px = 2;
  EXPECT_EQ(Letters(MakeCornellMask(11, 7, {{{{3, 3}, {7, 3}, {7, 4}, {3, 4}}}}, {}, options)),
            (std::vector<std::string>{"...........",
                                      "...........",
                                      "..-------..",
                                      "..---G---..",  // a third of 4 px: 5 ± 0.67 px
                                      "..---G---..",
                                      "..-------..",
                                      "..........."}));
}

TEST(MakeCornellMask, LetsTheLaterRuleOverrule) {
  CornellOptions options;
  options.dont_care_margin_px = 20;
  const GraspRectangle left = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  const std::vector<std::string> expected = {
      "--GGG--..", "--GGG--..", "--GGG--..", "--GGG--..", "---------", "---------"};
  GraspRectangle positive = {{{0, 0}, {6, 0}, {6, 3}, {0, 3}}};
  GraspRectangle negative = {{{5, 0}, {8, 0}, {8, 3}, {5, 3}}};
  EXPECT_EQ(Letters(MakeCornellMask(9, 6, {positive}, {negative}, options)), expected);
  options.use_negative_rectangles = false;
  EXPECT_EQ(Letters(MakeCornellMask(9, 6, {positive}, {negative}, options))[0], "--GGG----");
  // A good pixel stays good inside another rectangle's don't care.
  EXPECT_EQ(MakeCornellMask(9, 6, {positive, left}, {}, options).At(3, 0), kMaskGood);
  EXPECT_EQ(MakeCornellMask(9, 6, {left, positive}, {}, options).At(3, 0), kMaskGood);
}

TEST(MakeCornellMask, CallsEverythingBadWithoutRectangles) {
  const Image mask = MakeCornellMask(3, 2, {}, {}, {});
  EXPECT_EQ(mask.values(), std::vector<std::uint8_t>(6, kMaskBad));
}

// Oracle: a dense walk over the rectangle gives the distance, and its own coordinates the stripe.
TEST(MakeCornellMask, AgreesWithADenseWalk) {
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
    const CornellOptions options{.good_share = 0.5, .dont_care_margin_px = 6};
    const Image mask = MakeCornellMask(40, 30, {corners}, {}, options);
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

TEST(MakeCornellMask, TakesRectanglesOutsideThePicture) {
  const GraspRectangle far = {{{-900, -900}, {-890, -900}, {-890, -880}, {-900, -880}}};
  const GraspRectangle wide = {{{-1e5, -1e5}, {1e5, -1e5}, {1e5, 1e5}, {-1e5, 1e5}}};
  EXPECT_EQ(MakeCornellMask(4, 4, {far}, {}, {}).At(0, 0), kMaskBad);
  EXPECT_EQ(MakeCornellMask(4, 4, {wide}, {}, {}).At(3, 3), kMaskGood);
  EXPECT_EQ(MakeCornellMask(1, 1, {kFlat}, {}, {}).At(0, 0), kMaskDontCare);
  EXPECT_THROW(static_cast<void>(MakeCornellMask(4, 4, {GraspRectangle{}}, {}, {})),
               std::logic_error);
}

TEST(ReadCornellRectangles, ReadsAFileAsItIsDistributed) {
  const auto rectangles =
      ReadText("253 319.7 \r\n309 324 \r\n307 350 \r\n251 346 \r\n1e1\t0\n20 0\n20 5\n10 5\n\n");
  ASSERT_THAT(rectangles, SizeIs(2));
  EXPECT_EQ(rectangles[0][0], (std::array{253.0, 319.7}));
  EXPECT_EQ(rectangles[0][3], (std::array{251.0, 346.0}));
  EXPECT_EQ(rectangles[1][2], (std::array{20.0, 5.0}));
}

TEST(ReadCornellRectangles, LeavesOutWhatHasNoPlaceOrArea) {
  const std::string good = "0 0\n5 0\n5 5\n0 5\n";
  EXPECT_THAT(ReadText("NaN NaN\n1 2\n3 4\nnan 5\n" + good), SizeIs(1));
  EXPECT_THAT(ReadText("1 1\n2 2\n3 3\n4 4\n" + good), SizeIs(1));
  EXPECT_THAT(ReadText(""), IsEmpty());
}

TEST(ReadCornellRectangles, NamesTheLine) {
  EXPECT_THROWS_MESSAGE(
      ReadText("0 0\n5 0\nfive 5\n0 5\n"), Error, HasSubstr("cpos.txt:3: 'five 5' where a corner"));
  EXPECT_THROWS_MESSAGE(ReadText("0 0\n5\n"), Error, HasSubstr(":2: '5'"));
  EXPECT_THROWS_MESSAGE(ReadText("0 0 0\n"), Error, HasSubstr(":1: '0 0 0'"));
  EXPECT_THROWS_MESSAGE(ReadText("0 inf\n"), Error, HasSubstr(":1: '0 inf'"));
  EXPECT_THROWS_MESSAGE(ReadText("0 1e9\n"), Error, HasSubstr(":1: '0 1e9'"));
  EXPECT_THROWS_MESSAGE(ReadText("0 0\n5 0\n5 5\n"), Error, HasSubstr(":3: 3 corners"));
}

}  // namespace
}  // namespace handcraft::datasets
