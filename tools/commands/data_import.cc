// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "datasets/importers/cornell.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"

namespace handcraft::tools {
namespace {

struct ImportCornellOptions {
  std::string source;
  std::string out;
  datasets::CornellOptions cornell;
  bool json = false;
};

void AddPolicyOptions(CLI::App& command, datasets::CornellOptions& cornell) {
  AddNumber(command,
            "--good-share",
            cornell,
            &datasets::CornellOptions::good_share,
            "Central share of a rectangle's opening that is good, the rest is don't care");
  AddNumber(command,
            "--dont-care-margin",
            cornell,
            &datasets::CornellOptions::dont_care_margin_px,
            "Nothing nearer than this to a rectangle is called bad [px]");
  command.add_flag_callback(
      "--no-negative-rectangles",
      [&cornell] { cornell.use_negative_rectangles = false; },
      "Do not call the inside of negative rectangles (cneg) bad");
  AddNumber(command,
            "--instance-span",
            cornell,
            &datasets::CornellOptions::instance_span,
            "Numbers that make one instance: neighbours show the same object");
  AddNumber(command,
            "--test-share",
            cornell,
            &datasets::CornellOptions::test_share,
            "Share of the instances put into 'test'");
  AddNumber(command,
            "--split-gap",
            cornell,
            &datasets::CornellOptions::split_gap,
            "Training pictures this close in number to the test ones are left out");
  AddNumber(command,
            "--max-images",
            cornell,
            &datasets::CornellOptions::max_images,
            "Keep this many, evenly spread over the numbers; 0: all");
  command.add_option("--licence", cornell.licence, "Written into the manifest")
      ->capture_default_str();
}

void RunImportCornell(const ImportCornellOptions& options, const Console& console) {
  ProgressBar bar(console);
  datasets::CornellOptions cornell = options.cornell;
  cornell.progress = bar.Callback();
  const datasets::LabelledImageSet set =
      datasets::ImportCornell(options.source, options.out, cornell);
  bar.Clear();
  if (options.json) {
    console.Print({{"folder", options.out},
                   {"num_images", set.items.size()},
                   {"fingerprint", datasets::Fingerprint(set)}});
  } else {
    console.out << "Wrote " << set.items.size() << " images with masks to " << options.out << '\n';
  }
}

}  // namespace

void AddDataImport(CLI::App& parent, const Console& console) {
  CLI::App* import = parent.add_subcommand("import", "Turn a public data set into a labelled one");
  import->require_subcommand(1);
  auto options = std::make_shared<ImportCornellOptions>();
  CLI::App* command = import->add_subcommand(
      "cornell", "Cornell grasping data set: photographs and grasp rectangles into label masks");
  command
      ->add_option("SRC",
                   options->source,
                   "Folder with pcdNNNNr.png beside pcdNNNNcpos.txt, in one folder or in 01, 02, …")
      ->required();
  command->add_option("--out", options->out, "Folder to make; must not exist or be empty")
      ->type_name("DIR")
      ->required();
  AddPolicyOptions(*command, options->cornell);
  AddThreadsOption(*command, options->cornell.num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data import cornell tests/data/cornell --out out/cornell");
  command->callback([options, &console] { RunImportCornell(*options, console); });
}

}  // namespace handcraft::tools
