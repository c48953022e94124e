// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/cvat.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/mask_picture.h"
#include "datasets/importers/cvat_shapes.h"
#include "datasets/importers/label_picture.h"
#include "datasets/importers/omissions.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/path_kind.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

// Red, green, blue.
using Colour = std::array<std::uint8_t, 3>;
constexpr Colour kBlack = {};

// The lines that say something, with their numbers.
std::vector<std::pair<std::size_t, std::string>> ReadLines(const fs::path& path) {
  const std::string text = ReadTextFile(path);
  std::vector<std::pair<std::size_t, std::string>> lines;
  std::size_t number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    at = end + 1;
    ++number;
    line.resize(line.find_last_not_of(" \t\r") + 1);
    if (!line.empty()) lines.emplace_back(number, std::move(line));
  }
  return lines;
}

// "10,128,0".
std::optional<Colour> ParseColour(std::string_view text) {
  Colour colour{};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i < colour.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ',')) return std::nullopt;
    const auto [stop, error] = std::from_chars(at, end, colour[i]);
    if (error != std::errc()) return std::nullopt;
    at = stop;
  }
  return at == end ? std::optional(colour) : std::nullopt;
}

std::map<Colour, std::string> ReadLabelMap(const fs::path& path) {
  std::map<Colour, std::string> labels;
  for (const auto& [number, line] : ReadLines(path)) {
    if (line.starts_with('#')) continue;
    const auto fail = [&, number = number](const std::string& reason) {
      throw Error({.path = path.string(), .line = number, .reason = reason});
    };
    const std::size_t begin = std::min(line.find(':'), line.size());
    const std::size_t end = std::min(line.find(':', begin + 1), line.size());
    const std::optional<Colour> colour =
        begin < line.size() ? ParseColour(std::string_view(line).substr(begin + 1, end - begin - 1))
                            : std::nullopt;
    if (!colour || begin == 0) fail("'" + line + "' where label:red,green,blue:: is due");
    const auto [twin, is_new] = labels.try_emplace(*colour, line.substr(0, begin));
    if (!is_new) fail("'" + line + "' has the colour of '" + twin->second + "'");
  }
  return labels;
}

std::map<Colour, std::uint8_t> MeaningOfColours(const std::map<Colour, std::string>& labels,
                                                const LabelRoles& roles) {
  std::map<Colour, std::uint8_t> meaning = {{kBlack, kMaskBad}};
  for (const auto& [colour, label] : labels) {
    meaning[colour] = roles.ValueOf(label).value_or(kMaskBad);
  }
  return meaning;
}

Image ReadColouredMask(const fs::path& path, const std::map<Colour, std::uint8_t>& meaning) {
  const Image labels = ReadLabelPicture(path);
  Image mask(labels.width(), labels.height());
  const bool is_gray = labels.channels() == 1;
  for (int v = 0; v < labels.height(); ++v) {
    for (int u = 0; u < labels.width(); ++u) {
      const std::uint8_t blue = labels.At(u, v);
      const Colour colour =
          is_gray ? Colour{blue, blue, blue} : Colour{labels.At(u, v, 2), labels.At(u, v, 1), blue};
      const auto found = meaning.find(colour);
      if (found == meaning.end()) {
        throw Error({.path = path.string(),
                     .reason = "the colour " + std::to_string(colour[0]) + "," +
                               std::to_string(colour[1]) + "," + std::to_string(colour[2]) +
                               " at column " + std::to_string(u) + ", row " + std::to_string(v) +
                               " is of no label in labelmap.txt"});
      }
      mask.At(u, v) = found->second;
    }
  }
  return mask;
}

std::string WithoutExtension(const fs::path& path) {
  return fs::path(path).replace_extension().generic_string();
}

