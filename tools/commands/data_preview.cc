// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "datasets/contact_sheet.h"
#include "datasets/demonstration_sheet.h"
#include "datasets/sheet_pictures.h"
#include "datasets/stored_set.h"
#include "lib/core/utf8.h"
#include "lib/perception/image_io.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"

namespace handcraft::tools {
namespace {

namespace fs = std::filesystem;

enum class Shown { kWhole, kCloseUp, kPoses, kHolds };

struct DataPreviewOptions {
  std::string folder;
  std::string out;
  std::string split;
  std::string object_class;
  datasets::OverviewOptions overview;
  datasets::PageOptions page;
  int tile_width_px = 0;
  Shown shown = Shown::kWhole;
  bool is_page = false;
  datasets::DemonstrationSheetOptions poses;
  bool json = false;

  [[nodiscard]] bool ShowsHands() const { return shown == Shown::kPoses || shown == Shown::kHolds; }
};

// A set and its pictures, which refer to it.
struct Gallery {
  datasets::StoredSet set;
  std::vector<datasets::SheetPicture> pictures;

  [[nodiscard]] std::vector<fs::path> Files() const {
    return std::visit([](const auto& of_kind) { return FilesOf(of_kind); }, set.pictures);
  }
};

// `poses` are demonstrations or holds.
template <class Poses>
void ShowHands(const DataPreviewOptions& options, const Poses& poses, Gallery& gallery) {
  const auto& views =
      gallery.set.pictures.emplace<datasets::ViewSet>(datasets::ReadViewSet(poses.root));
  datasets::DemonstrationSheetOptions sheet = options.poses;
  if (options.tile_width_px > 0) sheet.tile_width_px = options.tile_width_px;
  gallery.pictures = datasets::SheetPicturesOf(poses, views, sheet);
}

std::unique_ptr<Gallery> OpenGallery(const DataPreviewOptions& options) {
  auto gallery = std::make_unique<Gallery>();
  const fs::path root(options.folder);
  if (options.shown == Shown::kPoses) {
    ShowHands(options, datasets::ReadDemonstrationSet(root), *gallery);
  } else if (options.shown == Shown::kHolds) {
    ShowHands(options, datasets::ReadHoldSet(root), *gallery);
  } else {
    gallery->set = datasets::OpenSet(root);
    const datasets::Framing framing =
        options.shown == Shown::kCloseUp ? datasets::Framing::kCloseUp : datasets::Framing::kWhole;
    gallery->pictures =
        std::visit([&](const auto& of_kind) { return SheetPicturesOf(of_kind, framing); },
                   gallery->set.pictures);
  }
  return gallery;
}

// The width of a tile when the user asks for none.
int TileWidth(const DataPreviewOptions& options, int usual_px) {
  if (options.tile_width_px > 0) return options.tile_width_px;
  return options.ShowsHands() ? options.poses.tile_width_px : usual_px;
}

Image DrawSheet(const DataPreviewOptions& options,
                const std::vector<datasets::SheetPicture>& pictures,
                const Progress& progress) {
  if (options.is_page) {
    datasets::PageOptions page = options.page;
    page.progress = progress;
    // Two tiles a picture: narrower, so that a page still fits a screen.
    page.shows_first = options.shown == Shown::kCloseUp;
    page.tile_width_px = TileWidth(options, page.shows_first ? 128 : page.tile_width_px);
    return datasets::DrawPage(pictures, page);
  }
  datasets::OverviewOptions overview = options.overview;
  overview.progress = progress;
  overview.num_threads = options.page.num_threads;
  overview.tile_width_px = TileWidth(options, overview.tile_width_px);
  return datasets::DrawOverview(pictures, overview);
}

void RunDataPreview(const DataPreviewOptions& options, const Console& console) {
  RequireWritable(options.out);
  if (fs::path(options.out).extension() != ".png") {
    throw Error({.kind = Error::Kind::kUsage,
                 .path = options.out,
                 .reason = "--out: the sheet is written as PNG",
                 .remedy = "name a file that ends in .png"});
  }
  const std::unique_ptr<Gallery> gallery = OpenGallery(options);
  RequireNotAnInput(options.out, gallery->Files());
  const std::vector<datasets::SheetPicture> pictures =
      datasets::Choose(gallery->pictures, options.split, options.object_class);
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
    console.out << "Wrote " << OnOneLine(options.out);
    if (options.is_page) console.out << ", page " << options.page.page << " of " << num_pages;
    console.out << '\n';
  }
}

CLI::Option* AddShown(CLI::App& command,
                      const std::string& name,
                      Shown shown,
                      DataPreviewOptions& options,
                      const std::string& description) {
  return command.add_flag_callback(
      name, [&options, shown] { options.shown = shown; }, description);
}

void AddShownOptions(CLI::App& command, DataPreviewOptions& options) {
  CLI::Option* close_up = AddShown(command,
                                   "--close-up",
                                   Shown::kCloseUp,
                                   options,
                                   "Labels on a close-up of each object, beside the whole picture");
  CLI::Option* poses = AddShown(command,
                                "--poses",
                                Shown::kPoses,
                                options,
                                "Views of a demonstration set with hands at its poses");
  CLI::Option* holds = AddShown(command,
                                "--holds",
                                Shown::kHolds,
                                options,
                                "Views of a set with holds, with both hands of each");
  poses->excludes(close_up);
  holds->excludes(close_up)->excludes(poses);
  AddNumber(command,
            "--poses-per-view",
            options.poses,
            &datasets::DemonstrationSheetOptions::poses_per_view,
            "At most this many poses or holds in a view, evenly spread over its rows");
}

void RequireHands(const CLI::App& command, const DataPreviewOptions& options) {
  if (options.ShowsHands() || command.count("--poses-per-view") == 0) return;
  throw Error({.kind = Error::Kind::kUsage,
               .reason = "--poses-per-view counts hands, and none are drawn",
               .remedy = "give --poses or --holds"});
}

// The option that asks for a page.
CLI::Option* AddPageOptions(CLI::App& command, DataPreviewOptions& options) {
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
  return page;
}

}  // namespace

void AddDataPreview(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataPreviewOptions>();
  CLI::App* command = parent.add_subcommand(
      "preview", "Draw a contact sheet: a row a class, each picture as it is and with its labels");
  command
      ->add_option(
          "DIR", options->folder, "Folder with manifest.csv, views.csv or demonstrations.csv")
      ->required();
  command->add_option("--out", options->out, "PNG to write")->type_name("FILE")->required();
  command->add_option("--split", options->split, "Pictures of this split alone")->type_name("NAME");
  command->add_option("--class", options->object_class, "Pictures of this class alone")
      ->type_name("NAME");
  AddNumber(*command,
            "--images-per-class",
            options->overview,
            &datasets::OverviewOptions::images_per_class,
            "At most this many of each class, evenly spread over it")
      ->excludes(AddPageOptions(*command, *options));
  AddNumber(*command,
            "--tile-width",
            options->tile_width_px,
            TakenBy(&datasets::OverviewOptions::tile_width_px),
            "Width of a picture on the sheet [px]")
      ->default_str("128, on a page without close-ups 160, with poses or holds 240");
  AddShownOptions(*command, *options);
  AddThreadsOption(*command, options->page.num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data preview datasets/samples/cornell_mini --out sheet.png");
  command->callback([options, command, &console] {
    RequireHands(*command, *options);
    RunDataPreview(*options, console);
  });
}

}  // namespace handcraft::tools
