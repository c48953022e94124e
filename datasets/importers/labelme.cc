// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/labelme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "datasets/formats/json_value.h"
#include "datasets/formats/mask_picture.h"
#include "datasets/importers/base64.h"
#include "datasets/importers/labelled_shapes.h"
#include "datasets/importers/omissions.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = std::numeric_limits<int>::max();

std::array<double, 2> ReadPoint(const JsonValue& json) {
  const std::vector<double> numbers = json.Numbers();
  if (numbers.size() != 2) json.Fail("a point has two numbers");
  for (const double number : numbers) {
    if (std::abs(number) > kFarthest_px) json.Fail("a point beyond any picture");
  }
  return {numbers[0], numbers[1]};
}

ShapeGeometry ReadGeometry(const JsonValue& shape) {
  const std::string type = shape.Has("shape_type") ? shape["shape_type"].Text() : "polygon";
  std::vector<std::array<double, 2>> points;
  for (const JsonValue& point : shape["points"].Items()) points.push_back(ReadPoint(point));
  const auto require = [&](bool holds, const std::string& what) {
    if (!holds) shape["points"].Fail("a " + type + " has " + what);
  };
  if (type == "polygon") {
    require(points.size() >= 3, "three points or more");
    return points;
  }
  if (type == "rectangle") {
    require(points.size() == 2, "two points: opposite corners");
    const auto [a, b] = std::pair(points[0], points[1]);
    return Polygon{a, {b[0], a[1]}, b, {a[0], b[1]}};
  }
  if (type == "circle") {
    require(points.size() == 2, "two points: the centre and one on its line");
    return Circle{points[0], std::hypot(points[1][0] - points[0][0], points[1][1] - points[0][1])};
  }
  shape["shape_type"].Fail("a shape of type '" + type + "'; polygon, rectangle or circle is due",
                           "draw it as one of these");
}

// The extension that fits what the bytes are, empty if it is no picture we know.
std::string_view ExtensionOf(const std::vector<std::uint8_t>& bytes) {
  const std::string_view start(reinterpret_cast<const char*>(bytes.data()),
                               std::min<std::size_t>(bytes.size(), 4));
  if (start.starts_with("\x89PNG")) return ".png";
  if (start.starts_with("\xFF\xD8")) return ".jpg";
  if (start.starts_with("BM")) return ".bmp";
  if (start.starts_with("P5")) return ".pgm";
  if (start.starts_with("P6")) return ".ppm";
  return "";
}

std::vector<std::uint8_t> DecodePicture(const JsonValue& data) {
  std::optional<std::vector<std::uint8_t>> bytes = DecodeBase64(data.Text());
  if (!bytes) data.Fail("the embedded picture is not base64");
  if (ExtensionOf(*bytes).empty()) {
    data.Fail("the embedded picture is not PNG, JPEG, BMP, PGM or PPM");
  }
  return std::move(*bytes);
}

// Where the picture is, and its path below images/. Returns false when there is none.
bool PlacePicture(const JsonValue& json,
                  const fs::path& file,
                  const fs::path& relative,
                  SourcePicture& picture) {
  fs::path image;
  if (json.Has("imageData")) {
    const std::vector<std::uint8_t> bytes = DecodePicture(json["imageData"]);
    picture.path = file;
    picture.embedded = [file] { return DecodePicture(JsonValue::ReadFile(file)["imageData"]); };
    image = fs::path(relative).replace_extension(ExtensionOf(bytes));
  } else {
    const auto name = FindNamedFile(file.parent_path(), json["imagePath"].Text(), file);
    if (!name) return false;
    picture.path = file.parent_path() / *name;
    image = relative.parent_path() / *name;
  }
  picture.image = image.generic_string();
  picture.mask = fs::path(image).replace_extension(".png").generic_string();
  picture.instance = fs::path(image).replace_extension().generic_string();
  picture.object_class = ClassOfPath(image);
  return true;
}

std::optional<PixelSize> ReadSize(const JsonValue& json) {
  if (!json.Has("imageWidth") || !json.Has("imageHeight")) return std::nullopt;
  constexpr std::int64_t kLargest = std::numeric_limits<std::int32_t>::max();
  return PixelSize{json["imageWidth"].Integer(1, kLargest),
                   json["imageHeight"].Integer(1, kLargest)};
}

// Nothing when its picture is not there.
std::optional<SourcePicture> ReadAnnotation(const fs::path& file,
                                            const fs::path& relative,
                                            const LabelRoles& roles,
                                            std::set<std::string>& labels) {
  const JsonValue json = JsonValue::ReadFile(file);
  SourcePicture picture;
  std::vector<LabelledShape> shapes;
  std::size_t index = 0;
  for (const JsonValue& shape : json["shapes"].Items()) {
    const std::string where = "at /shapes/" + std::to_string(index++);
    const std::string label = shape["label"].Text();
    labels.insert(label);
    const std::optional<std::uint8_t> value = roles.ValueOf(label);
    if (value) shapes.push_back({ReadGeometry(shape), *value, where});
  }
  if (!PlacePicture(json, file, relative, picture)) return std::nullopt;
  picture.make_mask = [file, shapes, size = ReadSize(json)](int width, int height) {
    if (size) RequireSameSize(file, "the labelled picture", *size, {width, height});
    return DrawLabelledShapes(file, width, height, shapes);
  };
  picture.find_notes = [file, shapes](int width, int height) {
    return NotesOnShapes(file, width, height, shapes);
  };
  return picture;
}

bool IsAnnotation(const fs::path& path) { return path.extension() == ".json"; }

// Pictures that no annotation is about: neither named by one nor named as one is.
void TellOfUnlabelled(const std::vector<fs::path>& files,
                      const std::vector<SourcePicture>& pictures,
                      Omissions& omissions) {
  std::set<fs::path> labelled;
  for (const fs::path& file : files) {
    if (IsAnnotation(file)) labelled.insert(fs::path(file).replace_extension());
  }
  for (const SourcePicture& picture : pictures) {
    labelled.insert(picture.path.lexically_normal().replace_extension());
  }
  for (const fs::path& file : files) {
    if (!IsNamedLikeAPicture(file)) continue;
    const bool is_labelled = labelled.contains(fs::path(file).replace_extension()) ||
                             labelled.contains(file.lexically_normal().replace_extension());
    if (!is_labelled) omissions.LeaveOut(file, "no LabelMe file names this picture");
  }
}

}  // namespace

SourceSet ListLabelme(const fs::path& source, const LabelRoles& roles) {
  roles.Validate();
  SourceSet set;
  Omissions omissions;
  std::set<std::string> labels;
  const std::vector<fs::path> files = ListFiles(source, kDeepest, IsAnnotation);
  for (const fs::path& file : files) {
    if (!IsAnnotation(file)) continue;
    auto picture = ReadAnnotation(file, file.lexically_relative(source), roles, labels);
    if (picture) {
      set.pictures.push_back(std::move(*picture));
    } else {
      omissions.LeaveOut(file, "the picture that it names is not there");
    }
  }
  TellOfUnlabelled(files, set.pictures, omissions);
  omissions.Conclude(set,
                     {.path = source.string(),
                      .reason = "no LabelMe file *.json with its picture; found " +
                                std::to_string(files.size()) + " files",
                      .remedy = "give the folder they are in"});
  roles.RequireAmong(labels, source);
  return set;
}

}  // namespace handcraft::datasets
