// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/opencv_scorers.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "lib/features/pixel_scorer.h"
#include "tests/support/matrix_matchers.h"

namespace handcraft::experiments {
namespace {

// A peer that computed something else would make its time meaningless.
TEST(OpenCvScorers, GiveTheProbabilitiesOfOurScorer) {
  Rng rng(1);
  Image image(70, 40);
  for (int v = 0; v < 40; ++v) {
    for (int u = 0; u < 70; ++u) image.At(u, v) = static_cast<std::uint8_t>(rng.UniformInt(256));
  }
  for (const char* text : {"all500", "edges54,energy=log", "window180,energy=abs"}) {
    const features::FeatureSpec spec = features::ParseFeatureSpec(text);
    std::vector<float> weights(static_cast<std::size_t>(spec.NumFeatures()));
    for (float& weight : weights) weight = static_cast<float>(0.02 * rng.Normal());
    const features::PixelScorer scorer(spec, weights, 0.1);
    std::vector<std::byte> memory(scorer.WorkspaceBytes(70, 40) + 64);
    void* aligned = memory.data();
    std::size_t space = memory.size();
    ASSERT_NE(std::align(64, scorer.WorkspaceBytes(70, 40), aligned, space), nullptr);
    FloatImage ours(70, 40);
    scorer.Score({image.Row(0), 70, 40, 70, features::PixelFormat::kGray8},
                 {static_cast<std::byte*>(aligned), space},
                 ours.Row(0),
                 70);
    using handcraft::testing::AreClose;
    EXPECT_TRUE(
        AreClose(ScoreByGathering(image, spec, weights, 0.1F).values(), ours.values(), 1e-4))
        << text;
    EXPECT_TRUE(
        AreClose(ScoreByConvolutions(image, spec, weights, 0.1F).values(), ours.values(), 1e-4))
        << text;
  }
}

}  // namespace
}  // namespace handcraft::experiments
