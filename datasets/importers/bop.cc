// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/bop.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <Eigen/Geometry>

#include "datasets/close_up.h"
#include "datasets/formats/json_value.h"
#include "datasets/formats/mask_picture.h"
#include "datasets/formats/view_set.h"
#include "datasets/importers/depth_cloud.h"
#include "datasets/importers/label_picture.h"
#include "datasets/importers/omissions.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/option_rules.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using perception::PixelBox;

constexpr double kMillimetre_m = 0.001;

// Of one picture of a scene.
struct BopCamera {
  Pinhole pinhole;
  double depth_unit_m = 0.0;
};

// One object in one picture.
struct BopView {
  fs::path image, mask, depth;  // no depth: empty
  BopCamera camera;
  Eigen::Isometry3d base_from_camera = Eigen::Isometry3d::Identity();
  int margin_px = 0;
};

std::string SixDigits(std::int64_t number) {
  const std::string digits = std::to_string(number);
  return std::string(6 - std::min<std::size_t>(digits.size(), 6), '0') + digits;
}

// The pictures of a scene in the order of their numbers, which are the keys of its files.
std::map<std::int64_t, JsonValue> ByNumber(const JsonValue& file) {
  std::map<std::int64_t, JsonValue> by_number;
  for (auto& [key, value] : file.Members()) {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
    if (error != std::errc() || end != key.data() + key.size() || number < 0) {
      value.Fail("the key is not the number of a picture");
    }
    if (!by_number.try_emplace(number, value).second) value.Fail("the picture is there twice");
  }
  return by_number;
}

template <int kRows, int kColumns>
Eigen::Matrix<double, kRows, kColumns> ReadMatrix(const JsonValue& json) {
  const std::vector<double> numbers = json.Numbers();
  if (numbers.size() != kRows * kColumns) {
    json.Fail(std::to_string(numbers.size()) + " numbers; " + std::to_string(kRows * kColumns) +
              " are due");
  }
  Eigen::Matrix<double, kRows, kColumns> matrix;
  for (int i = 0; i < kRows * kColumns; ++i) {
    const double number = numbers[static_cast<std::size_t>(i)];
    if (!(std::abs(number) < 1e9)) json.Fail("a number beyond all bounds");
    matrix(i / kColumns, i % kColumns) = number;  // row by row
  }
  return matrix;
}

BopCamera ReadCamera(const JsonValue& json) {
  const Eigen::Matrix3d K = ReadMatrix<3, 3>(json["cam_K"]);
  if (!(K(0, 0) > 0.0 && K(1, 1) > 0.0)) json["cam_K"].Fail("a focal length that is not positive");
  const double scale = json.Has("depth_scale") ? json["depth_scale"].Number() : 1.0;
  if (!(scale > 0.0 && scale <= 1e3)) json["depth_scale"].Fail("not in (0, 1000]");
  return {.pinhole = {K(0, 0), K(1, 1), K(0, 2), K(1, 2)}, .depth_unit_m = scale * kMillimetre_m};
}

Eigen::Isometry3d ReadPose(const JsonValue& json) {
  const Eigen::Matrix3d rotation = ReadMatrix<3, 3>(json["cam_R_m2c"]);
  constexpr double kRounding = 1e-2;  // files hold few digits
  const Eigen::Matrix3d excess = rotation * rotation.transpose() - Eigen::Matrix3d::Identity();
  if (!(excess.norm() < kRounding && rotation.determinant() > 0.0)) {
    json["cam_R_m2c"].Fail("not a rotation");
  }
  Eigen::Isometry3d camera_from_model = Eigen::Isometry3d::Identity();
  camera_from_model.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
  camera_from_model.translation() = ReadMatrix<3, 1>(json["cam_t_m2c"]) * kMillimetre_m;
  return camera_from_model;
}

// The base frame of docs, and the model's turn in it if that is known.
std::pair<Eigen::Isometry3d, std::optional<double>> PlaceBase(
    const Eigen::Isometry3d& camera_from_model) {
  constexpr double kAlongZ = 0.0872;  // sin 5°
  const Eigen::Vector3d z = camera_from_model.linear().col(2);
  const Eigen::Vector3d look = camera_from_model.translation().normalized();
  const Eigen::Vector3d away = look - look.dot(z) * z;
  if (!(away.norm() > kAlongZ)) return {camera_from_model.inverse(), std::nullopt};
  Eigen::Isometry3d camera_from_base = camera_from_model;
  camera_from_base.linear().col(0) = away.normalized();
  camera_from_base.linear().col(1) = z.cross(away.normalized());
  const Eigen::Vector3d x_of_model =
      camera_from_base.linear().transpose() * camera_from_model.linear().col(0);
  const double turn_deg = std::atan2(x_of_model.y(), x_of_model.x()) * 180.0 / std::numbers::pi;
  const double angle_deg = turn_deg < 0.0 ? turn_deg + 360.0 : turn_deg;
  return {camera_from_base.inverse(), angle_deg < 360.0 ? angle_deg : 0.0};
}

