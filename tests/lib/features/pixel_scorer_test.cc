// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/pixel_scorer.h"

#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "lib/features/pixel_features.h"
#include "tests/lib/features/feature_oracle.h"
#include "tests/support/allocation_counter.h"

namespace handcraft::features {
namespace {

using features::testing::MakePicture;
using features::testing::Picture;
using features::testing::RandomWeights;

// 64-byte aligned scratch memory.
class Workspace {
 public:
  explicit Workspace(std::size_t size)
      : size_(size), bytes_(static_cast<std::byte*>(::operator new (size, std::align_val_t{64}))) {}
  [[nodiscard]] std::span<std::byte> span() const { return {bytes_.get(), size_}; }

 private:
  struct Free {
    void operator()(std::byte* p) const { ::operator delete (p, std::align_val_t{64}); }
  };
  std::size_t size_;
  std::unique_ptr<std::byte, Free> bytes_;
};

std::vector<float> Score(const PixelScorer& scorer,
                         const RawImage& image,
                         bool probability = false) {
  const Workspace workspace(scorer.WorkspaceBytes(image.width, image.height));
  std::vector<float> out(
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), -1.0F);
  if (probability) {
    scorer.Score(image, workspace.span(), out.data(), image.width);
  } else {
    scorer.ScoreDecisionValues(image, workspace.span(), out.data(), image.width);
  }
  return out;
}

struct Case {
  const char* spec;
  int width;
  int height;
  PixelFormat format;
};

class PixelScorerTest : public ::testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(
    Pictures,
    PixelScorerTest,
    ::testing::Values(Case{"all500", 300, 40, PixelFormat::kGray8},
                      Case{"all500,energy=log", 131, 17, PixelFormat::kBgr8},
                      Case{"edges150,energy=abs", 128, 9, PixelFormat::kRgb8},
                      Case{"window180", 129, 12, PixelFormat::kGray8},
                      Case{"edges54", 257, 5, PixelFormat::kGray8},
                      Case{"saxena459", 140, 50, PixelFormat::kBgr8},
                      Case{"filters=edge_30+cr_LL,window=1,scales=16", 70, 20, PixelFormat::kRgb8},
                      Case{"all500", 1, 1, PixelFormat::kGray8},
                      Case{"all500", 4, 4, PixelFormat::kGray8},
                      Case{"saxena459", 2, 3, PixelFormat::kBgr8},
                      Case{"all500", 1, 9, PixelFormat::kBgr8},
                      Case{"all500", 10000, 3, PixelFormat::kGray8}));

// The trainer's sum over gathered features in double is the oracle: every pixel, every set.
TEST_P(PixelScorerTest, EqualsTheSumOverGatheredFeatures) {
  const Case& c = GetParam();
  const FeatureSpec spec = ParseFeatureSpec(c.spec);
  const Picture picture = MakePicture(c.width, c.height, c.format, 1, 3);
  const auto weights = RandomWeights(spec.NumFeatures(), 0.1, 2);
  for (const InstructionSet set : SupportedInstructionSets()) {
    const PixelScorer scorer(spec, weights, 0.25, set);
    const std::vector<float> scores = Score(scorer, picture.raw);
    const PixelFeatures features(picture.raw, spec, set);
    std::vector<float> x(weights.size());
    for (int v = 0; v < c.height; ++v) {
      for (int u = 0; u<c.width; u += c.width> 200 && u > 5 && u < c.width - 6 ? 5 : 1) {
        features.Gather(u, v, x);
        double z = 0.25;
        double size = 1.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
          const double term = static_cast<double>(weights[i]) * static_cast<double>(x[i]);
          z += term;
          size += std::abs(term);
        }
        const float score = scores[static_cast<std::size_t>(v * c.width + u)];
        ASSERT_NEAR(score, z, 2e-6 * size) << NameOf(set) << " at " << u << ", " << v;
      }
    }
  }
}

TEST_P(PixelScorerTest, FusedSetsGiveTheSameBits) {
  const Case& c = GetParam();
  const FeatureSpec spec = ParseFeatureSpec(c.spec);
  const Picture picture = MakePicture(c.width, c.height, c.format, 1);
  const auto weights = RandomWeights(spec.NumFeatures(), 0.1, 2);
  const auto best = Score(PixelScorer(spec, weights, -0.5), picture.raw, true);
  for (const InstructionSet set : SupportedInstructionSets()) {
    if (set < InstructionSet::kNeon) continue;
    EXPECT_EQ(Score(PixelScorer(spec, weights, -0.5, set), picture.raw, true), best) << NameOf(set);
  }
}

