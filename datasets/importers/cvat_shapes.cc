// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/cvat_shapes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "datasets/formats/mask_picture.h"
#include "datasets/importers/labelled_shapes.h"
#include "datasets/importers/omissions.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"
#include "lib/structured_text/xml_element.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kLargestSide_px = 65535;
constexpr const char* kRemedyWithoutPictures =
    "export with \"Save images\", or name the folder of the pictures (--images)";

// Takes one number off the front of `text`, with the separator before it if there is one to take.
template <class T>
std::optional<T> TakeNumber(std::string_view& text, char separator) {
  if (separator != '\0') {
    if (!text.starts_with(separator)) return std::nullopt;
    text.remove_prefix(1);
  }
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

// points="1.5,2;3,4;…"
Polygon ReadPolygon(const XmlElement& shape) {
  const std::string points = shape.Attribute("points");
  Polygon polygon;
  for (std::string_view rest = points; !rest.empty();) {
    const std::optional<double> x = TakeNumber<double>(rest, polygon.empty() ? '\0' : ';');
    const std::optional<double> y = x ? TakeNumber<double>(rest, ',') : std::nullopt;
    if (!y) shape.Fail("points are not as \"x,y;x,y;x,y\"");
    const bool is_near = std::abs(*x) <= kFarthest_px && std::abs(*y) <= kFarthest_px;
    if (!is_near) shape.Fail("a corner beyond any picture");
    polygon.push_back({*x, *y});
  }
  if (polygon.size() < 3) shape.Fail("a polygon has three corners or more");
  return polygon;
}

double ReadCoordinate(const XmlElement& shape, const char* name) {
  const double value = shape.Number(name);
  if (std::abs(value) > kFarthest_px) shape.Fail("a corner beyond any picture");
  return value;
}

// A box may be turned about its middle, clockwise as one sees it [deg].
Polygon ReadBox(const XmlElement& shape) {
  const double left = ReadCoordinate(shape, "xtl");
  const double top = ReadCoordinate(shape, "ytl");
  const double right = ReadCoordinate(shape, "xbr");
  const double bottom = ReadCoordinate(shape, "ybr");
  const double turn_rad =
      shape.Has("rotation") ? shape.Number("rotation") * std::numbers::pi / 180.0 : 0.0;
  Polygon box = {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
  if (turn_rad == 0.0) return box;
  const std::array middle = {(left + right) / 2, (top + bottom) / 2};
  for (auto& [x, y] : box) {
    const double dx = x - middle[0];
    const double dy = y - middle[1];
    x = middle[0] + dx * std::cos(turn_rad) - dy * std::sin(turn_rad);
    y = middle[1] + dx * std::sin(turn_rad) + dy * std::cos(turn_rad);
  }
  return box;
}

// The parts of a run that lie in one row each; the run begins at pixel `begin` of the box.
void AddSpans(std::int64_t begin, std::int64_t end, const PixelSpan& box, PixelSpans& spans) {
  const std::int64_t width = box.end - box.begin;
  while (begin < end) {
    const std::int64_t row = begin / width;
    const std::int64_t row_end = std::min(end, (row + 1) * width);
    spans.push_back({.row = box.row + static_cast<int>(row),
                     .begin = box.begin + static_cast<int>(begin - row * width),
                     .end = box.begin + static_cast<int>(row_end - row * width)});
    begin = row_end;
  }
}

// rle="3, 5, …" along the rows of the box, outside and inside by turns.
PixelSpans ReadMask(const XmlElement& shape, const PixelSize& picture_size) {
  const std::int64_t left = shape.Integer("left", 0, picture_size[0] - 1);
  const std::int64_t top = shape.Integer("top", 0, picture_size[1] - 1);
  const std::int64_t width = shape.Integer("width", 1, picture_size[0] - left);
  const std::int64_t height = shape.Integer("height", 1, picture_size[1] - top);
  const PixelSpan box{
      static_cast<int>(top), static_cast<int>(left), static_cast<int>(left + width)};
  const std::string runs = shape.Attribute("rle");
  PixelSpans spans;
  std::int64_t at = 0;
  bool is_inside = false;
  for (std::string_view rest = runs; !rest.empty(); is_inside = !is_inside) {
    const bool is_first = rest.size() == runs.size();
    const auto length = TakeNumber<std::uint32_t>(rest, is_first ? '\0' : ',');
    if (!length) shape.Fail("rle is not numbers with commas between them");
    if (*length > width * height - at) shape.Fail("the runs are longer than the mask");
    if (is_inside) AddSpans(at, at + *length, box, spans);
    at += *length;
  }
  if (at != width * height) {
    shape.Fail("the runs are " + std::to_string(at) + " pixels, the mask has " +
               std::to_string(width * height));
  }
  return spans;
}

LabelledShape ReadShape(const XmlElement& shape,
                        const PixelSize& picture_size,
                        std::uint8_t value) {
  const std::string type = shape.Name();
  if (type == "polygon") return {ReadPolygon(shape), value, shape.Where()};
  if (type == "box") return {ReadBox(shape), value, shape.Where()};
  if (type == "mask") return {ReadMask(shape, picture_size), value, shape.Where()};
  shape.Fail("a shape of type '" + type + "'; polygon, box or mask is due",
             "draw it as one of these");
}

// Of a picture's annotations, those that are no shapes: labels of the whole picture.
bool IsTag(const XmlElement& annotation) { return annotation.Name() == "tag"; }

std::optional<fs::path> FindPicture(const XmlElement& image,
                                    const fs::path& folder,
                                    const fs::path& file) {
  const std::string name = image.Attribute("name");
  std::optional<fs::path> found = FindNamedFile(folder, name, file);
  if (!found && image.Has("subset")) {
    found = FindNamedFile(folder, image.Attribute("subset") + "/" + name, file);
  }
  return found;
}

std::vector<LabelledShape> ReadShapes(const XmlElement& image,
                                      const PixelSize& size,
                                      const LabelRoles& roles,
                                      std::set<std::string>& labels) {
  std::vector<LabelledShape> shapes;
  for (const XmlElement& shape : image.Children()) {
    if (IsTag(shape)) continue;
    const std::string label = shape.Attribute("label");
    labels.insert(label);
    const std::optional<std::uint8_t> value = roles.ValueOf(label);
    if (value) shapes.push_back(ReadShape(shape, size, *value));
  }
  return shapes;
}

// Nothing when the picture is not there.
std::optional<SourcePicture> ReadPicture(const XmlElement& image,
                                         const fs::path& file,
                                         const fs::path& folder,
                                         const LabelRoles& roles,
                                         std::set<std::string>& labels) {
  const PixelSize size = {image.Integer("width", 1, kLargestSide_px),
                          image.Integer("height", 1, kLargestSide_px)};
  std::vector<LabelledShape> shapes = ReadShapes(image, size, roles, labels);
  const std::optional<fs::path> found = FindPicture(image, folder, file);
  if (!found) return std::nullopt;
  const fs::path& name = *found;
  const auto find_notes = [file, shapes](int width, int height) {
    return NotesOnShapes(file, width, height, shapes);
  };
  return SourcePicture{
      .path = folder / name,
      .image = name.generic_string(),
      .mask = fs::path(name).replace_extension(".png").generic_string(),
      .object_class = ClassOfPath(name),
      .instance = fs::path(name).replace_extension().generic_string(),
      .make_mask =
          [file, path = folder / name, size, shapes = std::move(shapes)](int width, int height) {
            RequireSameSize(path, "the labelled picture", size, {width, height});
            return DrawLabelledShapes(file, width, height, shapes);
          },
      .find_notes = find_notes};
}

// The labels of the task, project or job that was exported.
std::set<std::string> ReadLabels(const XmlElement& root) {
  std::set<std::string> names;
  for (const XmlElement& meta : root.Children("meta")) {
    for (const XmlElement& task : meta.Children()) {
      for (const XmlElement& labels : task.Children("labels")) {
        for (const XmlElement& label : labels.Children("label")) {
          for (const XmlElement& name : label.Children("name")) names.insert(name.Text());
        }
      }
    }
  }
  return names;
}

}  // namespace

SourceSet ListCvatShapes(const fs::path& file, const CvatOptions& options) {
  options.roles.Validate();
  const XmlElement root = XmlElement::ReadFile(file);
  if (root.Name() != "annotations") root.Fail("the file of CVAT begins with <annotations>");
  const std::string remedy = "export as \"CVAT for images 1.1\"";
  if (!root.Children("track").empty()) root.Fail("tracks of a video", remedy);
  const fs::path folder = options.images.empty() ? file.parent_path() / "images" : options.images;
  std::set<std::string> labels = ReadLabels(root);
  SourceSet set;
  Omissions omissions;
  const std::vector<XmlElement> images = root.Children("image");
  if (images.empty()) root.Fail("no <image> in it", remedy);
  RequireFolder(folder);
  for (const XmlElement& image : images) {
    auto picture = ReadPicture(image, file, folder, options.roles, labels);
    if (picture) {
      set.pictures.push_back(std::move(*picture));
    } else {
      omissions.LeaveOut(folder / image.Attribute("name"),
                         "no such file, which " + file.string() + " names");
    }
  }
  omissions.Conclude(set,
                     {.path = file.string(),
                      .reason = "none of its pictures is below " + folder.string(),
                      .remedy = kRemedyWithoutPictures});
  options.roles.RequireAmong(labels, file);
  return set;
}

}  // namespace handcraft::datasets
