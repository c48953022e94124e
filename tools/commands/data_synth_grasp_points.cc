// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/synthetic/grasp_point_set.h"
#include "lib/core/counted.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"
#include "tools/synth_options.h"

namespace handcraft::tools {
namespace {

using synthetic::SetSize;
using synthetic::Surroundings;

struct DataSynthOptions {
  std::string out;
  std::string size = "small";
  std::string family = "trained";
  std::string surroundings = "household";
  std::string meshes;
  std::string camera;
  synthetic::GraspPointSetOptions set;
  bool json = false;
};

void RunGraspPoints(const DataSynthOptions& options, const Console& console) {
  synthetic::GraspPointSetOptions set_options = options.set;
  set_options.size = options.size == "full" ? SetSize::kFull : SetSize::kSmall;
  set_options.meshes = options.meshes;
  set_options.family = synthetic::FamilyNamed(options.family);
  set_options.surroundings =
      options.surroundings == "bare" ? Surroundings::kBare : Surroundings::kHousehold;
  ApplyCameraFile(options.camera, set_options.camera, set_options.baseline_m);
  ProgressBar bar(console);
  set_options.progress = bar.Callback();
  const synthetic::MadeImages made = synthetic::MakeGraspPointSet(options.out, set_options);
  const std::size_t num_images = made.set.items.size();
  bar.Clear();
  if (options.json) {
    console.Print({{"folder", options.out},
                   {"num_images", num_images},
                   {"num_images_written", made.written.num_pictures},
                   {"fingerprint", datasets::Fingerprint(made.set)}});
  } else {
    console.out << TellWritten(made.written,
                               num_images,
                               Counted(num_images, "image with a mask", "images with masks"),
                               options.out);
  }
}

void AddSize(CLI::App& command, DataSynthOptions& options) {
  CLI::Option* size =
      command
          .add_option(
              "--size", options.size, "small: 24 images a class; full: 13247 of the trained family")
          ->check(CLI::IsMember({"small", "full"}))
          ->capture_default_str();
  AddNumber(command,
            "--images",
            options.set.num_images,
            IntegerWithin(1, synthetic::kMaxImages),
            "This many instead, spread over the classes")
      ->default_str("")
      ->excludes(size);
}

}  // namespace

void AddDataSynthGraspPoints(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataSynthOptions>();
  CLI::App* command = parent.add_subcommand(
      "grasp-points",
      "Pictures of household objects on a table, what a person would hold labelled");
  AddSetFolder(*command, options->out);
  AddSize(*command, *options);
  command
      ->add_option("--family",
                   options->family,
                   "trained: nine classes to train on; novel: six others to test with; taught, "
                   "untaught, regrasp: six, eight and four kinds that a whole hand closes around")
      ->check(CLI::IsMember({"trained", "novel", "taught", "untaught", "regrasp"}))
      ->capture_default_str();
  command
      ->add_option("--surroundings",
                   options->surroundings,
                   "household: patterned table, sheets, books, cloths; bare: even colours alone")
      ->check(CLI::IsMember({"household", "bare"}))
      ->capture_default_str();
  command
      ->add_option("--meshes",
                   options->meshes,
                   "Folder of meshes with a meshes.toml, to take objects from besides")
      ->type_name("DIR");
  command->add_flag(
      "--stereo", options->set.with_right, "Also what a camera 0.12 m to the right sees");
  AddCameraFile(*command, options->camera);
  AddSeedOption(*command, options->set.seed);
  AddThreadsOption(*command, options->set.num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data synth grasp-points --out made --images 9");
  command->callback([options, &console] { RunGraspPoints(*options, console); });
}

}  // namespace handcraft::tools
