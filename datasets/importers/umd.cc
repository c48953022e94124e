// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/umd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/mask_picture.h"
#include "datasets/formats/mat_array.h"
#include "datasets/importers/omissions.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kImageEnd = "_rgb";
constexpr std::array<std::string_view, 2> kLabelEnds = {"_label.mat", "_label_rank.mat"};
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

// Of which view a file is a picture or the labels: its path up to the endings. Nothing if neither.
std::optional<fs::path> ViewOf(const fs::path& file) {
  const std::string name =
      IsNamedLikeAPicture(file) ? file.stem().string() : file.filename().string();
  for (const std::string_view end : {kImageEnd, kLabelEnds[0], kLabelEnds[1]}) {
    if (!name.ends_with(end) || (end == kImageEnd) != IsNamedLikeAPicture(file)) continue;
    return file.parent_path() / name.substr(0, name.size() - end.size());
  }
  return std::nullopt;
}

std::optional<fs::path> FindLabels(const fs::path& view) {
  for (const std::string_view end : kLabelEnds) {
    fs::path labels = view.string() + std::string(end);
    if (HasFile(labels)) return labels;
  }
  return std::nullopt;
}

SourcePicture Describe(const fs::path& image,
                       const fs::path& relative,
                       const fs::path& labels,
                       const Meaning& meaning) {
  const std::string object = fs::absolute(image).parent_path().filename().string();
  return {.path = image,
          .image = relative.generic_string(),
          .mask = ViewOf(relative)->generic_string() + ".png",
          .object_class = ClassOf(object),
          .instance = object,
          .make_mask = [labels, meaning](int width, int height) {
            return MakeMask(labels, meaning, width, height);
          }};
}

}  // namespace

LabelRoles UmdRoles() { return {.good = {"grasp", "wrap-grasp"}}; }

SourceSet ListUmd(const fs::path& source, const LabelRoles& roles) {
  roles.Validate();
  SourceSet set;
  Omissions omissions;
  const Meaning meaning = MeaningOfNumbers(roles);
  const auto is_meant = [](const fs::path& path) { return ViewOf(path).has_value(); };
  std::vector<fs::path> files = ListFiles(source, std::numeric_limits<int>::max(), is_meant);
  std::stable_partition(files.begin(), files.end(), IsNamedLikeAPicture);
  std::set<fs::path> known;
  for (const fs::path& file : files) {
    const std::optional<fs::path> view = ViewOf(file);
    if (!view) continue;
    const bool is_first = known.insert(*view).second;
    const bool is_image = IsNamedLikeAPicture(file);
    const std::optional<fs::path> labels = FindLabels(*view);
    if (!is_image && is_first) {
      omissions.LeaveOut(file, "no *_rgb.jpg beside it");
    } else if (is_image && !labels) {
      omissions.LeaveOut(file, "no *_label.mat or *_label_rank.mat beside it");
    } else if (is_image) {
      set.pictures.push_back(Describe(file, file.lexically_relative(source), *labels, meaning));
    }
  }
  omissions.Conclude(
      set,
      {.path = source.string(),
       .reason = "no *_rgb.jpg with labels; found " + std::to_string(files.size()) + " files",
       .remedy = "give the folder that holds tools/ or the folders of the objects"});
  roles.RequireAmong({kAffordances.begin(), kAffordances.end()}, source);
  return set;
}

}  // namespace handcraft::datasets
