// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/umd.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/mask_picture.h"
#include "datasets/formats/mat_array.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kImageEnd = "_rgb";
constexpr std::array<const char*, 7> kAffordances = {
    "grasp", "cut", "scoop", "contain", "pound", "support", "wrap-grasp"};

// What the numbers 0 … 7 become.
using Meaning = std::array<std::uint8_t, kAffordances.size() + 1>;

Meaning MeaningOfNumbers(const LabelRoles& roles) {
  Meaning meaning{};
  meaning[0] = kMaskBad;
  for (std::size_t i = 0; i < kAffordances.size(); ++i) {
    meaning[i + 1] = roles.ValueOf(kAffordances[i]).value_or(kMaskBad);
  }
  return meaning;
}

MatArray ReadLabels(const fs::path& path, int width, int height) {
  MatArray labels = ReadMatArray(path, "gt_label");
  const auto rows = static_cast<std::int64_t>(labels.dimensions[0]);
  const auto columns = static_cast<std::int64_t>(labels.dimensions[1]);
  RequireSameSize(path, "the matrix gt_label", {columns, rows}, {width, height});
  const std::size_t num_layers = labels.values.size() / static_cast<std::size_t>(width * height);
  const bool is_ranked = labels.dimensions.size() == 3;
  if (num_layers != (is_ranked ? kAffordances.size() : 1)) {
    throw Error({.path = path.string(),
                 .reason = "gt_label has " + std::to_string(num_layers) + " layers; " +
                           (is_ranked ? "one for each of 7 affordances" : "one") + " is due"});
  }
  return labels;
}

// The number of a pixel's affordance as it stands in the file, which may hold anything.
double NumberOf(const MatArray& labels, std::size_t pixel) {
  if (labels.dimensions.size() == 2) return labels.values[pixel];
  const std::size_t num_pixels = labels.dimensions[0] * labels.dimensions[1];
  for (std::size_t i = 0; i < kAffordances.size(); ++i) {
    if (labels.values[i * num_pixels + pixel] == 1.0) return static_cast<double>(i + 1);
  }
  return 0.0;
}

Image MakeMask(const fs::path& path, const Meaning& meaning, int width, int height) {
  const MatArray labels = ReadLabels(path, width, height);
  Image mask(width, height);
  for (int u = 0; u < width; ++u) {
    for (int v = 0; v < height; ++v) {
      const double number = NumberOf(labels, static_cast<std::size_t>(u * height + v));
      const bool is_known =
          number >= 0.0 && number <= kAffordances.size() && number == std::floor(number);
      if (!is_known) {
        throw Error({.path = path.string(),
                     .reason = "a label beyond 0 ... 7 at column " + std::to_string(u) + ", row " +
                               std::to_string(v)});
      }
      mask.At(u, v) = meaning[static_cast<std::size_t>(number)];
    }
  }
  return mask;
}

// "mug_01" → "mug".
std::string ClassOf(const std::string& object) {
  const std::size_t end = object.find_last_not_of("0123456789");
  const bool is_numbered =
      end != std::string::npos && end > 0 && end + 1 < object.size() && object[end] == '_';
  return is_numbered ? object.substr(0, end) : object;
}

fs::path FindLabels(const fs::path& image, const std::string& name) {
  std::error_code ignored;
  for (const char* end : {"_label.mat", "_label_rank.mat"}) {
    fs::path labels = image.parent_path() / (name + end);
    if (fs::is_regular_file(labels, ignored)) return labels;
  }
  throw Error({.path = image.string(),
               .reason = "has no labels: expected " + name + "_label.mat or " + name +
                         "_label_rank.mat beside it",
               .remedy = "unpack the whole of the data"});
}

}  // namespace

LabelRoles UmdRoles() { return {.good = {"grasp", "wrap-grasp"}}; }

SourceSet ListUmd(const fs::path& source, const LabelRoles& roles) {
  roles.Validate();
  roles.RequireAmong({kAffordances.begin(), kAffordances.end()}, source);
  const Meaning meaning = MeaningOfNumbers(roles);
  SourceSet set;
  const std::vector<fs::path> files = ListFiles(source, std::numeric_limits<int>::max());
  for (const fs::path& file : files) {
    const std::string stem = file.stem().string();
    if (!IsNamedLikeAPicture(file) || !stem.ends_with(kImageEnd)) continue;
    const std::string name = stem.substr(0, stem.size() - kImageEnd.size());
    const fs::path relative = file.lexically_relative(source);
    const std::string object = fs::absolute(file).parent_path().filename().string();
    set.pictures.push_back(
        {.path = file,
         .image = relative.generic_string(),
         .mask = (relative.parent_path() / (name + ".png")).generic_string(),
         .object_class = ClassOf(object),
         .instance = object,
         .make_mask = [labels = FindLabels(file, name), meaning](int width, int height) {
           return MakeMask(labels, meaning, width, height);
         }});
  }
  if (set.pictures.empty()) {
    throw Error({.path = source.string(),
                 .reason = "no *_rgb.jpg; found " + std::to_string(files.size()) + " other files",
                 .remedy = "give the folder that holds tools/ or the folders of the objects"});
  }
  return set;
}

}  // namespace handcraft::datasets
