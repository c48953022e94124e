// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/coco.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "datasets/formats/json_value.h"
#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/mask_picture.h"
#include "datasets/importers/coco_runs.h"
#include "datasets/importers/labelled_shapes.h"
#include "datasets/importers/omissions.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"
#include "lib/core/path_kind.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kLargestId = std::int64_t{1} << 53;
constexpr std::int64_t kLargestSide_px = 65535;

struct CocoImage {
  std::string name;
  PixelSize size{};
  std::vector<LabelledShape> shapes;
};

std::int64_t ReadId(const JsonValue& json) { return json.Integer(-kLargestId, kLargestId); }

std::map<std::int64_t, CocoImage> ReadImages(const JsonValue& list) {
  std::map<std::int64_t, CocoImage> images;
  for (const JsonValue& json : list.Items()) {
    CocoImage image{.name = json["file_name"].Text(),
                    .size = {json["width"].Integer(1, kLargestSide_px),
                             json["height"].Integer(1, kLargestSide_px)},
                    .shapes = {}};
    if (!images.try_emplace(ReadId(json["id"]), std::move(image)).second) {
      json["id"].Fail("another image has this id");
    }
  }
  if (images.empty()) list.Fail("no image is listed");
  return images;
}

std::map<std::int64_t, std::string> ReadCategories(const JsonValue& list) {
  std::map<std::int64_t, std::string> names;
  for (const JsonValue& json : list.Items()) {
    if (!names.try_emplace(ReadId(json["id"]), json["name"].Text()).second) {
      json["id"].Fail("another category has this id");
    }
  }
  return names;
}

Polygon ReadPolygon(const JsonValue& json) {
  const std::vector<double> numbers = json.Numbers();
  if (numbers.size() < 6 || numbers.size() % 2 != 0) {
    json.Fail(std::to_string(numbers.size()) +
              " numbers; a polygon has x and y of three corners or more");
  }
  Polygon polygon;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    const bool is_far =
        std::abs(numbers[i]) > kFarthest_px || std::abs(numbers[i + 1]) > kFarthest_px;
    if (is_far) json.Fail("a corner beyond any picture");
    polygon.push_back({numbers[i], numbers[i + 1]});
  }
  return polygon;
}

PixelRuns ReadCounts(const JsonValue& counts) {
  if (counts.IsText()) {
    std::optional<PixelRuns> runs = DecodeCocoRuns(counts.Text());
    if (!runs) counts.Fail("not a text of compressed runs");
    return std::move(*runs);
  }
  PixelRuns runs;
  for (const JsonValue& count : counts.Items()) {
    runs.push_back(
        static_cast<std::uint32_t>(count.Integer(0, std::numeric_limits<std::uint32_t>::max())));
  }
  return runs;
}

PixelRuns ReadRuns(const JsonValue& json, const PixelSize& picture_size) {
  const std::vector<double> size = json["size"].Numbers();  // height, width
  const auto [width, height] = std::pair(picture_size[0], picture_size[1]);
  if (size != std::vector{static_cast<double>(height), static_cast<double>(width)}) {
    json["size"].Fail("not the size of the picture: " + std::to_string(height) + " rows of " +
                      std::to_string(width));
  }
  PixelRuns runs = ReadCounts(json["counts"]);
  const std::uint64_t sum = std::accumulate(runs.begin(), runs.end(), std::uint64_t{0});
  if (sum != static_cast<std::uint64_t>(width * height)) {
    json["counts"].Fail("the runs are " + std::to_string(sum) + " pixels, the picture has " +
                        std::to_string(width * height));
  }
  return runs;
}

// `place` is the annotation's in the file, as messages have it.
void AddShapes(const JsonValue& annotation,
               const std::string& place,
               std::uint8_t value,
               CocoImage& image) {
  const JsonValue outline = annotation["segmentation"];
  if (!outline.IsList()) {
    image.shapes.push_back({ReadRuns(outline, image.size), value, place});
    return;
  }
  const std::vector<JsonValue> polygons = outline.Items();
  if (polygons.empty()) outline.Fail("an annotation without an outline", "draw it, or remove it");
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    image.shapes.push_back(
        {ReadPolygon(polygons[i]), value, place + "/segmentation/" + std::to_string(i)});
  }
}

void ReadAnnotations(const JsonValue& list,
                     const std::map<std::int64_t, std::string>& categories,
                     const LabelRoles& roles,
                     std::map<std::int64_t, CocoImage>& images) {
  std::size_t index = 0;
  for (const JsonValue& json : list.Items()) {
    const std::string place = "at /annotations/" + std::to_string(index++);
    const auto category = categories.find(ReadId(json["category_id"]));
    if (category == categories.end()) json["category_id"].Fail("no category has this id");
    const auto image = images.find(ReadId(json["image_id"]));
    if (image == images.end()) json["image_id"].Fail("no image has this id");
    const std::optional<std::uint8_t> value = roles.ValueOf(category->second);
    if (!value) continue;
    const bool is_crowd = json.Has("iscrowd") && json["iscrowd"].Integer(0, 1) == 1;
    AddShapes(json, place, is_crowd ? kMaskDontCare : *value, image->second);
  }
}

SourcePicture Describe(const fs::path& file,
                       const fs::path& folder,
                       const fs::path& name,
                       CocoImage image) {
  const auto find_notes = [file, shapes = image.shapes](int width, int height) {
    return NotesOnShapes(file, width, height, shapes);
  };
  return {.path = folder / name,
          .image = name.generic_string(),
          .mask = fs::path(name).replace_extension(".png").generic_string(),
          .object_class = ClassOfPath(name),
          .instance = fs::path(name).replace_extension().generic_string(),
          .make_mask =
              [file, path = folder / name, image = std::move(image)](int width, int height) {
                RequireSameSize(path, "the labelled picture", image.size, {width, height});
                return DrawLabelledShapes(file, width, height, image.shapes);
              },
          .find_notes = find_notes};
}

}  // namespace

SourceSet ListCoco(const fs::path& file, const CocoOptions& options) {
  options.roles.Validate();
  if (KindOf(file) == PathKind::kFolder) {
    throw Error({.path = file.string(),
                 .reason = "is a folder",
                 .remedy = "name the JSON file of the annotations in it, often instances_*.json"});
  }
  const JsonValue json = JsonValue::ReadFile(file);
  std::map<std::int64_t, CocoImage> images = ReadImages(json["images"]);
  const auto categories = ReadCategories(json["categories"]);
  std::set<std::string> names;
  for (const auto& [id, name] : categories) names.insert(name);
  options.roles.RequireAmong(names, file);
  ReadAnnotations(json["annotations"], categories, options.roles, images);
  const fs::path folder = options.images.empty() ? file.parent_path() : options.images;
  RequireFolder(folder);
  SourceSet set;
  Omissions omissions;
  for (auto& [id, image] : images) {
    if (const auto name = FindNamedFile(folder, image.name, file)) {
      set.pictures.push_back(Describe(file, folder, *name, std::move(image)));
    } else {
      omissions.LeaveOut(folder / image.name, "no such file, which " + file.string() + " names");
    }
  }
  omissions.Conclude(set,
                     {.path = file.string(),
                      .reason = "none of its pictures is below " + folder.string(),
                      .remedy = "name the folder of the pictures (--images)"});
  return set;
}

}  // namespace handcraft::datasets
