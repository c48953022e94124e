// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/pcl_table_peer.h"

#include "tests/lib/perception/table_scene.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

// With the library: the block stands alone, as with ours. Without: the builder is told.
TEST(PclTablePeer, RemovesTheTableOrSaysThatItIsNotThere) {
  auto cloud = perception::testing::TableWithBlock();
  cloud.At(0, 0).setConstant(perception::testing::kNaN);
  if (!PclTablePeer::IsAvailable()) {
    EXPECT_THROWS_MESSAGE(PclTablePeer(cloud.View()),
                          std::logic_error,
                          ::testing::HasSubstr("-DHANDCRAFT_PCL_PEER=ON"));
    return;
  }
  const auto pixels = PclTablePeer(cloud.View()).PixelsOffTable({});
  ASSERT_EQ(pixels.size(), 400U);
  EXPECT_EQ(pixels.front(), 20 * 80 + 30);
}

}  // namespace
}  // namespace handcraft::experiments
