// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/required_list.h"

#include <utility>

#include "datasets/formats/listing_rules.h"
#include "lib/core/error.h"
#include "lib/core/path_kind.h"

namespace handcraft::datasets {

namespace fs = std::filesystem;

void RequireList(const fs::path& root, std::string_view name, const std::string& kind) {
  if (!Exists(root) || KindOf(root / name) != PathKind::kNothing) return;
  const auto fail = [&](std::string reason, std::string remedy) {
    throw Error({.path = root.string(), .reason = std::move(reason), .remedy = std::move(remedy)});
  };
  if (KindOf(root) != PathKind::kFolder) fail("is a file", "give the folder of the data set");
  const std::string missing = "no " + std::string(name) + " in this folder";
  for (const std::string_view other : {kManifestFileName, kViewsFileName}) {
    if (Exists(root / other)) {
      std::string reason = missing;
      reason.append(" but ").append(other).append(": not ").append(kind);
      fail(std::move(reason), "see docs/datasets.md");
    }
  }
  if (Exists(root / kMadeUpFileName)) {
    fail(missing + ": handcraft data synth has not finished it",
         "run that again with the options in dataset.toml; it goes on where it stopped");
  }
  fail(missing + ": not " + kind,
       "see docs/datasets.md, or make one with handcraft data import or handcraft data synth");
}

}  // namespace handcraft::datasets