// What is seen, with the margin around it as far as the picture goes; nothing for an empty mask.
std::optional<PixelBox> CropOf(const Image& mask, const BopView& view) {
  int left = mask.width(), right = -1, top = mask.height(), bottom = -1;
  for (int v = 0; v < mask.height(); ++v) {
    for (int u = 0; u < mask.width(); ++u) {
      if (mask.At(u, v) == 0) continue;
      left = std::min(left, u), right = std::max(right, u);
      top = std::min(top, v), bottom = std::max(bottom, v);
    }
  }
  if (right < 0) return std::nullopt;
  left = std::max(left - view.margin_px, 0);
  top = std::max(top - view.margin_px, 0);
  right = std::min(right + view.margin_px, mask.width() - 1);
  bottom = std::min(bottom + view.margin_px, mask.height() - 1);
  return PixelBox{.u_px = left, .v_px = top, .width = right - left + 1, .height = bottom - top + 1};
}

// Empty when nothing of the object is seen; mask and cloud are made of the others alone.
Image MakeImage(const BopView& view) {
  const Image mask = ReadLabelValues(view.mask);
  const Image image = perception::ReadImage(view.image);
  RequireSameSize(
      view.mask, "the mask", {mask.width(), mask.height()}, {image.width(), image.height()});
  const std::optional<PixelBox> crop = CropOf(mask, view);
  return crop ? CutOut(image, *crop) : Image();
}

Image MakeMask(const BopView& view) {
  const Image mask = ReadLabelValues(view.mask);
  Image part = CutOut(mask, CropOf(mask, view).value());
  for (int v = 0; v < part.height(); ++v) {
    for (int u = 0; u < part.width(); ++u) part.At(u, v) = part.At(u, v) == 0 ? kNoObject : kObject;
  }
  return part;
}

OrganisedCloud MakeCloud(const BopView& view) {
  const Image mask = ReadLabelValues(view.mask);
  const BasicImage<std::uint16_t> depth = perception::ReadImage16(view.depth);
  RequireSameSize(
      view.depth, "the depth", {depth.width(), depth.height()}, {mask.width(), mask.height()});
  const PixelBox crop = CropOf(mask, view).value();
  Pinhole camera = view.camera.pinhole;
  camera.cx_px -= crop.u_px;
  camera.cy_px -= crop.v_px;
  return CloudOfDepth(CutOut(depth, crop), view.camera.depth_unit_m, camera, view.base_from_camera);
}

// rgb/NNNNNN.png, .jpg or gray/NNNNNN.png …; empty when there is none.
fs::path FindImage(const fs::path& scene, const std::string& number) {
  for (const char* folder : {"rgb", "gray"}) {
    for (const char* extension : {".png", ".jpg"}) {
      fs::path image = scene / folder / (number + extension);
      if (HasFile(image)) return image;
    }
  }
  return {};
}

// The share of each object of a picture that is seen, where the scene tells.
std::vector<double> ReadVisibleShares(const std::map<std::int64_t, JsonValue>& info,
                                      std::int64_t number,
                                      std::size_t num_objects) {
  std::vector<double> shares(num_objects, 1.0);
  const auto found = info.find(number);
  if (found == info.end()) return shares;
  const std::vector<JsonValue> objects = found->second.Items();
  if (objects.size() != num_objects) {
    found->second.Fail(std::to_string(objects.size()) + " objects; scene_gt.json has " +
                       std::to_string(num_objects));
  }
  for (std::size_t i = 0; i < num_objects; ++i) shares[i] = objects[i]["visib_fract"].Number();
  return shares;
}

SourcePicture Describe(const JsonValue& object, BopView view, const std::string& name) {
  const auto [base_from_camera, angle_deg] = PlaceBase(ReadPose(object));
  view.base_from_camera = base_from_camera;
  const std::string instance = "obj_" + SixDigits(object["obj_id"].Integer(0, 1'000'000));
  SourcePicture picture{.path = view.image,
                        .image = name + ".png",
                        .mask = name + ".png",
                        .object_class = instance,
                        .instance = instance,
                        .angle_deg = angle_deg,
                        .make_mask = [view](int, int) { return MakeMask(view); },
                        .make_image = [view] { return MakeImage(view); }};
  if (!view.depth.empty()) {
    picture.make_cloud = [view](int, int) { return MakeCloud(view); };
  }
  return picture;
}

