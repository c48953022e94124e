// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/gram_matrix.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"
#include "tests/trainers/svm/drawn_classes.h"

namespace handcraft::svm {
namespace {

using ::testing::HasSubstr;

using Classes = std::vector<std::uint32_t>;

TEST(FitNormaliser, ByHandAndAConstantColumn) {
  const std::vector<double> values = {1.0, 0.1, 3.0, 0.1, 5.0, 0.1};
  const Normaliser normaliser = FitNormaliser(DesignMatrix<double>{values.data(), 3, 2, 2});
  EXPECT_DOUBLE_EQ(normaliser.mean[0], 3.0);
  EXPECT_DOUBLE_EQ(normaliser.scale[0], std::sqrt(8.0 / 3.0));
  EXPECT_DOUBLE_EQ(normaliser.mean[1], 0.1);
  EXPECT_EQ(normaliser.scale[1], 1.0);
}

TEST(PrepareSamples, OrdersByClassAndFillsUp) {
  const std::vector<float> values = {1, 2, 3, 4, 5, 6, 7, 8};
  const Classes classes = {1, 0, 1, 0};
  const Samples samples = PrepareSamples(
      DesignMatrix<float>{values.data(), 4, 2, 2}, classes, {.mean = {1, 0}, .scale = {2, 1}});
  EXPECT_EQ(samples.rows, (std::vector<std::size_t>{1, 3, 0, 2}));
  EXPECT_EQ(samples.class_begins, (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(samples.stride, 8U);
  EXPECT_EQ(samples.Sample(0)[0], 1.0);
  EXPECT_EQ(samples.Sample(0)[1], 4.0);
  EXPECT_EQ(samples.values[2], 0.0);
  EXPECT_EQ(samples.ClassOf(1), 0U);
  EXPECT_EQ(samples.ClassOf(2), 1U);
  EXPECT_TRUE(samples.single_precision);
}

TEST(PrepareSamples, RefusesWhatCannotBeLearnt) {
  const std::vector<double> values = {1, 2, std::nan(""), 4};
  const DesignMatrix<double> X{values.data(), 4, 1, 1};
  const auto prepare = [](const DesignMatrix<double>& matrix, const Classes& classes) {
    static_cast<void>(PrepareSamples(matrix, classes, {}));
  };
  EXPECT_THROWS_MESSAGE(
      (prepare(X, {0, 0, 0, 0})), Error, HasSubstr("all 4 samples are of one class"));
  EXPECT_THROWS_MESSAGE(
      (prepare({values.data(), 0, 1, 1}, {})), Error, HasSubstr("all 0 samples are of one class"));
  EXPECT_THROWS_MESSAGE(
      (prepare(X, {0, 2, 0, 2})), Error, HasSubstr("class 1 (counted from 0) has no samples"));
  EXPECT_THROWS_MESSAGE(
      (prepare(X, {0, 1, 0, 1})), Error, HasSubstr("row 2, column 0 (counted from 0) is nan"));
  EXPECT_THROWS_MESSAGE((prepare({values.data(), 4, 0, 0}, {0, 1, 0, 1})),
                        Error,
                        HasSubstr("the samples have no features"));
  EXPECT_THROW(prepare(X, {0, 1}), std::logic_error);
}

TEST(ComputeInnerProducts, AreThoseOfTheRowsForAnyNumberOfThreads) {
  // Long rows make small blocks: several of them, the last one not whole.
  const auto drawn =
      DrawClasses<float>({.num_classes = 3, .samples_per_class = 9, .num_features = 7500}, 1);
  const Samples samples = PrepareSamples(drawn.Matrix(), drawn.classes, {});
  const SampleMatrix products = ComputeInnerProducts(samples, 1);
  ASSERT_EQ(products.size, 27U);
  for (std::size_t i = 0; i < products.size; ++i) {
    for (std::size_t k = 0; k < products.size; ++k) {
      double expected = 0.0;
      for (std::size_t j = 0; j < samples.num_features; ++j) {
        expected += samples.Sample(i)[j] * samples.Sample(k)[j];
      }
      // 7500 terms of about 0.7 may be rounded each time, by half an ulp of a sum below 8192.
      EXPECT_NEAR(products.Row(i)[k], expected, 7500 * 4.6e-13);
      EXPECT_EQ(products.Row(i)[k], products.Row(k)[i]);
    }
  }
  EXPECT_EQ(ComputeInnerProducts(samples, 3).values, products.values);
}

TEST(ComputeInnerProducts, OtherSamplesChangeNoBit) {
  const auto drawn = DrawClasses<double>({.num_classes = 2, .samples_per_class = 20}, 2);
  const Samples all = PrepareSamples(drawn.Matrix(), drawn.classes, {});
  DesignMatrix<double> fewer = drawn.Matrix();
  fewer.num_samples = 14;
  const Samples some = PrepareSamples(fewer, std::span(drawn.classes).first(fewer.num_samples), {});
  const SampleMatrix of_all = ComputeInnerProducts(all, 1);
  const SampleMatrix of_some = ComputeInnerProducts(some, 1);
  // The first seven of each class.
  EXPECT_EQ(of_some.Row(0)[1], of_all.Row(0)[1]);
  EXPECT_EQ(of_some.Row(2)[9], of_all.Row(2)[22]);
  EXPECT_EQ(of_some.Row(13)[6], of_all.Row(26)[6]);
}

TEST(ComputeInnerProducts, RefusesAMatrixBeyondTheMemory) {
  const std::size_t n = 16385;
  const std::vector<float> values(n, 1.0F);
  Classes classes(n, 0);
  classes[0] = 1;
  const Samples samples = PrepareSamples(DesignMatrix<float>{values.data(), n, 1, 1}, classes, {});
  EXPECT_THROWS_MESSAGE((ComputeInnerProducts(samples, 1)),
                        Error,
                        HasSubstr("16385 samples make a kernel matrix of 2.0 GiB"));
}

TEST(ComputeGram, NamesTheRowsOfAValueThatIsNotFinite) {
  const std::vector<double> values = {1.0, 1e200, 2.0};
  const Samples samples =
      PrepareSamples(DesignMatrix<double>{values.data(), 3, 1, 1}, Classes{1, 0, 0}, {});
  const features::Similarity cubic{
      .type = features::SimilarityType::kPolynomial, .degree = 3, .gamma = 1.0};
  const SampleMatrix products = ComputeInnerProducts(samples, 1);
  EXPECT_THROWS_MESSAGE((ComputeGram(products, cubic, samples, 1)),
                        Error,
                        HasSubstr("the kernel value of rows 1 and 1 (counted from 0) is inf"));
}

}  // namespace
}  // namespace handcraft::svm