// The pictures of these names, by them: their paths without extension.
std::map<std::string, fs::path> FindImages(const fs::path& folder,
                                           const std::map<std::string, fs::path>& names) {
  std::map<std::string, fs::path> images;
  RequireFolder(folder);
  if (KindOf(folder) != PathKind::kFolder) {
    throw Error({.path = folder.string(),
                 .reason = "no folder of the pictures",
                 .remedy = "export with \"Save images\", or name the folder (--images)"});
  }
  const auto is_meant = [&](const fs::path& path) {
    return IsNamedLikeAPicture(path) &&
           names.contains(WithoutExtension(path.lexically_relative(folder)));
  };
  for (const fs::path& file : ListFiles(folder, std::numeric_limits<int>::max(), is_meant)) {
    if (!is_meant(file)) continue;
    const fs::path relative = file.lexically_relative(folder);
    images.try_emplace(WithoutExtension(relative), relative);
  }
  return images;
}

// Every name that is listed, in byte order, with the list it stands in.
std::map<std::string, fs::path> ReadNames(const fs::path& folder) {
  std::map<std::string, fs::path> names;
  const auto is_list = [](const fs::path& path) { return path.extension() == ".txt"; };
  for (const fs::path& list : ListFiles(folder, 0, is_list)) {
    if (!is_list(list)) continue;
    for (const auto& [number, name] : ReadLines(list)) {
      names.try_emplace(fs::path(name).lexically_normal().generic_string(), list);
    }
  }
  if (names.empty()) {
    throw Error({.path = folder.string(), .reason = "no *.txt with names of pictures"});
  }
  return names;
}

SourcePicture Describe(const fs::path& folder,
                       const fs::path& image,
                       const fs::path& mask,
                       const std::map<Colour, std::uint8_t>& meaning) {
  return {.path = folder / image,
          .image = image.generic_string(),
          .mask = WithoutExtension(image) + ".png",
          .object_class = ClassOfPath(image),
          .instance = WithoutExtension(image),
          .make_mask = [mask, meaning](int width, int height) {
            Image made = ReadColouredMask(mask, meaning);
            RequireSameSize(mask, "the mask", {made.width(), made.height()}, {width, height});
            return made;
          }};
}

SourceSet ListCvatMasks(const fs::path& source, const CvatOptions& options) {
  const auto labels = ReadLabelMap(source / "labelmap.txt");
  std::set<std::string> label_names;
  for (const auto& [colour, label] : labels) label_names.insert(label);
  options.roles.RequireAmong(label_names, source / "labelmap.txt");
  const auto meaning = MeaningOfColours(labels, options.roles);
  const fs::path folder = options.images.empty() ? source / "JPEGImages" : options.images;
  const fs::path masks = source / "SegmentationClass";
  const auto names = ReadNames(source / "ImageSets" / "Segmentation");
  const auto images = FindImages(folder, names);
  SourceSet set;
  Omissions omissions;
  for (const auto& [name, list] : names) {
    const std::optional<fs::path> mask = FindNamedFile(masks, name + ".png", list);
    const auto image = images.find(name);
    if (!mask) {
      omissions.LeaveOut(masks / (name + ".png"),
                         "no such mask, which " + list.string() + " names");
    } else if (image == images.end()) {
      omissions.LeaveOut(masks / *mask, "no picture of this mask in " + folder.string());
    } else {
      set.pictures.push_back(Describe(folder, image->second, masks / *mask, meaning));
    }
  }
  omissions.Conclude(set,
                     {.path = source.string(),
                      .reason = "none of the " + std::to_string(names.size()) +
                                " pictures in ImageSets/Segmentation is there with its mask",
                      .remedy = "name the folder of the pictures (--images)"});
  return set;
}

}  // namespace

SourceSet ListCvat(const fs::path& source, const CvatOptions& options) {
  options.roles.Validate();
  if (source.extension() == ".xml") return ListCvatShapes(source, options);
  RequireFolder(source);
  const bool has_shapes = HasFile(source / "annotations.xml");
  const bool has_masks = HasFile(source / "labelmap.txt");
  if (has_shapes == has_masks) {
    throw Error({.path = source.string(),
                 .reason = std::string(has_masks ? "both" : "neither") +
                           " labelmap.txt (\"Segmentation mask 1.1\") " +
                           (has_masks ? "and" : "nor") +
                           " annotations.xml (\"CVAT for images 1.1\") there",
                 .remedy = "give the folder of one unpacked export"});
  }
  return has_shapes ? ListCvatShapes(source / "annotations.xml", options)
                    : ListCvatMasks(source, options);
}

}  // namespace handcraft::datasets
