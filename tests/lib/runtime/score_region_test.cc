// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// The functions of the C interface that score some pixels of an image.

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tests/lib/runtime/c_interface.h"
#include "tests/lib/runtime/some_models.h"

namespace handcraft {
namespace {

constexpr int kWidth = 70;
constexpr int kHeight = 45;

class ScoreRegion : public ::testing::Test {
 protected:
  ScoreRegion() : all_(kWidth * kHeight) {
    EXPECT_EQ(hc_score_image(model_.get(), workspace_.get(), &image_, all_.data(), kWidth), HC_OK);
  }

  [[nodiscard]] hc_status ScoreMask(const std::vector<std::uint8_t>& mask,
                                    std::int64_t mask_stride,
                                    std::vector<float>& map,
                                    std::int64_t stride) const {
    return hc_score_mask(
        model_.get(), workspace_.get(), &image_, mask.data(), mask_stride, map.data(), stride);
  }

  [[nodiscard]] hc_status ScorePixels(const std::vector<hc_pixel>& pixels,
                                      std::vector<float>& values) const {
    values.assign(pixels.size(), -1.0F);
    return hc_score_pixels(
        model_.get(), workspace_.get(), &image_, pixels.data(), pixels.size(), values.data());
  }

  [[nodiscard]] float At(int u, int v) const {
    return all_[static_cast<std::size_t>(v * kWidth + u)];
  }

  testing::Model model_ = testing::Load(testing::SomeGraspPointModel("window180"));
  testing::Workspace workspace_ = testing::MakeWorkspace(model_, 100, 100);
  Image picture_ = testing::SomePicture(kWidth, kHeight, 3, 1);
  hc_image image_ = testing::View(picture_);
  std::vector<float> all_;
};

TEST_F(ScoreRegion, MasksTheScoresOfTheImage) {
  for (const std::uint64_t one_in : {1U, 3U, 300U}) {  // dense, dense, sparse
    Rng rng(one_in);
    std::vector<std::uint8_t> mask(80 * kHeight);
    for (std::uint8_t& byte : mask) byte = rng.UniformInt(one_in) == 0 ? 255 : 0;
    std::vector<float> map(90 * kHeight, -1.0F);
    ASSERT_EQ(ScoreMask(mask, 80, map, 90), HC_OK);
    for (std::size_t v = 0; v < kHeight; ++v) {
      for (std::size_t u = 0; u < 90; ++u) {
        const float expected = u >= kWidth             ? -1.0F
                               : mask[80 * v + u] == 0 ? 0.0F
                                                       : all_[kWidth * v + u];
        ASSERT_EQ(map[90 * v + u], expected) << u << ' ' << v;
      }
    }
  }
}

TEST_F(ScoreRegion, GivesTheScoresOfListedPixels) {
  std::vector<float> values;
  ASSERT_EQ(ScorePixels({{0, 0}, {69, 0}, {5, 0}, {33, 20}, {33, 20}, {69, 44}}, values), HC_OK);
  EXPECT_EQ(values,
            (std::vector{At(0, 0), At(69, 0), At(5, 0), At(33, 20), At(33, 20), At(69, 44)}));
}

TEST_F(ScoreRegion, TakesAnEmptyListAndAnEmptyMask) {
  EXPECT_EQ(hc_score_pixels(model_.get(), workspace_.get(), &image_, nullptr, 0, nullptr), HC_OK);
  std::vector<float> map(all_.size(), -1.0F);
  ASSERT_EQ(ScoreMask(std::vector<std::uint8_t>(all_.size()), kWidth, map, kWidth), HC_OK);
  EXPECT_EQ(map, std::vector<float>(all_.size(), 0.0F));
}

TEST_F(ScoreRegion, RefusesPixelsOutsideAndRowsThatDescend) {
  std::vector<float> values;
  for (const auto& [u, v] : {std::pair{-1, 0}, {0, -1}, {70, 0}, {0, 45}, {INT32_MAX, INT32_MIN}}) {
    EXPECT_EQ(ScorePixels({{u, v}}, values), HC_ERROR_ARGUMENT) << u << ' ' << v;
  }
  EXPECT_EQ(ScorePixels({{0, 5}, {0, 4}}, values), HC_ERROR_ARGUMENT);
}

TEST_F(ScoreRegion, RefusesWrongArguments) {
  const std::vector<std::uint8_t> mask(all_.size(), 1);
  std::vector<float> map(all_.size());
  EXPECT_EQ(ScoreMask(mask, kWidth - 1, map, kWidth), HC_ERROR_ARGUMENT);
  EXPECT_EQ(ScoreMask(mask, kWidth, map, kWidth - 1), HC_ERROR_ARGUMENT);
  const auto score_mask = [&](const hc_model* model,
                              hc_workspace* workspace,
                              const hc_image* image,
                              const std::uint8_t* bytes,
                              float* out) {
    return hc_score_mask(model, workspace, image, bytes, kWidth, out, kWidth);
  };
  hc_workspace* const workspace = workspace_.get();
  EXPECT_EQ(score_mask(nullptr, workspace, &image_, mask.data(), map.data()), HC_ERROR_ARGUMENT);
  EXPECT_EQ(score_mask(model_.get(), nullptr, &image_, mask.data(), map.data()), HC_ERROR_ARGUMENT);
  EXPECT_EQ(score_mask(model_.get(), workspace, nullptr, mask.data(), map.data()),
            HC_ERROR_ARGUMENT);
  EXPECT_EQ(score_mask(model_.get(), workspace, &image_, nullptr, map.data()), HC_ERROR_ARGUMENT);
  EXPECT_EQ(score_mask(model_.get(), workspace, &image_, mask.data(), nullptr), HC_ERROR_ARGUMENT);
  const testing::Model logistic = testing::Load(testing::SomeLogisticModel());
  EXPECT_EQ(score_mask(logistic.get(), workspace, &image_, mask.data(), map.data()), HC_ERROR_KIND);
  hc_image large = image_;
  large.width = 101;
  EXPECT_EQ(score_mask(model_.get(), workspace, &large, mask.data(), map.data()), HC_ERROR_IMAGE);

  const hc_pixel pixel{1, 1};
  const auto score_pixels = [&](const hc_pixel* pixels, float* out) {
    return hc_score_pixels(model_.get(), workspace, &image_, pixels, 1, out);
  };
  EXPECT_EQ(score_pixels(nullptr, map.data()), HC_ERROR_ARGUMENT);
  EXPECT_EQ(score_pixels(&pixel, nullptr), HC_ERROR_ARGUMENT);
  EXPECT_EQ(hc_score_pixels(logistic.get(), workspace, &image_, &pixel, 1, map.data()),
            HC_ERROR_KIND);
  EXPECT_EQ(hc_score_pixels(model_.get(), workspace, &large, &pixel, 1, map.data()),
            HC_ERROR_IMAGE);
}

}  // namespace
}  // namespace handcraft
