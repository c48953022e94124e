// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// The energies against OpenCV: filter2D with the kernels of the bank, and its own Sobel, Laplacian.

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "lib/features/pixel_features.h"
#include "tests/lib/features/feature_oracle.h"

namespace handcraft::features {
namespace {

cv::Mat ToFloatMat(const RawImage& raw) {
  const cv::Mat bytes(raw.height, raw.width, CV_8UC1, const_cast<std::uint8_t*>(raw.data));
  cv::Mat values;
  bytes.convertTo(values, CV_32F, 1.0 / 255.0);
  return values;
}

// Largest |a − b| / max(1, b).
double WorstDifference(const ImageView<float>& ours, const cv::Mat& theirs) {
  double worst = 0.0;
  for (int y = 0; y < ours.height; ++y) {
    for (int x = 0; x < ours.width; ++x) {
      const double expected = static_cast<double>(theirs.at<float>(y, x));
      worst = std::max(
          worst, std::abs(static_cast<double>(ours.At(x, y)) - expected) / std::max(1.0, expected));
    }
  }
  return worst;
}

TEST(OpenCvOracle, Filter2DGivesTheSameEnergies) {
  const auto picture = testing::MakePicture(97, 61, PixelFormat::kGray8, 1);
  const FeatureSpec spec = ParseFeatureSpec("all500");
  const PixelFeatures features(picture.raw, spec);
  const cv::Mat y = ToFloatMat(picture.raw);
  for (int f = 0; f < spec.NumFilters(); ++f) {
    const FilterKernels kernels = KernelsOf(spec.filters[static_cast<std::size_t>(f)]);
    cv::Mat energy = cv::Mat::zeros(y.size(), CV_32F);
    for (int c = 0; c < kernels.num_components; ++c) {
      cv::Mat kernel(kKernelSize, kKernelSize, CV_32F);
      for (int i = 0; i < kKernelSize; ++i) {
        for (int j = 0; j < kKernelSize; ++j) {
          kernel.at<float>(i, j) =
              kernels.components[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)]
                                [static_cast<std::size_t>(j)];
        }
      }
      cv::flip(kernel, kernel, -1);  // filter2D correlates
      cv::Mat response;
      cv::filter2D(y, response, CV_32F, kernel, cv::Point(-1, -1), 0, cv::BORDER_REPLICATE);
      energy += response.mul(response);
    }
    EXPECT_LT(WorstDifference(features.EnergyPlane(f), energy), 2e-6)
        << NameOf(spec.filters[static_cast<std::size_t>(f)]);
  }
}

cv::Mat SobelEnergy(const cv::Mat& y, int order, int size) {
  cv::Mat sum = cv::Mat::zeros(y.size(), CV_32F);
  for (const bool along_x : {true, false}) {
    cv::Mat kernel_x;
    cv::Mat kernel_y;
    cv::getDerivKernels(
        kernel_x, kernel_y, along_x ? order : 0, along_x ? 0 : order, size, true, CV_32F);
    cv::Mat response;
    cv::sepFilter2D(
        y, response, CV_32F, kernel_x, kernel_y, cv::Point(-1, -1), 0, cv::BORDER_REPLICATE);
    sum += response.mul(response);
  }
  return sum;
}

TEST(OpenCvOracle, SobelChannelsAreOpenCvsNormalisedDerivatives) {
  const auto picture = testing::MakePicture(80, 60, PixelFormat::kGray8, 2);
  const PixelFeatures features(picture.raw, ParseFeatureSpec("filters=sobel,window=1"));
  const cv::Mat y = ToFloatMat(picture.raw);
  EXPECT_LT(WorstDifference(features.EnergyPlane(0), SobelEnergy(y, 1, 5)), 2e-6);
  EXPECT_LT(WorstDifference(features.EnergyPlane(1), SobelEnergy(y, 2, 5)), 2e-6);
  EXPECT_LT(WorstDifference(features.EnergyPlane(2), SobelEnergy(y, 1, 7)), 2e-6);
  EXPECT_LT(WorstDifference(features.EnergyPlane(3), SobelEnergy(y, 2, 7)), 2e-6);
}

TEST(OpenCvOracle, LaplacianIsOpenCvs) {
  const auto picture = testing::MakePicture(80, 60, PixelFormat::kGray8, 2);
  const PixelFeatures features(picture.raw, ParseFeatureSpec("filters=laplacian,window=1"));
  cv::Mat response;
  cv::Laplacian(ToFloatMat(picture.raw), response, CV_32F, 1, 1, 0, cv::BORDER_REPLICATE);
  EXPECT_LT(WorstDifference(features.EnergyPlane(0), response.mul(response)), 2e-6);
}

}  // namespace
}  // namespace handcraft::features
