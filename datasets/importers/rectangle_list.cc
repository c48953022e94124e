// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/rectangle_list.h"

#include "datasets/formats/csv_records.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

void AppendRow(const std::string& image,
               char good,
               const GraspRectangle& rectangle,
               std::string& text) {
  text += CsvField(image) + ',' + good;
  for (const auto& [u, v] : rectangle) text += ',' + NumberToText(u) + ',' + NumberToText(v);
  text += '\n';
}

}  // namespace

void WriteRectangles(const std::filesystem::path& root,
                     const std::vector<RectanglesOfImage>& list) {
  std::string text = "image,good,u1_px,v1_px,u2_px,v2_px,u3_px,v3_px,u4_px,v4_px\n";
  for (const RectanglesOfImage& item : list) {
    for (const GraspRectangle& rectangle : item.rectangles.positive) {
      AppendRow(item.image, '1', rectangle, text);
    }
    for (const GraspRectangle& rectangle : item.rectangles.negative) {
      AppendRow(item.image, '0', rectangle, text);
    }
  }
  WriteFileAtomically(root / "rectangles.csv", text);
}

}  // namespace handcraft::datasets
