// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/demonstration_sheet.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "datasets/close_up.h"
#include "datasets/cloud_camera.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/perception/overlay.h"

namespace handcraft::datasets {
namespace {

using Eigen::Vector3f;
using synthetic::PinholeCamera;

constexpr float kHalfWidthM = 0.02F;
constexpr float kPalmM = -0.05F;  // along the approach axis
constexpr float kStemM = -0.09F;
constexpr float kLeastDepthM = 0.05F;

// A line of the glyph in the hand's frame, and its colour.
struct Stroke {
  Vector3f from_m;
  Vector3f to_m;
  std::array<int, 3> bgr;
};

std::array<Stroke, 4> Strokes(Hand hand) {
  const std::array<int, 3> stem_bgr =
      hand == Hand::kRight ? std::array{60, 220, 255} : std::array{255, 90, 230};
  const Vector3f palm(0.0F, 0.0F, kPalmM);
  const Vector3f side(kHalfWidthM, 0.0F, 0.0F);
  return {{{Vector3f(0.0F, 0.0F, kStemM), palm, stem_bgr},
           {palm - side, palm + side, stem_bgr},
           {palm + side, side, {0, 120, 255}},
           {palm - side, -side, {255, 120, 0}}}};
}

std::vector<std::size_t> SpreadEvenly(const std::vector<std::size_t>& all, int count) {
  const std::size_t num_chosen = std::min(static_cast<std::size_t>(count), all.size());
  std::vector<std::size_t> chosen;
  chosen.reserve(num_chosen);
  for (std::size_t i = 0; i < num_chosen; ++i) chosen.push_back(all[i * all.size() / num_chosen]);
  return chosen;
}

struct ShownPoses {
  std::vector<EndEffectorPose> right;
  std::vector<EndEffectorPose> left;
};

void Add(const Demonstration& shown, ShownPoses& poses) { poses.right.push_back(shown.pose); }

void Add(const Hold& hold, ShownPoses& poses) {
  poses.right.push_back(hold.right);
  poses.left.push_back(hold.left);
}

// For each view, by its image, the poses shown in it.
using PosesOfViews = std::map<std::string, ShownPoses, std::less<>>;

template <class Set>
PosesOfViews GroupPoses(const Set& set, int poses_per_view) {
  std::map<std::string, std::vector<std::size_t>, std::less<>> rows;
  for (std::size_t i = 0; i < set.items.size(); ++i) rows[set.items[i].view].push_back(i);
  PosesOfViews poses;
  for (const auto& [view, indices] : rows) {
    ShownPoses& of_view = poses[view];
    for (const std::size_t i : SpreadEvenly(indices, poses_per_view)) Add(set.items[i], of_view);
  }
  return poses;
}

// A box twice as large about the same middle, 4 to 3, in a picture of this size.
cv::Rect TwiceAsLarge(const perception::PixelBox& box, int picture_width, int picture_height) {
  const int wanted = std::max(2 * box.height, 3 * box.width / 2);
  const int limit = std::min(picture_height, picture_width * 3 / 4);
  const int height = std::max(std::min(wanted, limit), 1);
  const int width = height * 4 / 3;
  const auto begin = [](int middle, int size, int end) {
    return std::clamp(middle - size / 2, 0, end - size);
  };
  return {begin(box.u_px + box.width / 2, width, picture_width),
          begin(box.v_px + box.height / 2, height, picture_height),
          width,
          height};
}

// The camera of a part of the picture, scaled to a tile.
PinholeCamera CameraOfTile(PinholeCamera camera, const cv::Rect& part, const cv::Size& tile) {
  const float scale = static_cast<float>(tile.width) / static_cast<float>(part.width);
  camera.width_px = tile.width;
  camera.height_px = tile.height;
  camera.focal_px *= scale;
  camera.centre_u_px = (camera.centre_u_px + 0.5F - static_cast<float>(part.x)) * scale - 0.5F;
  camera.centre_v_px = (camera.centre_v_px + 0.5F - static_cast<float>(part.y)) * scale - 0.5F;
  return camera;
}

cv::Mat PixelsOf(Image& image) { return {image.height(), image.width(), CV_8UC3, image.Row(0)}; }

Image DrawTile(const ViewSet& views, std::size_t index, const ShownPoses& poses, int width_px) {
  const ObjectView& item = views.items[index];
  const LoadedView view = ReadView(views, index);
  const std::string path = (views.root / item.image).string();
  if (!view.cloud) {
    throw Error(
        {.path = path, .reason = "the view has no cloud, which tells where its camera stood"});
  }
  PinholeCamera camera;
  try {
    camera = FitCamera(*view.cloud);
  } catch (const Error& error) {
    throw Error({.path = (views.root / item.cloud).string(), .reason = error.details().reason});
  }
  const std::optional<perception::PixelBox> object = FindBox(view.object_mask, kObject);
  if (!object) {
    throw Error(
        {.path = (views.root / item.object_mask).string(), .reason = "the mask shows no object"});
  }
  PicturePart part = PartAbout(view.image, *object, camera, width_px);
  DrawHands(part.picture, part.camera, poses.right, Hand::kRight);
  DrawHands(part.picture, part.camera, poses.left, Hand::kLeft);
  return std::move(part.picture);
}

// Where the camera sees a point, in sixteenths of a pixel.
constexpr int kShift = 4;
cv::Point SixteenthsOf(const PinholeCamera& camera, const Vector3f& p_in_base) {
  const Eigen::Vector2f pixel = 16.0F * camera.Project(p_in_base);
  return {cvRound(pixel.x()), cvRound(pixel.y())};
}

bool IsInFront(const PinholeCamera& camera, const Eigen::Isometry3f& base_from_grasp, Hand hand) {
  const Eigen::Isometry3f camera_from_grasp = camera.base_from_camera.inverse() * base_from_grasp;
  const auto is_behind = [&](const Stroke& stroke) {
    return std::min((camera_from_grasp * stroke.from_m).z(),
                    (camera_from_grasp * stroke.to_m).z()) < kLeastDepthM;
  };
  const std::array<Stroke, 4> strokes = Strokes(hand);
  return std::none_of(strokes.begin(), strokes.end(), is_behind);
}

void DrawHand(cv::Mat& pixels,
              const PinholeCamera& camera,
              const Eigen::Isometry3f& base_from_grasp,
              Hand hand,
              int line_width_px) {
  constexpr int kRimPx = 2;
  const auto draw = [&](const Stroke& stroke, const cv::Scalar& colour, int width_px) {
    cv::line(pixels,
             SixteenthsOf(camera, base_from_grasp * stroke.from_m),
             SixteenthsOf(camera, base_from_grasp * stroke.to_m),
             colour,
             width_px,
             cv::LINE_AA,
             kShift);
  };
  if (line_width_px > 1) {
    for (const Stroke& stroke : Strokes(hand)) draw(stroke, {0, 0, 0}, line_width_px + 2 * kRimPx);
  }
  for (const Stroke& stroke : Strokes(hand)) {
    draw(stroke, cv::Scalar(stroke.bgr[0], stroke.bgr[1], stroke.bgr[2]), line_width_px);
  }
}

// `Set` has items of poses or holds, each of a view.
template <class Set>
std::vector<SheetPicture> SheetPicturesBy(const Set& set,
                                          const ViewSet& views,
                                          const DemonstrationSheetOptions& options) {
  options.Validate();
  const PosesOfViews poses = GroupPoses(set, options.poses_per_view);
  std::vector<SheetPicture> pictures;
  for (std::size_t i = 0; i < views.items.size(); ++i) {
    const ObjectView& view = views.items[i];
    const auto shown = poses.find(view.image);
    if (shown == poses.end()) continue;
    pictures.push_back({.row = view.object_class,
                        .split = view.split,
                        .caption = std::filesystem::path(view.image).stem().string(),
                        .draw = [&views, i, shown = shown->second, width = options.tile_width_px] {
                          return std::vector<Image>{DrawTile(views, i, shown, width)};
                        }});
  }
  return pictures;
}

}  // namespace

void DemonstrationSheetOptions::Validate() const {
  RequireOption(poses_per_view >= 1 && poses_per_view <= 10000,
                "DemonstrationSheetOptions.poses_per_view",
                poses_per_view,
                "from 1 to 10000");
  RequireOption(tile_width_px >= 16 && tile_width_px <= 640,
                "DemonstrationSheetOptions.tile_width_px",
                tile_width_px,
                "from 16 to 640");
}

void DrawHands(Image& picture,
               const PinholeCamera& camera,
               std::span<const EndEffectorPose> poses,
               Hand hand,
               int line_width_px) {
  HC_CHECK(picture.channels() == 3 && !picture.empty(), picture.channels());
  HC_CHECK(line_width_px >= 1, line_width_px);
  cv::Mat pixels = PixelsOf(picture);
  for (const EndEffectorPose& pose : poses) {
    const Eigen::Isometry3f base_from_grasp = pose.ToIsometry().cast<float>();
    if (IsInFront(camera, base_from_grasp, hand)) {
      DrawHand(pixels, camera, base_from_grasp, hand, line_width_px);
    }
  }
}

PicturePart PartAbout(const Image& picture,
                      const perception::PixelBox& box,
                      const PinholeCamera& camera,
                      int width_px) {
  const cv::Rect part_box = TwiceAsLarge(box, picture.width(), picture.height());
  const cv::Size size(width_px, width_px * 3 / 4);
  Image colour =
      perception::DrawLabelMask(picture, Image(picture.width(), picture.height()));  // in colour
  PicturePart part{.picture = Image(size.width, size.height, 3),
                   .camera = CameraOfTile(camera, part_box, size)};
  cv::Mat pixels = PixelsOf(part.picture);
  const int filter = part_box.width > size.width ? cv::INTER_AREA : cv::INTER_CUBIC;
  cv::resize(PixelsOf(colour)(part_box), pixels, size, 0.0, 0.0, filter);
  return part;
}

std::vector<SheetPicture> SheetPicturesOf(const DemonstrationSet& demonstrations,
                                          const ViewSet& views,
                                          const DemonstrationSheetOptions& options) {
  return SheetPicturesBy(demonstrations, views, options);
}

std::vector<SheetPicture> SheetPicturesOf(const HoldSet& holds,
                                          const ViewSet& views,
                                          const DemonstrationSheetOptions& options) {
  return SheetPicturesBy(holds, views, options);
}

}  // namespace handcraft::datasets
