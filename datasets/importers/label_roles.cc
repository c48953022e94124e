// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/label_roles.h"

#include <algorithm>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

bool Contains(const std::vector<std::string>& labels, const std::string& label) {
  return std::find(labels.begin(), labels.end(), label) != labels.end();
}

std::string Listed(const std::set<std::string>& labels) {
  constexpr std::size_t kMaxLabels = 30;
  std::string text;
  std::size_t count = 0;
  for (const std::string& label : labels) {
    if (++count > kMaxLabels)
      return text + ", and " + std::to_string(labels.size() - kMaxLabels) + " more";
    text += (text.empty() ? "'" : ", '") + label + "'";
  }
  return text.empty() ? "none" : text;
}

}  // namespace

void LabelRoles::Validate() const {
  const auto refuse = [](const std::string& label) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "the label '" + label +
                           "' has two roles; it must be one of good, bad and "
                           "don't care"});
  };
  for (const std::string& label : good) {
    if (Contains(bad, label) || Contains(dont_care, label)) refuse(label);
  }
  for (const std::string& label : bad) {
    if (Contains(dont_care, label)) refuse(label);
  }
}

std::optional<std::uint8_t> LabelRoles::ValueOf(const std::string& label) const {
  if (Contains(good, label)) return kMaskGood;
  if (Contains(bad, label)) return kMaskBad;
  if (Contains(dont_care, label)) return kMaskDontCare;
  return std::nullopt;
}

void LabelRoles::RequireAmong(const std::set<std::string>& labels,
                              const std::filesystem::path& source) const {
  for (const auto* role : {&good, &bad, &dont_care}) {
    for (const std::string& label : *role) {
      if (labels.contains(label)) continue;
      throw Error({.kind = Error::Kind::kUsage,
                   .path = source.string(),
                   .reason = "nothing is labelled '" + label + "'; there are: " + Listed(labels),
                   .remedy = "say which labels are good, bad or don't care"});
    }
  }
}

}  // namespace handcraft::datasets
