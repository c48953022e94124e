// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/ply_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

#include "datasets/formats/mesh_text.h"
#include "lib/core/check.h"
#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY's bytes are turned for others");

enum class Number { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

struct NumberName {
  std::string_view name;
  Number number;
};
constexpr std::array<NumberName, 16> kNumberNames = {{{"char", Number::kInt8},
                                                      {"int8", Number::kInt8},
                                                      {"uchar", Number::kUint8},
                                                      {"uint8", Number::kUint8},
                                                      {"short", Number::kInt16},
                                                      {"int16", Number::kInt16},
                                                      {"ushort", Number::kUint16},
                                                      {"uint16", Number::kUint16},
                                                      {"int", Number::kInt32},
                                                      {"int32", Number::kInt32},
                                                      {"uint", Number::kUint32},
                                                      {"uint32", Number::kUint32},
                                                      {"float", Number::kFloat},
                                                      {"float32", Number::kFloat},
                                                      {"double", Number::kDouble},
                                                      {"float64", Number::kDouble}}};

struct Property {
  std::string name;
  Number number = Number::kFloat;
  bool is_list = false;
  Number list_size = Number::kUint8;
};

struct Element {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

enum class Encoding { kText, kLittleEndian, kBigEndian };

struct Head {
  Encoding encoding = Encoding::kText;
  std::vector<Element> elements;
  std::size_t bytes = 0;
  std::size_t lines = 0;
};

Number NumberOf(const MeshText& lines, std::size_t i) {
  const std::string_view word = i < lines.words().size() ? lines.words()[i] : "";
  for (const NumberName& known : kNumberNames) {
    if (known.name == word) return known.number;
  }
  lines.Fail("\"" + lines.From(0).substr(0, 60) + "\" names no type of number");
}

Property ParseProperty(const MeshText& lines) {
  Property property;
  property.is_list = lines.words().size() > 1 && lines.words()[1] == "list";
  if (property.is_list) property.list_size = NumberOf(lines, 2);
  const std::size_t at = property.is_list ? 3 : 1;
  property.number = NumberOf(lines, at);
  property.name = lines.From(at + 1);
  if (property.list_size == Number::kFloat || property.list_size == Number::kDouble) {
    lines.Fail("the length of a list is a whole number");
  }
  return property;
}

Encoding ParseEncoding(const MeshText& lines) {
  const std::string name = lines.From(1);
  if (name == "ascii 1.0") return Encoding::kText;
  if (name == "binary_little_endian 1.0") return Encoding::kLittleEndian;
  if (name == "binary_big_endian 1.0") return Encoding::kBigEndian;
  lines.Fail("the format is \"" + name.substr(0, 40) +
             "\"; ascii, binary_little_endian or binary_big_endian 1.0 is due");
}

Head ParseHead(const std::filesystem::path& path, std::string_view bytes) {
  MeshText lines(path, bytes);
  Head head;
  if (!lines.Next() || lines.From(0) != "ply") lines.Fail("a PLY file begins with \"ply\"");
  while (lines.Next() && lines.words().front() != "end_header") {
    const std::string_view keyword = lines.words().front();
    if (keyword == "format") {
      head.encoding = ParseEncoding(lines);
    } else if (keyword == "element") {
      constexpr std::int64_t kMostElements = std::int64_t{1} << 32;
      head.elements.push_back({lines.words().size() > 1 ? std::string(lines.words()[1]) : "",
                               lines.Whole(2, 0, kMostElements),
                               {}});
    } else if (keyword == "property" && !head.elements.empty()) {
      head.elements.back().properties.push_back(ParseProperty(lines));
    } else if (keyword != "comment" && keyword != "obj_info") {
      lines.Fail("no line of a PLY file's head", "the head ends with \"end_header\"");
    }
  }
  if (lines.words().empty()) lines.Fail("the file ends within its head", "get it whole");
  for (const Element& element : head.elements) {
    if (element.properties.empty()) lines.Fail("element " + element.name + " has no property");
  }
  head.bytes = lines.at();
  head.lines = lines.line();
  return head;
}

// The numbers of the body, one after the other.
class Body {
 public:
  virtual ~Body() = default;
  [[nodiscard]] virtual double Next(Number number) = 0;
  [[noreturn]] virtual void Fail(const std::string& reason) const = 0;
};

class TextBody : public Body {
 public:
  TextBody(const std::filesystem::path& path, std::string_view text, std::size_t first_line)
      : lines_(path, text, first_line) {}

  double Next(Number /*number*/) override {
    while (word_ == lines_.words().size()) {
      if (!lines_.Next()) lines_.Fail("the file ends before its last element", "get it whole");
      word_ = 0;
    }
    return static_cast<double>(lines_.Number(word_++));
  }

  void Fail(const std::string& reason) const override { lines_.Fail(reason); }

 private:
  MeshText lines_;
  std::size_t word_ = 0;
};

class BinaryBody : public Body {
 public:
  BinaryBody(std::filesystem::path path, std::string_view bytes, const Head& head)
      : path_(std::move(path)), bytes_(bytes), at_(head.bytes), encoding_(head.encoding) {}

  double Next(Number number) override {
    switch (number) {
      case Number::kInt8:
        return Take<std::int8_t>();
      case Number::kUint8:
        return Take<std::uint8_t>();
      case Number::kInt16:
        return Take<std::int16_t>();
      case Number::kUint16:
        return Take<std::uint16_t>();
      case Number::kInt32:
        return Take<std::int32_t>();
      case Number::kUint32:
        return Take<std::uint32_t>();
      case Number::kFloat:
        return static_cast<double>(Take<float>());
      case Number::kDouble:
        return Take<double>();
    }
    HC_CHECK(false, static_cast<int>(number));
    return 0.0;
  }

