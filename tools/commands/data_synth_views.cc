// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/synthetic/view_sets.h"
#include "lib/core/counted.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"
#include "tools/synth_options.h"

namespace handcraft::tools {
namespace {

using synthetic::ViewSetKind;
using synthetic::ViewSetOptions;

struct DataSynthViewsOptions {
  std::string out;
  std::string family = "taught";
  std::string sensor = "stereo";
  std::string camera;
  ViewSetOptions set;
  bool json = false;
};

void RunViews(const DataSynthViewsOptions& options, const Console& console) {
  ViewSetOptions set_options = options.set;
  set_options.family = synthetic::FamilyNamed(options.family);
  set_options.sensor = SensorNamed(options.sensor);
  ApplyCameraFile(options.camera, set_options.camera, set_options.baseline_m);
  ProgressBar bar(console);
  set_options.progress = bar.Callback();
  const synthetic::MadeViews made = synthetic::MakeViewSet(options.out, set_options);
  const std::size_t num_views = made.set.items.size();
  bar.Clear();
  if (options.json) {
    console.Print({{"folder", options.out},
                   {"num_views", num_views},
                   {"num_views_written", made.written.num_pictures},
                   {"fingerprint", datasets::Fingerprint(made.set)}});
  } else {
    console.out << TellWritten(made.written, num_views, Counted(num_views, "view"), options.out);
  }
}

CLI::Validator CameraNoiseRule(float synthetic::CameraNoise::*field) {
  return CheckNumber<float>([field](float value) -> std::string {
    ViewSetOptions options;
    options.camera_noise.*field = value;
    try {
      options.Validate();
    } catch (const Error& refusal) {
      return RuleOf(refusal);
    }
    return "";
  });
}

void AddViews(CLI::App& command, DataSynthViewsOptions& options) {
  AddSetFolder(command, options.out);
  AddObjectFamily(command, options.family);
  AddNumber(command, "--views", options.set, &ViewSetOptions::num_views, "Views of each class");
  AddCloudSensor(command, options.sensor);
  AddNumber(command,
            "--camera-noise-m",
            options.set.camera_noise.position_m,
            CameraNoiseRule(&synthetic::CameraNoise::position_m),
            "Standard deviation of the camera's place between views, along each axis [m]");
  AddNumber(command,
            "--camera-noise-deg",
            options.set.camera_noise.angle_deg,
            CameraNoiseRule(&synthetic::CameraNoise::angle_deg),
            "Standard deviation of the camera's turn between views, about each axis [degrees]");
  AddCameraFile(command, options.camera);
  AddSeedOption(command, options.set.seed);
  AddThreadsOption(command, options.set.num_threads);
  AddJsonFlag(command, options.json);
}

}  // namespace

void AddDataSynthTurntable(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataSynthViewsOptions>();
  CLI::App* command = parent.add_subcommand(
      "turntable", "Views of objects that are turned by equal steps, with measured clouds");
  AddViews(*command, *options);
  SetExample(*command, "handcraft data synth turntable --out turntable --views 2");
  command->callback([options, &console] { RunViews(*options, console); });
}

void AddDataSynthMoved(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataSynthViewsOptions>();
  options->set.kind = ViewSetKind::kMoved;
  options->set.num_views = 30;
  CLI::App* command = parent.add_subcommand(
      "moved", "Views of the same objects in random places, turned and scaled, with clouds");
  AddViews(*command, *options);
  SetExample(*command, "handcraft data synth moved --out moved --views 2");
  command->callback([options, &console] { RunViews(*options, console); });
}

}  // namespace handcraft::tools
