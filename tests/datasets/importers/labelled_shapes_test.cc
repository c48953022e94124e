// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/labelled_shapes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <opencv2/imgproc.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using Letters = std::vector<std::string>;

// One letter a pixel: G good, . bad, - don't care.
Letters Draw(int width, int height, const std::vector<LabelledShape>& shapes) {
  const Image mask = DrawLabelledShapes("shapes.json", width, height, shapes);
  Letters rows;
  for (int v = 0; v < height; ++v) {
    rows.emplace_back();
    for (int u = 0; u < width; ++u) {
      rows.back() += mask.At(u, v) == kMaskGood ? 'G' : mask.At(u, v) == kMaskBad ? '.' : '-';
    }
  }
  return rows;
}

// What is good; nothing where the shape is refused.
Image DrawnOrNothing(int width, int height, const ShapeGeometry& geometry) {
  try {
    return DrawLabelledShapes("shapes.json", width, height, {{geometry, kMaskGood}});
  } catch (const Error&) {
    return {width, height, 1, kMaskBad};
  }
}

Polygon Box(double left, double top, double right, double bottom) {
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

TEST(DrawLabelledShapes, FillsThePixelsWhoseMiddleIsInside) {
  EXPECT_EQ(Draw(4, 3, {{Box(1, 1, 3, 2), kMaskGood}}), (Letters{"....", ".GG.", "...."}));
  EXPECT_EQ(Draw(4, 3, {{Box(1.4, 0.6, 2.6, 1.6), kMaskGood}}), (Letters{"....", ".GG.", "...."}));
  EXPECT_EQ(Draw(4, 3, {{Box(1.6, 0.6, 2.4, 2.6), kMaskGood}}), (Letters{"....", "....", "...."}));
  // The slope passes (10/3, ½), (2, 3/2) and (2/3, 5/2).
  EXPECT_EQ(Draw(4, 3, {{Polygon{{0, 0}, {4, 0}, {0, 3}}, kMaskGood}}),
            (Letters{"GGG.", "GG..", "G..."}));
}

TEST(DrawLabelledShapes, LeavesHolesWhereTheOutlineGoesRoundTwice) {
  const Polygon ring = {
      {0, 0}, {5, 0}, {5, 5}, {0, 5}, {0, 0}, {1, 1}, {4, 1}, {4, 4}, {1, 4}, {1, 1}};
  EXPECT_EQ(Draw(5, 5, {{ring, kMaskGood}}),
            (Letters{"GGGGG", "G...G", "G...G", "G...G", "GGGGG"}));
}

TEST(DrawLabelledShapes, LetsDontCareOverruleBadAndBadGood) {
  const LabelledShape good{Box(0, 0, 4, 1), kMaskGood};
  const LabelledShape bad{Box(1, 0, 5, 1), kMaskBad};
  const LabelledShape dont_care{Box(2, 0, 3, 1), kMaskDontCare};
  EXPECT_EQ(Draw(5, 1, {good, bad, dont_care}), (Letters{"G.-.."}));
  EXPECT_EQ(Draw(5, 1, {dont_care, bad, good}), (Letters{"G.-.."}));
}

TEST(DrawLabelledShapes, DrawsRunsDownTheColumns) {
  EXPECT_EQ(Draw(3, 2, {{PixelRuns{1, 3, 2}, kMaskGood}}), (Letters{".G.", "GG."}));
  EXPECT_EQ(Draw(3, 2, {{PixelRuns{0, 1, 4, 1}, kMaskGood}}), (Letters{"G..", "..G"}));
  EXPECT_EQ(Draw(3, 2, {{PixelRuns{6}, kMaskGood}}), (Letters{"...", "..."}));
  EXPECT_THROW(
      static_cast<void>(DrawLabelledShapes("shapes.json", 3, 2, {{PixelRuns{1, 4}, kMaskGood}})),
      std::logic_error);
}

// Oracle: OpenCV's test of a point, for each pixel. Corners are eighths, so that single precision
// holds them and no corner is a middle; a middle on the line may be either.
TEST(DrawLabelledShapes, DrawsSpans) {
  EXPECT_EQ(Draw(3, 2, {{PixelSpans{{0, 1, 3}, {1, 0, 1}, {1, 2, 2}}, kMaskGood}}),
            (Letters{".GG", "G.."}));
  for (const PixelSpan span : {PixelSpan{2, 0, 1}, {-1, 0, 1}, {0, -1, 1}, {0, 0, 4}, {0, 2, 1}}) {
    EXPECT_THROW(Draw(3, 2, {{PixelSpans{span}, kMaskGood}}), std::logic_error);
  }
}

TEST(DrawLabelledShapes, AgreesWithPointPolygonTest) {
  Rng rng(11);
  for (int round = 0; round < 60; ++round) {
    Polygon polygon(3 + rng.UniformInt(6));
    std::vector<cv::Point2f> contour;
    for (auto& [x, y] : polygon) {
      x = static_cast<double>(rng.UniformInt(45 * 4)) / 4 - 10 + 0.125;
      y = static_cast<double>(rng.UniformInt(40 * 4)) / 4 - 10 + 0.125;
      contour.emplace_back(static_cast<float>(x), static_cast<float>(y));
    }
    const Image mask = DrawnOrNothing(25, 20, polygon);
    for (int v = 0; v < 20; ++v) {
      for (int u = 0; u < 25; ++u) {
        const cv::Point2f middle(static_cast<float>(u) + 0.5F, static_cast<float>(v) + 0.5F);
        const double side = cv::pointPolygonTest(contour, middle, false);
        if (side == 0.0) continue;
        EXPECT_EQ(mask.At(u, v) == kMaskGood, side > 0.0) << round << ": " << u << ' ' << v;
      }
    }
  }
}

// Oracle: the distance of each pixel's middle.
TEST(DrawLabelledShapes, AgreesWithTheDistanceFromACentre) {
  Rng rng(12);
  for (int round = 0; round < 50; ++round) {
    const Circle circle{{40 * rng.Uniform() - 10, 30 * rng.Uniform() - 5}, 12 * rng.Uniform()};
    const Image mask = DrawnOrNothing(25, 20, circle);
    for (int v = 0; v < 20; ++v) {
      for (int u = 0; u < 25; ++u) {
        const double distance = std::hypot(u + 0.5 - circle.centre[0], v + 0.5 - circle.centre[1]);
        EXPECT_EQ(mask.At(u, v) == kMaskGood, distance < circle.radius);
      }
    }
  }
}

// Oracle: the runs written out, one pixel after another.
TEST(DrawLabelledShapes, AgreesWithRunsWrittenOut) {
  Rng rng(13);
  for (int round = 0; round < 50; ++round) {
    std::vector<std::uint8_t> pixels;
    PixelRuns runs;
    while (pixels.size() < 7 * 9) {
      const std::size_t run = std::min<std::size_t>(rng.UniformInt(12), 7 * 9 - pixels.size());
      pixels.insert(pixels.end(), run, runs.size() % 2 == 0 ? kMaskBad : kMaskDontCare);
      runs.push_back(static_cast<std::uint32_t>(run));
    }
    const Image mask = DrawLabelledShapes("shapes.json", 7, 9, {{runs, kMaskDontCare}});
    for (int i = 0; i < 7 * 9; ++i) {
      EXPECT_EQ(mask.At(i / 9, i % 9), pixels[static_cast<std::size_t>(i)]);
    }
  }
}

TEST(DrawLabelledShapes, TakesShapesWithoutAreaAndLargerThanThePicture) {
  const double far = kFarthest_px;
  EXPECT_EQ(Draw(2, 1, {{Polygon{}, kMaskGood}}), (Letters{".."}));
  EXPECT_EQ(Draw(2, 1, {{Polygon{{0.5, 0.5}, {1.5, 0.5}, {0.5, 0.5}}, kMaskGood}}),
            (Letters{".."}));
  EXPECT_EQ(Draw(2, 1, {{Circle{{0.5, 0.5}, 0.0}, kMaskGood}}), (Letters{".."}));
  EXPECT_EQ(Draw(2, 1, {{Box(-far, -far, far, far), kMaskGood}}), (Letters{"GG"}));
  // Less than a pixel beyond the edge, as rounding may bring it.
  EXPECT_EQ(Draw(2, 1, {{Box(2.0, 0, 2.9, 1), kMaskGood}}), (Letters{".."}));
}

TEST(NotesOnShapes, NamesThoseThatCoverNothing) {
  const std::vector<Fault> notes =
      NotesOnShapes("shapes.json",
                    2,
                    1,
                    {{Box(0, 0, 1, 1), kMaskGood, "a"},
                     {Polygon{{0.5, 0.5}, {1.5, 0.5}, {0.5, 0.5}}, kMaskGood, "b"},
                     {Circle{{0.5, 0.5}, 0.0}, kMaskDontCare, "c"},
                     {PixelRuns{2}, kMaskGood, "d"},
                     {PixelRuns{2, 0}, kMaskBad, "e"},
                     {PixelRuns{1, 1}, kMaskBad, "f"},
                     {PixelSpans{}, kMaskGood, "g"},
                     {PixelSpans{{0, 1, 1}}, kMaskGood, "h"},
                     {PixelSpans{{0, 1, 2}}, kMaskGood, "i"}});
  std::string places;
  for (const Fault& note : notes) {
    EXPECT_EQ(note.path, "shapes.json");
    EXPECT_EQ(note.gravity, Gravity::kNote);
    EXPECT_THAT(note.reason, HasSubstr(": the shape covers no pixel"));
    places += note.reason.front();
  }
  EXPECT_EQ(places, "bcdegh");
  EXPECT_THROW(
      static_cast<void>(NotesOnShapes("shapes.json", 2, 1, {{Circle{{9, 9}, 3.0}, kMaskGood}})),
      Error);
}

TEST(DrawLabelledShapes, RefusesShapesOutsideThePicture) {
  const double far = kFarthest_px;
  const auto refuses = [](const ShapeGeometry& geometry) {
    EXPECT_THROWS_MESSAGE(
        Draw(2, 1, {{Box(0, 0, 1, 1), kMaskGood}, {geometry, kMaskDontCare, "at /shapes/7"}}),
        Error,
        HasSubstr("shapes.json: at /shapes/7: the shape lies outside its picture of 2x1 pixels "
                  "(draw it where"));
  };
  refuses(Box(-far, -far, -far / 2, far));
  refuses(Box(0, 3, 2, 5));
  refuses(Box(0, -5, 2, -3));
  refuses(Polygon{{3, -3}, {9, 3}, {9, -3}});
  refuses(Circle{{far, far}, 3.0});
  refuses(Circle{{-5, 0.5}, 4.0});
}

}  // namespace
}  // namespace handcraft::datasets
