// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/object_region.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "datasets/synthetic/grasp_point_set.h"
#include "lib/core/error.h"
#include "lib/perception/image_io.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;

class ObjectRegionTest : public ::testing::Test {
 protected:
  [[nodiscard]] perception::SearchRegion Find() const {
    return FindObjectRegion(set_, 0, perception::ReadImage(set_.root / set_.items[0].image));
  }

  testing::TemporaryDirectory folder_;
  datasets::LabelledImageSet set_ =
      synthetic::MakeGraspPointSet(folder_ / "made",
                                   {.num_images = 1,
                                    .camera = {.width_px = 320,
                                               .height_px = 240,
                                               .focal_px = 262.5F,
                                               .centre_u_px = 159.5F,
                                               .centre_v_px = 119.5F}})
          .set;
};

TEST_F(ObjectRegionTest, LiesMostlyOnTheObject) {
  const Image region = Find().mask;
  const Image object =
      perception::ReadImage(set_.root / set_.items[0].Companion(datasets::kObjectMask));
  std::size_t inside = 0;
  std::size_t on_object = 0;
  for (std::size_t i = 0; i < region.values().size(); ++i) {
    if (region.values()[i] == 0) continue;
    ++inside;
    on_object += object.values()[i] != 0 ? 1 : 0;
  }
  ASSERT_GT(inside, 20U);
  EXPECT_LT(inside, region.values().size() / 4);
  EXPECT_GT(2 * on_object, inside);
}

TEST_F(ObjectRegionTest, RequiresDepthOfEveryPicture) {
  EXPECT_NO_THROW(RequireDepth(set_));
  set_.items.push_back(set_.items[0]);
  set_.items.back().image = "bare.png";
  set_.items.back().others.clear();
  EXPECT_THROWS_MESSAGE(
      RequireDepth(set_), Error, AllOf(HasSubstr("bare.png"), HasSubstr("as 1 of 2 pictures")));
}

TEST_F(ObjectRegionTest, NamesTheFileThatIsMissing) {
  const std::string scene = set_.items[0].Companion(datasets::kScene);
  std::filesystem::remove(set_.root / scene);
  EXPECT_THROWS_MESSAGE(static_cast<void>(Find()), Error, HasSubstr(scene));
}

}  // namespace
}  // namespace handcraft::experiments
