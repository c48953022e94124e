// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/image_io.h"

#include <cstring>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/perception/image_header.h"
#include "lib/perception/palette_indices.h"

namespace handcraft::perception {
namespace {

// OpenCV tells its troubles on stderr; what people are to read is our Error alone.
void SilenceOpenCv() {
  static const auto kPrevious =
      cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  static_cast<void>(kPrevious);
}

cv::Mat Decode(const std::filesystem::path& path,
               const std::vector<std::uint8_t>& bytes,
               const ImageHeader& header,
               int flags) {
  SilenceOpenCv();
  cv::Mat pixels;
  try {
    pixels = cv::imdecode(bytes, flags);
  } catch (const cv::Exception& exception) {
    throw Error({.path = path.string(), .reason = "cannot be decoded: " + exception.err});
  }
  if (pixels.empty()) {
    throw Error({.path = path.string(),
                 .reason = "a damaged " + std::string(header.format) + " that cannot be decoded",
                 .remedy = "copy it again from its source"});
  }
  return pixels;
}

template <class T>
BasicImage<T> ToImage(const cv::Mat& pixels) {
  BasicImage<T> image(pixels.cols, pixels.rows, pixels.channels());
  const std::size_t row_bytes = static_cast<std::size_t>(pixels.cols) * pixels.elemSize();
  for (int v = 0; v < pixels.rows; ++v) std::memcpy(image.Row(v), pixels.ptr(v), row_bytes);
  return image;
}

template <class T>
void EncodePng(const std::filesystem::path& path, const BasicImage<T>& image, int type) {
  SilenceOpenCv();
  // OpenCV takes no pointer to const, but only reads.
  const cv::Mat pixels(image.height(), image.width(), type, const_cast<T*>(image.Row(0)));
  std::vector<std::uint8_t> bytes;
  try {
    cv::imencode(".png", pixels, bytes, {cv::IMWRITE_PNG_COMPRESSION, 6});
  } catch (const cv::Exception& exception) {
    throw Error({.path = path.string(), .reason = "cannot be encoded: " + exception.err});
  }
  WriteFileAtomically(path, bytes);
}

bool IsAllGray(const cv::Mat& pixels) {
  for (int v = 0; v < pixels.rows; ++v) {
    for (int u = 0; u < pixels.cols; ++u) {
      const cv::Vec3b& pixel = pixels.at<cv::Vec3b>(v, u);
      if (pixel[0] != pixel[1] || pixel[0] != pixel[2]) return false;
    }
  }
  return true;
}

}  // namespace

Image ReadImage(const std::filesystem::path& path, Channels channels) {
  const std::vector<std::uint8_t> bytes = ReadFile(path);
  const ImageHeader header = ReadImageHeader(path, bytes);
  cv::Mat pixels =
      Decode(path, bytes, header, header.gray ? cv::IMREAD_GRAYSCALE : cv::IMREAD_ANYCOLOR);
  CheckPaletteIndices(path, bytes);
  HC_CHECK(pixels.depth() == CV_8U && (pixels.channels() == 1 || pixels.channels() == 3),
           pixels.type());
  if (channels == Channels::kGray && pixels.channels() != 1) {
    if (!header.indexed || !IsAllGray(pixels)) {
      throw Error(
          {.path = path.string(),
           .reason = std::string(header.indexed ? "a palette of colours" : "a colour picture") +
                     " where a gray one is due",
           .remedy = header.indexed ? "save it as gray values, without a palette"
                                    : "save it with one channel"});
    }
    cv::extractChannel(pixels, pixels, 0);
  }
  return ToImage<std::uint8_t>(pixels);
}

BasicImage<std::uint16_t> ReadImage16(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = ReadFile(path);
  const ImageHeader header = ReadImageHeader(path, bytes, ChannelBits::k16);
  if (!header.gray) {
    throw Error({.path = path.string(),
                 .reason = "a colour picture where one of depths is due",
                 .remedy = "save it with one channel of 16 bits"});
  }
  const cv::Mat pixels = Decode(path, bytes, header, cv::IMREAD_GRAYSCALE | cv::IMREAD_ANYDEPTH);
  HC_CHECK(pixels.type() == CV_16U, pixels.type());
  return ToImage<std::uint16_t>(pixels);
}

void WritePng(const std::filesystem::path& path, const Image& image) {
  HC_CHECK(!image.empty() && (image.channels() == 1 || image.channels() == 3),
           image.width(),
           image.height(),
           image.channels());
  EncodePng(path, image, CV_MAKETYPE(CV_8U, image.channels()));
}

void WritePng16(const std::filesystem::path& path, const BasicImage<std::uint16_t>& image) {
  HC_CHECK(!image.empty() && image.channels() == 1, image.width(), image.channels());
  EncodePng(path, image, CV_16U);
}

features::RawImage RawView(const Image& image) {
  HC_CHECK(image.channels() == 1 || image.channels() == 3, image.channels());
  return {.data = image.values().data(),
          .width = image.width(),
          .height = image.height(),
          .stride_bytes = image.View().stride,
          .format =
              image.channels() == 1 ? features::PixelFormat::kGray8 : features::PixelFormat::kBgr8};
}

}  // namespace handcraft::perception
