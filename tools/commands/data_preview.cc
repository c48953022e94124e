// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "datasets/contact_sheet.h"
#include "datasets/demonstration_sheet.h"
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
  std::string split;
  std::string object_class;
  datasets::OverviewOptions overview;
  datasets::PageOptions page;
  int tile_width_px = 0;
  bool is_page = false;
  bool shows_poses = false;
  datasets::DemonstrationSheetOptions poses;
  bool json = false;
};

Image DrawSheet(const DataPreviewOptions& options,
                const std::vector<datasets::SheetPicture>& pictures,
                const Progress& progress) {
  if (options.is_page) {
    datasets::PageOptions page = options.page;
    page.progress = progress;
    if (options.tile_width_px > 0) page.tile_width_px = options.tile_width_px;
    return datasets::DrawPage(pictures, page);
  }
  datasets::OverviewOptions overview = options.overview;
  overview.progress = progress;
  overview.num_threads = options.page.num_threads;
  if (options.tile_width_px > 0) overview.tile_width_px = options.tile_width_px;
  return datasets::DrawOverview(pictures, overview);
}

void RunDataPreview(const DataPreviewOptions& options, const Console& console) {
  RequireWritable(options.out);
  const datasets::LabelledImageSet whole = datasets::ReadLabelledImageSet(options.folder);
  RequireNotAnInput(options.out, FilesOf(whole));
  const datasets::LabelledImageSet set = whole.Only(options.split).OnlyClass(options.object_class);
  const std::vector<datasets::SheetPicture> pictures = datasets::SheetPicturesOf(set);
  ProgressBar bar(console);
  const Image sheet = DrawSheet(options, pictures, bar.Callback());
  bar.Clear();
  perception::WritePng(options.out, sheet);
  const int num_pages = options.is_page ? datasets::NumPages(pictures.size(), options.page) : 1;
  if (options.json) {
    console.Print({{"file", options.out},
                   {"width_px", sheet.width()},
                   {"height_px", sheet.height()},
                   {"num_images", pictures.size()},
                   {"num_pages", num_pages}});
  } else {
    console.out << "Wrote " << options.out;
    if (options.is_page) console.out << ", page " << options.page.page << " of " << num_pages;
    console.out << '\n';
  }
}

void RunPosesPreview(const DataPreviewOptions& options, const Console& console) {
  RequireWritable(options.out);
  const std::filesystem::path root(options.folder);
  RequireNotAnInput(options.out, std::array{root / "demonstrations.csv", root / "views.csv"});
  const datasets::DemonstrationSet set = datasets::ReadDemonstrationSet(root);
  ProgressBar bar(console);
  datasets::DemonstrationSheetOptions sheet_options = options.poses;
  sheet_options.views_per_class = options.overview.images_per_class;
  if (options.tile_width_px > 0) sheet_options.tile_width_px = options.tile_width_px;
  sheet_options.progress = bar.Callback();
  const Image sheet =
      datasets::MakeDemonstrationSheet(set, datasets::ReadViewSet(root), sheet_options);
  bar.Clear();
  perception::WritePng(options.out, sheet);
  if (options.json) {
    console.Print({{"file", options.out},
                   {"width_px", sheet.width()},
                   {"height_px", sheet.height()},
                   {"num_poses", set.items.size()}});
  } else {
    console.out << "Wrote " << options.out << '\n';
  }
}

void AddPoseOptions(CLI::App& command, DataPreviewOptions& options) {
  CLI::Option* poses = command.add_flag(
      "--poses", options.shows_poses, "Instead: views of a demonstration set, hands at its poses");
  AddNumber(command,
            "--poses-per-view",
            options.poses,
            &datasets::DemonstrationSheetOptions::poses_per_view,
            "At most this many hands in a view, evenly spread over its poses")
      ->needs(poses);
  for (const char* other : {"--split", "--class", "--page"}) {
    poses->excludes(command.get_option(other));
  }
}

void AddPageOptions(CLI::App& command, DataPreviewOptions& options) {
  using datasets::PageOptions;
  CLI::Option* page = AddNumber(command,
                                "--page",
                                options.page,
                                &PageOptions::page,
                                "Instead: this page of all pictures, in the manifest's order");
  page->each([&options](const std::string&) { options.is_page = true; });
  AddNumber(command, "--columns", options.page, &PageOptions::columns, "Pictures across a page")
      ->needs(page);
  AddNumber(command, "--rows", options.page, &PageOptions::rows, "Pictures down a page")
      ->needs(page);
}

}  // namespace

void AddDataPreview(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataPreviewOptions>();
  CLI::App* command = parent.add_subcommand(
      "preview", "Draw a contact sheet: a row a class, each picture as it is and with its labels");
  command
      ->add_option("DIR", options->folder, "Folder with manifest.csv, or with demonstrations.csv")
      ->required();
  command->add_option("--out", options->out, "PNG to write")->type_name("FILE")->required();
  command->add_option("--split", options->split, "Pictures of this split alone")->type_name("NAME");
  command->add_option("--class", options->object_class, "Pictures of this class alone")
      ->type_name("NAME");
  AddNumber(*command,
            "--images-per-class",
            options->overview,
            &datasets::OverviewOptions::images_per_class,
            "At most this many of each class, evenly spread over it");
  AddPageOptions(*command, *options);
  AddNumber(*command,
            "--tile-width",
            options->tile_width_px,
            TakenBy(&datasets::OverviewOptions::tile_width_px),
            "Width of a picture on the sheet [px]")
      ->default_str("128, on a page 160");
  AddPoseOptions(*command, *options);
  AddThreadsOption(*command, options->page.num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data preview datasets/samples/cornell_mini --out out/sheet.png");
  command->callback([options, &console] {
    if (options->shows_poses) {
      RunPosesPreview(*options, console);
    } else {
      RunDataPreview(*options, console);
    }
  });
}

}  // namespace handcraft::tools