// Some masks of a picture: rows and columns at its borders, a ring, scattered pixels, all, none.
std::vector<std::vector<std::uint8_t>> SomeMasks(int width, int height) {
  const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<std::vector<std::uint8_t>> masks(5, std::vector<std::uint8_t>(size));
  Rng rng = Rng::Stream(1, "masks");
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const auto i = static_cast<std::size_t>(v * width + u);
      const bool is_border = u == 0 || v == 0 || u == width - 1 || v == height - 1;
      masks[0][i] = is_border ? 1 : 0;
      const double radius = std::hypot(u - 0.5 * width, v - 0.5 * height);
      masks[1][i] = std::abs(radius - 0.3 * std::min(width, height)) < 2.0 ? 255 : 0;
      masks[2][i] = rng.UniformInt(20) == 0 ? 7 : 0;
      masks[3][i] = 1;
    }
  }
  return masks;
}

TEST_P(PixelScorerTest, ScoresWantedPixelsInEitherWayToTheSameBits) {
  const Case& c = GetParam();
  const FeatureSpec spec = ParseFeatureSpec(c.spec);
  const Picture picture = MakePicture(c.width, c.height, c.format, 1, 3);
  for (const InstructionSet set : SupportedInstructionSets()) {
    const PixelScorer scorer(spec, RandomWeights(spec.NumFeatures(), 0.1, 2), 0.25, set);
    const std::vector<float> all = Score(scorer, picture.raw, true);
    const Workspace workspace(scorer.WorkspaceBytes(c.width, c.height));
    for (const auto& wanted : SomeMasks(c.width, c.height)) {
      std::vector<float> expected = all;
      std::vector<PixelPosition> pixels;
      std::vector<float> expected_list;
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (wanted[i] == 0) expected[i] = 0.0F;
        if (wanted[i] == 0) continue;
        pixels.push_back({static_cast<int>(i) % c.width, static_cast<int>(i) / c.width});
        expected_list.push_back(all[i]);
      }
      for (const ScoringWay way : {ScoringWay::kDense, ScoringWay::kSparse}) {
        std::vector<float> map(all.size(), -1.0F);
        scorer.ScoreMask(
            picture.raw, {wanted.data(), c.width}, way, workspace.span(), map.data(), c.width);
        ASSERT_EQ(map, expected) << NameOf(set) << static_cast<int>(way);
      }
      std::vector<float> list(pixels.size(), -1.0F);
      scorer.ScorePixels(picture.raw, pixels, workspace.span(), list.data());
      ASSERT_EQ(list, expected_list) << NameOf(set);
    }
  }
}

TEST(PixelScorer, TakesTheSparseWayForOutlinesAndTheDenseForAll) {
  const PixelScorer scorer(ParseFeatureSpec("window180"), RandomWeights(180, 0.1, 2), 0.0);
  const auto masks = SomeMasks(300, 200);
  const auto way = [&](std::size_t i) {
    return scorer.CheaperWay(300, 200, {masks[i].data(), 300});
  };
  EXPECT_EQ(way(1), ScoringWay::kSparse) << "a ring";
  EXPECT_EQ(way(2), ScoringWay::kDense) << "one pixel in twenty, everywhere";
  EXPECT_EQ(way(3), ScoringWay::kDense) << "all";
  EXPECT_EQ(way(4), ScoringWay::kSparse) << "none";
}

// What a run takes besides its filters weighs more where there are few of them.
TEST(PixelScorer, TakesTheDenseWaySoonerWithFewFilters) {
  Rng rng(1);
  std::vector<std::uint8_t> wanted(640 * 480);
  for (std::uint8_t& byte : wanted) byte = rng.UniformInt(100) == 0 ? 1 : 0;
  const auto way = [&](const char* spec, int num_features) {
    const PixelScorer scorer(ParseFeatureSpec(spec), RandomWeights(num_features, 0.1, 2), 0.0);
    return scorer.CheaperWay(640, 480, {wanted.data(), 640});
  };
  EXPECT_EQ(way("edges54", 54), ScoringWay::kDense);
  EXPECT_EQ(way("window180", 180), ScoringWay::kSparse);
  EXPECT_EQ(way("all500", 500), ScoringWay::kSparse);
}

TEST(PixelScorer, TakesAPixelTwiceAndAnyColumnOrder) {
  const FeatureSpec spec = ParseFeatureSpec("edges54");
  const Picture picture = MakePicture(33, 7, PixelFormat::kGray8, 4);
  const PixelScorer scorer(spec, RandomWeights(54, 1.0, 5), 0.0);
  const auto all = Score(scorer, picture.raw, true);
  const Workspace workspace(scorer.WorkspaceBytes(33, 7));
  const std::vector<PixelPosition> pixels = {{9, 2}, {3, 2}, {9, 2}};
  std::vector<float> list(3);
  scorer.ScorePixels(picture.raw, pixels, workspace.span(), list.data());
  EXPECT_EQ(list, (std::vector{all[2 * 33 + 9], all[2 * 33 + 3], all[2 * 33 + 9]}));
}

