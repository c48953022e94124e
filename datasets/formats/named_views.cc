// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/named_views.h"

#include <array>

namespace handcraft::datasets {
namespace {

std::string Quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

constexpr std::array<std::string_view, 4> kColumns = {"image", "class", "instance", "angle_deg"};

}  // namespace

NamedViews::NamedViews(const std::filesystem::path& root) {
  CsvRows rows(root / "views.csv", kColumns);
  while (rows.Next()) {
    View view{.object_class = std::string(rows.Required(1)),
              .instance = std::string(rows.Required(2)),
              .angle_deg = std::nullopt,
              .line = rows.line()};
    if (!rows.Text(3).empty()) view.angle_deg = rows.Number(3);
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
