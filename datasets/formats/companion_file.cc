// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/companion_file.h"

#include <string>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/organised_cloud.h"
#include "datasets/formats/scene_file.h"
#include "lib/core/check.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

PixelSize SizeIn(std::string_view column, const std::filesystem::path& path) {
  if (column == kObjectMask) return SizeOf(ReadObjectMask(path));
  if (column == kDepth) return SizeOf(perception::ReadImage16(path));
  HC_CHECK(column == kRightImage, column);
  return SizeOf(perception::ReadImage(path));
}

}  // namespace

void CheckCompanion(std::string_view column,
                    const std::filesystem::path& path,
                    const PixelSize& picture_size) {
  if (column == kScene) {
    static_cast<void>(ReadSceneFile(path));
    return;
  }
  if (column == kCloud) {
    static_cast<void>(ReadCloudOfPicture(path, picture_size));
    return;
  }
  RequireSameSize(path, "the " + std::string(column), SizeIn(column, path), picture_size);
}

}  // namespace handcraft::datasets
