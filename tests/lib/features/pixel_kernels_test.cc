// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/pixel_kernels.h"

#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "tests/lib/features/feature_oracle.h"

namespace handcraft::features::internal {
namespace {

class PixelKernelsTest : public ::testing::TestWithParam<InstructionSet> {
 protected:
  const PixelKernels& kernels_ = KernelsFor(GetParam());
};

INSTANTIATE_TEST_SUITE_P(EachSet,
                         PixelKernelsTest,
                         ::testing::ValuesIn(SupportedInstructionSets().begin(),
                                             SupportedInstructionSets().end()),
                         [](const auto& param_info) {
                           return std::string(NameOf(param_info.param));
                         });

TEST_P(PixelKernelsTest, ConvertsPixelsAsTheIntegerCodeDoes) {
  for (const PixelFormat format : {PixelFormat::kGray8, PixelFormat::kBgr8, PixelFormat::kRgb8}) {
    const auto picture = features::testing::MakePicture(317, 1, format, 1);
    std::vector<float> y(317 + kSlack), cb(317 + kSlack), cr(317 + kSlack);
    kernels_.convert_row(picture.raw.data, format, 317, y.data(), cb.data(), cr.data());
    for (std::size_t x = 0; x < 317; ++x) {
      const std::uint8_t* p = picture.raw.data + x * static_cast<std::size_t>(NumChannels(format));
      if (format == PixelFormat::kGray8) {
        ASSERT_EQ(y[x], static_cast<float>(p[0]) * (1.0F / 255.0F));
        continue;
      }
      const bool is_rgb = format == PixelFormat::kRgb8;
      const Ycbcr expected = ToYcbcr(p[is_rgb ? 0 : 2], p[1], p[is_rgb ? 2 : 0]);
      ASSERT_EQ(y[x], static_cast<float>(expected.y) * (1.0F / 255.0F)) << x;
      ASSERT_EQ(cb[x], static_cast<float>(expected.cb) * (1.0F / 255.0F)) << x;
      ASSERT_EQ(cr[x], static_cast<float>(expected.cr) * (1.0F / 255.0F)) << x;
    }
  }
}

TEST_P(PixelKernelsTest, ConvertsEveryShade) {
  std::vector<std::uint8_t> colours;
  for (int r = 0; r < 256; r += 5) {
    for (int g = 0; g < 256; g += 5) {
      for (int b = 0; b < 256; b += 5) {
        for (const int value : {r, g, b}) colours.push_back(static_cast<std::uint8_t>(value));
      }
    }
  }
  const int count = static_cast<int>(colours.size() / 3);
  std::vector<float> y(colours.size()), cb(colours.size()), cr(colours.size());
  kernels_.convert_row(colours.data(), PixelFormat::kRgb8, count, y.data(), cb.data(), cr.data());
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const Ycbcr expected = ToYcbcr(colours[3 * i], colours[3 * i + 1], colours[3 * i + 2]);
    ASSERT_EQ(std::lround(y[i] * 255.0F), expected.y);
    ASSERT_EQ(std::lround(cb[i] * 255.0F), expected.cb);
    ASSERT_EQ(std::lround(cr[i] * 255.0F), expected.cr);
  }
}

TEST_P(PixelKernelsTest, SigmoidIsCloseToTheDoubleOne) {
  std::vector<float> values;
  for (double z = -86.0; z <= 86.0; z += 0.0137) values.push_back(static_cast<float>(z));
  std::vector<float> p = values;
  p.resize(values.size() + kSlack);
  kernels_.sigmoid_row(p.data(), static_cast<int>(values.size()));
  double worst = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double expected = 1.0 / (1.0 + std::exp(-static_cast<double>(values[i])));
    worst = std::max(worst, std::abs(static_cast<double>(p[i]) - expected) / expected);
  }
  EXPECT_LT(worst, 3e-7);
}

TEST_P(PixelKernelsTest, SigmoidKeepsToZeroAndOneForHugeValues) {
  std::vector<float> values(kSlack, 0.0F);
  values[0] = 1e30F;
  values[1] = -1e30F;
  values[2] = HUGE_VALF;
  kernels_.sigmoid_row(values.data(), 4);
  EXPECT_EQ(values[0], 1.0F);
  EXPECT_GE(values[1], 0.0F);
  EXPECT_LT(values[1], 1e-37F);
  EXPECT_EQ(values[2], 1.0F);
  EXPECT_EQ(values[3], 0.5F);
}

TEST_P(PixelKernelsTest, CorrelatesAsTheDefinitionSays) {
  for (const int window : {1, 3, 5}) {
    constexpr int kFilters = 7;
    const int count = 61;  // whole blocks, single vectors and a part of one
    const auto energies = features::testing::RandomWeights(kFilters * kStripStride, 1.0, 2);
    const auto weights = features::testing::RandomWeights(kFilters * window * window, 1.0, 3);
    std::vector<std::vector<float>> sums(static_cast<std::size_t>(window));
    CorrelateRowJob job{.energies = energies.data(),
                        .weights = weights.data(),
                        .num_filters = kFilters,
                        .window = window,
                        .count = count};
    for (int j = 0; j < window; ++j) {
      auto& row = sums[static_cast<std::size_t>(j)];
      row.assign(kStripStride, static_cast<float>(j));
      job.sums[static_cast<std::size_t>(j)] = row.data();
    }
    kernels_.correlate_row(job);
    for (int j = 0; j < window; ++j) {
      for (int x = 0; x < count; ++x) {
        double expected = j;
        for (int f = 0; f < kFilters; ++f) {
          for (int i = 0; i < window; ++i) {
            const float weight = weights[static_cast<std::size_t>((f * window + i) * window + j)];
            const int column = x + kMaxRadius + i - window / 2;
            expected +=
                static_cast<double>(weight) *
                static_cast<double>(energies[static_cast<std::size_t>(f * kStripStride + column)]);
          }
        }
        ASSERT_NEAR(sums[static_cast<std::size_t>(j)][static_cast<std::size_t>(x)], expected, 3e-5)
            << "window " << window << " row " << j << " column " << x;
      }
    }
  }
}

TEST(FilterPlan, MarksTheGroupsAndSlots) {
  const FilterPlan plan(ParseFeatureSpec("filters=edge_30+sobel2_7+cr_LL,window=1"));
  EXPECT_EQ(plan.num_filters, 3);
  EXPECT_EQ(plan.slot[static_cast<std::size_t>(Filter::kSobelSecond7)], 1);
  EXPECT_EQ(plan.slot[static_cast<std::size_t>(Filter::kEdge0)], -1);
  EXPECT_TRUE(plan.edges && plan.sobel7 && plan.chroma);
  EXPECT_FALSE(plan.laws || plan.sobel5);
}

}  // namespace
}  // namespace handcraft::features::internal
