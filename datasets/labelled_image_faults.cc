// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/labelled_image_faults.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "datasets/formats/organised_cloud.h"
#include "datasets/parallel_reporting.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

// What is found in the files of one picture.
struct Findings {
  std::vector<Fault> faults;
  std::string image_digest;  // empty when the picture cannot be read
};

bool Has(const Image& mask, std::uint8_t value) {
  const auto& values = mask.values();
  return std::find(values.begin(), values.end(), value) != values.end();
}

void CheckSize(int width, int height, const Image& image, const fs::path& path) {
  if (width == image.width() && height == image.height()) return;
  throw Error(
      {.path = path.string(),
       .reason = fmt::format(
           "{}x{} pixels, its picture {}x{}", width, height, image.width(), image.height())});
}

template <class T>
void CheckSize(const BasicImage<T>& companion, const Image& image, const fs::path& path) {
  CheckSize(companion.width(), companion.height(), image, path);
}

void CheckObjectMask(const fs::path& path, const Image& image) {
  const Image mask = perception::ReadImage(path, perception::Channels::kGray);
  CheckSize(mask, image, path);
  const auto& values = mask.values();
  const auto other =
      std::find_if(values.begin(), values.end(), [](int v) { return v != 0 && v != 255; });
  if (other == values.end()) return;
  const auto at = static_cast<int>(other - values.begin());
  throw Error({.path = path.string(),
               .reason = fmt::format("value {} at column {}, row {}; 255 (object) or 0 is due",
                                     *other,
                                     at % mask.width(),
                                     at / mask.width())});
}

void CheckCompanion(std::string_view column, const fs::path& path, const Image& image) {
  if (column == kObjectMask) {
    CheckObjectMask(path, image);
  } else if (column == kDepth) {
    CheckSize(perception::ReadImage16(path), image, path);
  } else if (column == kRightImage) {
    CheckSize(perception::ReadImage(path), image, path);
  } else if (column == kCloud) {
    const OrganisedCloud cloud = ReadPcd(path);
    CheckSize(cloud.width, cloud.height, image, path);
  } else if (ReadFile(path).empty()) {
    throw Error({.path = path.string(), .reason = "the file is empty"});
  }
}

// Runs a check and keeps what it throws.
template <class Check>
void Collect(const fs::path& root, std::vector<Fault>& faults, const Check& check) {
  try {
    check();
  } catch (const Error& error) {
    const Error::Details& details = error.details();
    faults.push_back({fs::path(details.path).lexically_relative(root).string(), details.reason});
  }
}

Findings Examine(const LabelledImageSet& set, std::size_t index) {
  Findings findings;
  std::vector<Fault>& faults = findings.faults;
  const LabelledImage& item = set.items[index];
  LabelledPicture picture;
  Collect(set.root, faults, [&] {
    picture = ReadLabelledPicture(set, index);
    if (!Has(picture.mask, kMaskGood))
      faults.push_back({item.mask, "no good pixel (255): the picture is left out"});
    if (!Has(picture.mask, kMaskBad))
      faults.push_back({item.mask, "no bad pixel (0): the picture is left out"});
    findings.image_digest = Sha256Hex(ReadFile(set.root / item.image));
  });
  for (const std::string_view column : kCompanions) {
    const std::string path = item.Companion(column);
    if (path.empty() || picture.image.empty()) continue;
    Collect(set.root, faults, [&] { CheckCompanion(column, set.root / path, picture.image); });
  }
  return findings;
}

}  // namespace

std::vector<Fault> FindFaults(const LabelledImageSet& set,
                              int num_threads,
                              const Progress& progress) {
  std::vector<Findings> findings(set.items.size());
  ParallelForReporting(
      set.items.size(), num_threads, progress, "checking files", [&](std::size_t i) {
        findings[i] = Examine(set, i);
      });
  std::vector<Fault> faults;
  std::map<std::string, const LabelledImage*> first_of_content;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    const LabelledImage& item = set.items[i];
    faults.insert(faults.end(), findings[i].faults.begin(), findings[i].faults.end());
    if (findings[i].image_digest.empty()) continue;
    const auto [first, is_new] = first_of_content.try_emplace(findings[i].image_digest, &item);
    if (is_new) continue;
    const LabelledImage& twin = *first->second;
    faults.push_back({item.image,
                      "the same picture as " + twin.image +
                          (twin.split == item.split ? "" : ", which is in another split")});
  }
  return faults;
}

}  // namespace handcraft::datasets
