// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "datasets/contact_sheet.h"
#include "lib/perception/image_io.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"

namespace handcraft::tools {
namespace {

struct DataPreviewOptions {
  std::string folder;
  std::string out;
  datasets::ContactSheetOptions sheet;
  bool json = false;
};

void RunDataPreview(const DataPreviewOptions& options, const Console& console) {
  RequireWritable(options.out);
  const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(options.folder);
  RequireNotAnInput(options.out, FilesOf(set));
  ProgressBar bar(console);
  datasets::ContactSheetOptions sheet_options = options.sheet;
  sheet_options.progress = bar.Callback();
  const Image sheet = datasets::MakeContactSheet(set, sheet_options);
  bar.Clear();
  perception::WritePng(options.out, sheet);
  if (options.json) {
    console.Print(
        {{"file", options.out}, {"width_px", sheet.width()}, {"height_px", sheet.height()}});
  } else {
    console.out << "Wrote " << options.out << '\n';
  }
}

}  // namespace

void AddDataPreview(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataPreviewOptions>();
  CLI::App* command = parent.add_subcommand(
      "preview", "Draw a contact sheet: a row a class, each picture as it is and with its labels");
  command->add_option("DIR", options->folder, "Folder with manifest.csv")->required();
  command->add_option("--out", options->out, "PNG to write")->type_name("FILE")->required();
  AddNumber(*command,
            "--images-per-class",
            options->sheet,
            &datasets::ContactSheetOptions::images_per_class,
            "At most this many of each class, evenly spread over it");
  AddNumber(*command,
            "--tile-width",
            options->sheet,
            &datasets::ContactSheetOptions::tile_width_px,
            "Width of a picture on the sheet [px]");
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data preview datasets/samples/cornell_mini --out out/sheet.png");
  command->callback([options, &console] { RunDataPreview(*options, console); });
}

}  // namespace handcraft::tools
