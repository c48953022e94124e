// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/synthetic/regrasp_set.h"
#include "lib/core/counted.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"
#include "tools/synth_options.h"

namespace handcraft::tools {
namespace {

using synthetic::HoldFault;
using synthetic::RegraspOptions;

struct DataSynthRegraspOptions {
  std::string out;
  std::string family = "regrasp";
  std::string sensor = "stereo";
  std::string camera;
  RegraspOptions set;
  bool json = false;
};

void RunRegrasp(const DataSynthRegraspOptions& options, const Console& console) {
  RegraspOptions set_options = options.set;
  set_options.family = synthetic::FamilyNamed(options.family);
  set_options.sensor = SensorNamed(options.sensor);
  ApplyCameraFile(options.camera, set_options.camera, set_options.baseline_m);
  ProgressBar bar(console);
  set_options.progress = bar.Callback();
  const synthetic::MadeRegrasps made = synthetic::MakeRegraspSet(options.out, set_options);
  bar.Clear();
  if (options.json) {
    console.Print({{"folder", options.out},
                   {"num_poses", made.demonstrations.items.size()},
                   {"num_holds", made.holds.items.size()},
                   {"num_views_written", made.written.num_pictures},
                   {"fingerprint", datasets::Fingerprint(made.holds)},
                   {"pairs",
                    {{"valid", made.counts[HoldFault::kNone]},
                     {"near the table", made.counts[HoldFault::kNearTable]},
                     {"hands meet", made.counts[HoldFault::kHandsMeet]}}}});
  } else {
    const std::string contents = Counted(made.demonstrations.items.size(), "pose") + " and " +
                                 Counted(made.holds.items.size(), "hold");
    console.out << TellWritten(made.written, made.num_views, contents, options.out);
  }
}

}  // namespace

void AddDataSynthRegrasp(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataSynthRegraspOptions>();
  CLI::App* command = parent.add_subcommand(
      "regrasp", "Objects that one arm reaches, and poses at which two hands hold them");
  AddSetFolder(*command, options->out);
  AddObjectFamily(*command, options->family);
  AddNumber(*command,
            "--configurations",
            options->set,
            &RegraspOptions::num_configurations,
            "Places and turns of each object");
  AddNumber(*command,
            "--poses",
            options->set,
            &RegraspOptions::poses_per_view,
            "Poses of the right hand alone in each view");
  AddNumber(*command,
            "--holds",
            options->set,
            &RegraspOptions::holds_per_view,
            "Pairs of poses of both hands in each view");
  AddCloudSensor(*command, options->sensor);
  AddCameraFile(*command, options->camera);
  AddSeedOption(*command, options->set.seed);
  AddThreadsOption(*command, options->set.num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command,
             "handcraft data synth regrasp --out regrasp --configurations 1 --sensor "
             "depth-camera");
  command->callback([options, &console] { RunRegrasp(*options, console); });
}

}  // namespace handcraft::tools
