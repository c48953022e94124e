// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/channel_planes.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "tests/lib/features/feature_oracle.h"

namespace handcraft::features::internal {
namespace {

const PixelKernels& Kernels() { return KernelsFor(SupportedInstructionSets().back()); }

TEST(ChannelPlanes, RepeatsTheBorder) {
  const std::vector<std::uint8_t> pixels = {0, 51, 102, 255};
  std::vector<float> memory(ChannelPlanes::NumFloats(2, 2, 1));
  ChannelPlanes planes(2, 2, 1, memory.data());
  planes.Convert({pixels.data(), 2, 2, 2, PixelFormat::kGray8}, Kernels());
  EXPECT_FLOAT_EQ(*planes.At(ChannelPlanes::kY, 1, 0), 0.2F);
  EXPECT_FLOAT_EQ(*planes.At(ChannelPlanes::kY, -kPad, 1), 0.4F);
  EXPECT_FLOAT_EQ(*planes.At(ChannelPlanes::kY, 1 + kSlack, 1), 1.0F);
  EXPECT_FLOAT_EQ(*planes.At(ChannelPlanes::kY, 1, -5), 0.2F);
  EXPECT_FLOAT_EQ(*planes.At(ChannelPlanes::kY, 1, 9), 1.0F);
}

TEST(ChannelPlanes, ConvertsAPartAlone) {
  const std::vector<std::uint8_t> pixels = {0, 51, 102, 255, 0, 153};  // 3 × 2
  const RawImage image{pixels.data(), 3, 2, 3, PixelFormat::kGray8};
  std::vector<float> memory(ChannelPlanes::NumFloats(3, 2, 1), -1.0F);
  ChannelPlanes planes(3, 2, 1, memory.data());
  planes.ConvertPart(image, Kernels(), {.first_u = 1, .last_u = 3, .first_v = 1, .last_v = 2});
  EXPECT_FLOAT_EQ(*planes.At(ChannelPlanes::kY, 1, 1), 0.0F);
  EXPECT_FLOAT_EQ(*planes.At(ChannelPlanes::kY, 2, 1), 0.6F);
  EXPECT_FLOAT_EQ(*planes.At(ChannelPlanes::kY, 2 + kSlack, 1), 0.6F) << "the picture ends there";
  EXPECT_EQ(*planes.At(ChannelPlanes::kY, 0, 1), -1.0F);
  EXPECT_EQ(*planes.At(ChannelPlanes::kY, -1, 1), -1.0F) << "the part does not begin there";
  EXPECT_EQ(*planes.At(ChannelPlanes::kY, 1, 0), -1.0F);
}

TEST(ChannelPlanes, ShrinksByTheMeanOfThePixelsThereAre) {
  const std::vector<std::uint8_t> pixels = {0, 255, 51, 255, 0, 153};  // 3 × 2
  std::vector<float> memory(ChannelPlanes::NumFloats(3, 2, 1));
  ChannelPlanes planes(3, 2, 1, memory.data());
  planes.Convert({pixels.data(), 3, 2, 3, PixelFormat::kGray8}, Kernels());
  std::vector<float> small_memory(ChannelPlanes::NumFloats(2, 1, 1));
  ChannelPlanes small(ShrunkSide(3, 2), ShrunkSide(2, 2), 1, small_memory.data());
  small.ShrinkFrom(planes, 2);
  EXPECT_FLOAT_EQ(*small.At(ChannelPlanes::kY, 0, 0), 0.5F);
  EXPECT_FLOAT_EQ(*small.At(ChannelPlanes::kY, 1, 0), 0.4F);
  EXPECT_FLOAT_EQ(*small.At(ChannelPlanes::kY, 2, 0), 0.4F);
}

TEST(FilterStripRow, RepeatsTheEnergyOfTheLastColumnInside) {
  const auto picture = features::testing::MakePicture(9, 9, PixelFormat::kGray8, 1);
  std::vector<float> memory(ChannelPlanes::NumFloats(9, 9, 1));
  ChannelPlanes planes(9, 9, 1, memory.data());
  planes.Convert(picture.raw, Kernels());
  const FilterPlan plan(ParseFeatureSpec("all500"));
  const auto buffers = std::make_unique<StripBuffers>();
  FilterStripRow(planes, plan, Kernels(), 0, 9, 4, *buffers);
  for (int filter = 0; filter < plan.num_filters; ++filter) {
    const float* row = buffers->energies.data() + filter * kStripStride;
    EXPECT_EQ(row[0], row[kMaxRadius]);
    EXPECT_EQ(row[1], row[kMaxRadius]);
    EXPECT_EQ(row[9 + kMaxRadius], row[8 + kMaxRadius]);
    EXPECT_EQ(row[9 + kMaxRadius + 1], row[8 + kMaxRadius]);
  }
}

// A piece that starts one column right of the border is the same row moved.
TEST(FilterStripRow, StartsAtAnyColumn) {
  const auto picture = features::testing::MakePicture(60, 9, PixelFormat::kGray8, 1);
  std::vector<float> memory(ChannelPlanes::NumFloats(60, 9, 1));
  ChannelPlanes planes(60, 9, 1, memory.data());
  planes.Convert(picture.raw, Kernels());
  const FilterPlan plan(ParseFeatureSpec("all500"));
  const auto whole = std::make_unique<StripBuffers>();
  const auto piece = std::make_unique<StripBuffers>();
  FilterStripRow(planes, plan, Kernels(), 0, 60, 4, *whole);
  for (const int first : {1, 2, 3, 17, 55}) {
    FilterStripRow(planes, plan, Kernels(), first, 60 - first, 4, *piece);
    for (int filter = 0; filter < plan.num_filters; ++filter) {
      for (int i = 0; i < 60 - first + 2 * kMaxRadius; ++i) {
        ASSERT_EQ(piece->energies[static_cast<std::size_t>(filter * kStripStride + i)],
                  whole->energies[static_cast<std::size_t>(filter * kStripStride + first + i)])
            << first << ' ' << filter << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace handcraft::features::internal