  void Fail(const std::string& reason) const override {
    throw Error({.path = path_.string(), .byte = at_, .reason = reason});
  }

 private:
  template <class T>
  T Take() {
    if (bytes_.size() - at_ < sizeof(T)) Fail("the file ends before its last element");
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    if (encoding_ == Encoding::kBigEndian) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
  }

  std::filesystem::path path_;
  std::string_view bytes_;
  std::size_t at_;
  Encoding encoding_;
};

// Column of the first of these names, or −1.
int ColumnOf(const Element& element, std::initializer_list<std::string_view> names, bool is_list) {
  for (const std::string_view name : names) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const Property& property = element.properties[i];
      if (property.name == name && property.is_list == is_list) return static_cast<int>(i);
    }
  }
  return -1;
}

class BodyReader {
 public:
  explicit BodyReader(Body& body) : body_(body) { mesh_.parts.emplace_back(); }

  void Read(const Element& element) {
    if (element.name == "vertex") {
      ReadVertices(element);
    } else if (element.name == "face") {
      ReadFaces(element);
    } else {
      for (std::int64_t i = 0; i < element.count; ++i) ReadRow(element);
    }
  }

  SurfaceMesh Finish() {
    const std::size_t count = mesh_.vertices.size();
    for (SurfaceMesh::Triangle& triangle : mesh_.triangles) {
      for (const std::uint32_t vertex : triangle.vertices) {
        if (vertex < count) continue;
        body_.Fail("face " + std::to_string(triangle.face) + " names vertex " +
                   std::to_string(vertex) + "; there are " + std::to_string(count));
      }
      if (!mesh_.texture_coordinates.empty()) triangle.texture = triangle.vertices;
    }
    return std::move(mesh_);
  }

 private:
  // A list gives its last number to `row_`, and all of them to `list_` when it is column `kept`.
  void ReadRow(const Element& element, int kept = -1) {
    row_.assign(element.properties.size(), 0.0);
    for (std::size_t i = 0; i < row_.size(); ++i) {
      const Property& property = element.properties[i];
      const bool is_kept = static_cast<int>(i) == kept;
      if (is_kept) list_.clear();
      const double length = property.is_list ? body_.Next(property.list_size) : 1.0;
      if (length < 0.0) body_.Fail("a list has a negative length");
      for (double k = 0.0; k < length; k += 1.0) {
        row_[i] = body_.Next(property.number);
        if (is_kept) list_.push_back(row_[i]);
      }
    }
  }

  void ReadVertices(const Element& element) {
    const std::array<int, 3> xyz = {ColumnOf(element, {"x"}, false),
                                    ColumnOf(element, {"y"}, false),
                                    ColumnOf(element, {"z"}, false)};
    const int u = ColumnOf(element, {"s", "u", "texture_u"}, false);
    const int v = ColumnOf(element, {"t", "v", "texture_v"}, false);
    if (*std::min_element(xyz.begin(), xyz.end()) < 0) body_.Fail("a vertex has no x, y and z");
    const auto number = [&](int column) {
      return static_cast<float>(row_[static_cast<std::size_t>(column)]);
    };
    for (std::int64_t i = 0; i < element.count; ++i) {
      ReadRow(element);
      mesh_.vertices.emplace_back(number(xyz[0]), number(xyz[1]), number(xyz[2]));
      if (!mesh_.vertices.back().allFinite()) {
        body_.Fail("vertex " + std::to_string(i) + " is not finite");
      }
      if (u >= 0 && v >= 0) mesh_.texture_coordinates.emplace_back(number(u), number(v));
    }
  }

  void ReadFaces(const Element& element) {
    const int column = ColumnOf(element, {"vertex_indices", "vertex_index"}, true);
    if (column < 0) body_.Fail("a face has no list vertex_indices");
    std::vector<std::uint32_t> corners;
    for (std::int64_t i = 0; i < element.count; ++i) {
      ReadRow(element, column);
      corners.clear();
      for (const double index : list_) {
        if (!(index >= 0.0 && index < 4294967295.0 && index == std::floor(index))) {
          body_.Fail("face " + std::to_string(i) + " names a vertex that cannot be");
        }
        corners.push_back(static_cast<std::uint32_t>(index));
      }
      if (corners.size() < 3) {
        body_.Fail("face " + std::to_string(i) + " has " + std::to_string(corners.size()) +
                   " corners; three or more are due");
      }
      mesh_.AddFace(corners, {}, 0);
    }
  }

  Body& body_;
  SurfaceMesh mesh_;
  std::vector<double> row_, list_;
};

}  // namespace

SurfaceMesh ParsePly(const std::filesystem::path& path, std::string_view bytes) {
  const Head head = ParseHead(path, bytes);
  std::unique_ptr<Body> body;
  if (head.encoding == Encoding::kText) {
    body = std::make_unique<TextBody>(path, bytes.substr(head.bytes), head.lines + 1);
  } else {
    body = std::make_unique<BinaryBody>(path, bytes, head);
  }
  BodyReader reader(*body);
  for (const Element& element : head.elements) reader.Read(element);
  return reader.Finish();
}

}  // namespace handcraft::datasets