// The scenes of a source, and what is found in them.
struct BopScenes {
  SourceSet set = {};
  Omissions omissions = {};
  std::size_t num_scenes = 0;
};

// One picture of a scene.
struct BopPicture {
  fs::path scene;
  fs::path relative;   // of the scene, below the source
  std::string digits;  // its number
  BopView view;        // what all its views have in common
};

std::string NameOfView(const std::string& digits, std::size_t number) {
  return digits + "_" + SixDigits(static_cast<std::int64_t>(number));
}

// Adds the view of the object of this number, if its files are there.
void AddView(const BopPicture& picture,
             const JsonValue& object,
             std::size_t number,
             BopScenes& found) {
  const std::string name = NameOfView(picture.digits, number);
  BopView view = picture.view;
  view.mask = picture.scene / "mask_visib" / (name + ".png");
  if (view.image.empty()) {
    found.omissions.LeaveOut(picture.scene / "rgb" / (picture.digits + ".png"),
                             "no such picture of scene_gt.json, nor a .jpg, nor in gray/");
  } else if (!HasFile(view.mask)) {
    found.omissions.LeaveOut(view.mask, "no such mask, of an object in scene_gt.json");
  } else {
    found.set.pictures.push_back(
        Describe(object, std::move(view), (picture.relative / name).generic_string()));
  }
}

void ListScene(const fs::path& scene,
               const fs::path& relative,
               const BopOptions& options,
               BopScenes& found) {
  const auto cameras = ByNumber(JsonValue::ReadFile(scene / "scene_camera.json"));
  std::map<std::int64_t, JsonValue> info;
  if (HasFile(scene / "scene_gt_info.json")) {
    info = ByNumber(JsonValue::ReadFile(scene / "scene_gt_info.json"));
  }
  for (const auto& [number, picture] : ByNumber(JsonValue::ReadFile(scene / "scene_gt.json"))) {
    const auto camera = cameras.find(number);
    if (camera == cameras.end()) picture.Fail("scene_camera.json has no such picture");
    const std::string digits = SixDigits(number);
    const std::vector<JsonValue> objects = picture.Items();
    const std::vector<double> shares = ReadVisibleShares(info, number, objects.size());
    BopPicture shown{.scene = scene,
                     .relative = relative,
                     .digits = digits,
                     .view = {.image = FindImage(scene, digits),
                              .mask = {},
                              .depth = scene / "depth" / (digits + ".png"),
                              .camera = ReadCamera(camera->second),
                              .margin_px = options.margin_px}};
    if (!HasFile(shown.view.depth)) shown.view.depth.clear();
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (shares[i] >= options.min_visible) {
        AddView(shown, objects[i], i, found);
      } else {
        found.omissions.LeaveOut(
            scene / "mask_visib" / (NameOfView(digits, i) + ".png"),
            "less than " + NumberToText(options.min_visible) + " of the object is seen");
      }
    }
  }
}

void TellOfLack(const std::vector<SourcePicture>& views, Omissions& omissions) {
  std::vector<fs::path> without_cloud;
  for (const SourcePicture& view : views) {
    if (!view.make_cloud) without_cloud.push_back(view.path);
  }
  omissions.GoWithoutWhatOthersHave(
      without_cloud, views.size(), "its cloud", "no picture of the same number in depth/");
}

}  // namespace

void BopOptions::Validate() const {
  RequireOption(
      min_visible >= 0.0 && min_visible <= 1.0, "BopOptions.min_visible", min_visible, "in [0, 1]");
  RequireOption(
      margin_px >= 0 && margin_px <= 65535, "BopOptions.margin_px", margin_px, "from 0 to 65535");
}

SourceSet ListBop(const fs::path& source, const BopOptions& options) {
  options.Validate();
  BopScenes found;
  const auto is_scene = [](const fs::path& path) { return path.filename() == "scene_gt.json"; };
  for (const fs::path& file : ListFiles(source, std::numeric_limits<int>::max(), is_scene)) {
    if (file.filename() == "scene_camera.json" && !HasFile(file.parent_path() / "scene_gt.json")) {
      found.omissions.LeaveOut(file.parent_path() / "scene_gt.json",
                               "no such list, which tells what the scene shows");
    }
    if (!is_scene(file)) continue;
    ++found.num_scenes;
    const fs::path scene = file.parent_path();
    ListScene(scene, scene.lexically_relative(source).lexically_normal(), options, found);
  }
  TellOfLack(found.set.pictures, found.omissions);
  found.omissions.Conclude(found.set,
                           {.path = source.string(),
                            .reason = "no object to be seen; found " +
                                      std::to_string(found.num_scenes) + " scenes (scene_gt.json)",
                            .remedy = "give the folder of a scene, or one that holds some"});
  return std::move(found.set);
}

}  // namespace handcraft::datasets
