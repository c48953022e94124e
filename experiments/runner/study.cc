// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/runner/study_entries.h"
#include "lib/core/error.h"

namespace handcraft::experiments {
namespace {

std::string_view NameOf(StudySplit split) {
  switch (split) {
    case StudySplit::kInstance:
      return "instance";
    case StudySplit::kClass:
      return "class";
    case StudySplit::kPicture:
      return "picture";
    case StudySplit::kManifest:
      break;
  }
  return "manifest";
}

// A folder's pictures are pinned by their fingerprint, wherever they lie.
void AddSource(const std::string& name, const DataSource& source, std::vector<std::string>& lines) {
  if (!source.folder.empty()) {
    lines.push_back(name + " = a folder");
    return;
  }
  lines.push_back(fmt::format("{}.made = {}", name, source.family));
  lines.push_back(fmt::format("{}.images = {}", name, source.num_images));
  lines.push_back(fmt::format("{}.seed = {}", name, source.seed));
}

}  // namespace

void KeepMethods(std::span<const std::string> names, Study& study) {
  std::vector<Method> kept = study.methods;
  KeepMethods(names, study.name, kept);
  if (std::none_of(kept.begin(), kept.end(), [&](const Method& method) {
        return method.name == study.baseline;
      })) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "the others are compared with " + study.baseline,
                 .remedy = "name it among the methods"});
  }
  study.methods = std::move(kept);
}

std::vector<std::string> CanonicalLines(const Study& study) {
  std::vector<std::string> lines;
  AddSource("data.train", study.train, lines);
  if (study.test) AddSource("data.test", *study.test, lines);
  lines.push_back(fmt::format("split = {}", NameOf(study.split)));
  lines.push_back(fmt::format("seed = {}", study.seed));
  lines.push_back(fmt::format("repetitions = {}", study.repetitions));
  lines.push_back(fmt::format("evaluation.pixels_per_image = {}", study.pixels_per_image));
  lines.push_back(fmt::format("evaluation.resamples = {}", study.bootstrap_resamples));
  for (const Setting& setting : study.settings) {
    lines.push_back(fmt::format("settings.{} = {}", setting.key, setting.value));
  }
  for (const Method& method : study.methods) {
    lines.push_back(fmt::format("method {}", method.name));
    for (const Setting& setting : method.settings) {
      lines.push_back(fmt::format("method {}.{} = {}", method.name, setting.key, setting.value));
    }
  }
  for (const Factor& factor : study.factors) {
    lines.push_back(fmt::format("grid.{} = {}", factor.key, fmt::join(factor.values, "; ")));
  }
  return lines;
}

}  // namespace handcraft::experiments
