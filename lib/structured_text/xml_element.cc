// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/structured_text/xml_element.h"

#include <tinyxml2.h>

#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>
#include <utility>

#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft {
namespace {

std::string Excerpt(std::string_view text) {
  constexpr std::size_t kMaxLength = 40;
  return "'" + std::string(text.substr(0, kMaxLength)) + (text.size() > kMaxLength ? "...'" : "'");
}

std::string Reason(tinyxml2::XMLError error) {
  if (error == tinyxml2::XML_ERROR_EMPTY_DOCUMENT) return "the file is empty; XML is due";
  if (error == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) return "more than 100 levels of elements";
  return "this is not XML (" + std::string(tinyxml2::XMLDocument::ErrorIDToName(error)) + ")";
}

}  // namespace

struct XmlElement::File {
  std::filesystem::path path;
  tinyxml2::XMLDocument tree = {};
};

XmlElement::XmlElement(std::shared_ptr<const File> file, const tinyxml2::XMLElement* element)
    : file_(std::move(file)), element_(element) {}

XmlElement XmlElement::ReadFile(const std::filesystem::path& path) {
  const std::string remedy = "is the file whole? write it again";
  const std::string text = ReadTextFile(path);
  if (const std::size_t zero = text.find('\0'); zero != std::string::npos) {
    throw Error({.path = path.string(),
                 .byte = zero,
                 .reason = "a zero byte; XML in UTF-8 is due",
                 .remedy = remedy});
  }
  auto file = std::make_shared<File>();
  file->path = path;
  const tinyxml2::XMLError error = file->tree.Parse(text.data(), text.size());
  const tinyxml2::XMLElement* const root = file->tree.RootElement();
  if (error != tinyxml2::XML_SUCCESS || root == nullptr) {
    const int line = file->tree.ErrorLineNum();
    Error::Details details{
        .path = path.string(),
        .reason = error == tinyxml2::XML_SUCCESS ? "no element in the file" : Reason(error),
        .remedy = remedy};
    if (line > 0) details.line = static_cast<std::size_t>(line);
    throw Error(details);
  }
  return {std::move(file), root};
}

std::string XmlElement::Name() const { return element_->Name(); }

std::vector<XmlElement> XmlElement::Children() const {
  std::vector<XmlElement> children;
  for (const auto* child = element_->FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    children.push_back(XmlElement(file_, child));
  }
  return children;
}

std::vector<XmlElement> XmlElement::Children(const std::string& name) const {
  std::vector<XmlElement> children = Children();
  std::erase_if(children, [&](const XmlElement& child) { return child.Name() != name; });
  return children;
}

std::string XmlElement::Text() const {
  const char* const text = element_->GetText();
  return text == nullptr ? "" : text;
}

bool XmlElement::Has(const std::string& attribute) const {
  return element_->Attribute(attribute.c_str()) != nullptr;
}

std::string XmlElement::Attribute(const std::string& attribute) const {
  const char* const value = element_->Attribute(attribute.c_str());
  if (value == nullptr) Fail("no attribute '" + attribute + "'");
  return value;
}

double XmlElement::Number(const std::string& attribute) const {
  const std::string text = Attribute(attribute);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    Fail(attribute + " is " + Excerpt(text) + "; a number is due");
  }
  return value;
}

std::int64_t XmlElement::Integer(const std::string& attribute,
                                 std::int64_t lowest,
                                 std::int64_t highest) const {
  const std::string text = Attribute(attribute);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  if (!is_whole || value < lowest || value > highest) {
    Fail(attribute + " is " + Excerpt(text) + "; a whole number from " + std::to_string(lowest) +
         " to " + std::to_string(highest) + " is due");
  }
  return value;
}

std::string XmlElement::Where() const {
  return "line " + std::to_string(element_->GetLineNum()) + ", <" + Name() + ">";
}

void XmlElement::Fail(const std::string& reason, const std::string& remedy) const {
  throw Error({.path = file_->path.string(),
               .line = static_cast<std::size_t>(element_->GetLineNum()),
               .reason = "<" + Name() + ">: " + reason,
               .remedy = remedy});
}

}  // namespace handcraft
