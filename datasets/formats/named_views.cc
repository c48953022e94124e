// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/named_views.h"

#include <array>

#include "datasets/formats/listing_rules.h"

namespace handcraft::datasets {
namespace {

constexpr std::array<std::string_view, 4> kColumns = {"image", "class", "instance", "angle_deg"};

}  // namespace

NamedViews::NamedViews(const std::filesystem::path& root) {
  CsvRows rows(root / kViewsFileName, kColumns);
  while (rows.Next()) {
    const View view{.object_class = std::string(rows.Required(1)),
                    .instance = std::string(rows.Required(2)),
                    .angle_deg = ReadAngle(rows, 3),
                    .line = rows.line()};
    by_image_.try_emplace(std::string(rows.Required(0)), view);
  }
}

const NamedViews::View& NamedViews::Find(const CsvRows& rows,
                                         std::string_view image,
                                         std::string_view object_class,
                                         std::string_view instance) const {
  const auto found = by_image_.find(image);
  if (found == by_image_.end()) {
    rows.Fail("the view " + Quoted(image) + " is no image of views.csv beside it");
  }
  const View& view = found->second;
  if (object_class != view.object_class) {
    FailAgainstView(rows, view, "class", object_class, view.object_class);
  }
  if (instance != view.instance) {
    FailAgainstView(rows, view, "instance", instance, view.instance);
  }
  return view;
}

void FailAgainstView(const CsvRows& rows,
                     const NamedViews::View& view,
                     std::string_view column,
                     std::string_view own,
                     std::string_view other) {
  rows.Fail(std::string(column) + " " + Quoted(own) + "; views.csv has " + Quoted(other) +
            " for this view on line " + std::to_string(view.line));
}

}  // namespace handcraft::datasets