// One weight on edge_0 of the right neighbour: the score is that energy, moved one column.
TEST(PixelScorer, PutsAWeightWhereItBelongs) {
  const FeatureSpec spec = ParseFeatureSpec("edges150");
  const Picture picture = MakePicture(30, 20, PixelFormat::kGray8, 3);
  std::vector<float> weights(150, 0.0F);
  weights[6 * (5 * 2 + 3) + 0] = 1.0F;  // dv = 0, du = +1, edge_0
  const auto scores = Score(PixelScorer(spec, weights, 0.0), picture.raw);
  const PixelFeatures features(picture.raw, spec);
  for (int u = 0; u < 30; ++u) {
    EXPECT_EQ(scores[static_cast<std::size_t>(8 * 30 + u)],
              features.EnergyPlane(0).At(std::min(u + 1, 29), 8));
  }
}

TEST(PixelScorer, ProbabilityIsTheSigmoidOfTheDecisionValue) {
  const FeatureSpec spec = ParseFeatureSpec("edges54");
  const Picture picture = MakePicture(50, 50, PixelFormat::kGray8, 4);
  const PixelScorer scorer(spec, RandomWeights(54, 3.0, 5), 0.1);
  const auto z = Score(scorer, picture.raw);
  const auto p = Score(scorer, picture.raw, true);
  for (std::size_t i = 0; i < z.size(); ++i) {
    ASSERT_NEAR(p[i], 1.0 / (1.0 + std::exp(-static_cast<double>(z[i]))), 2e-7);
  }
}

TEST(PixelScorer, WritesOnlyThePixelsOfTheStridedOutput) {
  const FeatureSpec spec = ParseFeatureSpec("edges54");
  const Picture picture = MakePicture(33, 7, PixelFormat::kGray8, 4);
  const PixelScorer scorer(spec, RandomWeights(54, 1.0, 5), 0.0);
  const Workspace workspace(scorer.WorkspaceBytes(33, 7));
  std::vector<float> out(40 * 7, -1.0F);
  scorer.Score(picture.raw, workspace.span(), out.data(), 40);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (i % 40 < 33) {
      EXPECT_GE(out[i], 0.0F);
    } else {
      EXPECT_EQ(out[i], -1.0F);
    }
  }
}

TEST(PixelScorer, ASmallerPictureFitsTheWorkspaceOfALarger) {
  const FeatureSpec spec = ParseFeatureSpec("saxena459");
  const Picture picture = MakePicture(20, 10, PixelFormat::kRgb8, 4);
  const PixelScorer scorer(spec, RandomWeights(459, 1.0, 5), 0.0);
  EXPECT_LE(scorer.WorkspaceBytes(20, 10), scorer.WorkspaceBytes(64, 48));
}

TEST(PixelScorer, AllocatesNothing) {
  if (!handcraft::testing::AllocationCounter::Available()) GTEST_SKIP() << "sanitizer build";
  const FeatureSpec spec = ParseFeatureSpec("saxena459,energy=log");
  const Picture picture = MakePicture(64, 48, PixelFormat::kBgr8, 4);
  const PixelScorer scorer(spec, RandomWeights(459, 1.0, 5), 0.0);
  const Workspace workspace(scorer.WorkspaceBytes(64, 48));
  std::vector<float> out(64 * 48);
  const std::vector<std::uint8_t> wanted(64 * 48, 1);
  const PixelMask mask{wanted.data(), 64};
  const std::vector<PixelPosition> pixels = {{5, 6}};
  const handcraft::testing::AllocationCounter counter;
  scorer.Score(picture.raw, workspace.span(), out.data(), 64);
  scorer.ScoreMask(
      picture.raw, mask, scorer.CheaperWay(64, 48, mask), workspace.span(), out.data(), 64);
  scorer.ScorePixels(picture.raw, pixels, workspace.span(), out.data());
  EXPECT_EQ(counter.Count(), 0U);
}

TEST(PixelScorer, RefusesAWrongNumberOfWeights) {
  EXPECT_THROW(PixelScorer(ParseFeatureSpec("edges54"), RandomWeights(53, 1.0, 1), 0.0),
               std::logic_error);
}

}  // namespace
}  // namespace handcraft::features
