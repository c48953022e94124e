// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/synthetic/demonstrations.h"
#include "lib/core/counted.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"
#include "tools/synth_options.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using synthetic::ClassReport;
using synthetic::DemonstrationOptions;
using synthetic::GraspCounts;
using synthetic::GraspFault;

struct DataSynthDemonstrationsOptions {
  std::string out;
  std::string family = "taught";
  std::string sensor = "stereo";
  std::string camera;
  std::string size = "small";
  DemonstrationOptions set;
  bool json = false;
};

nlohmann::json CountsToJson(const GraspCounts& counts) {
  nlohmann::json json = nlohmann::json::object();
  for (std::size_t i = 0; i < synthetic::kNumGraspFaults; ++i) {
    json[std::string(NameOf(static_cast<GraspFault>(i)))] = counts.by_fault[i];
  }
  return json;
}

nlohmann::json ReportToJson(const ClassReport& report) {
  return {{"class", report.object_class},
          {"num_poses", report.num_poses},
          {"width_m",
           {{"least", report.least_width_m},
            {"mean", report.mean_width_m},
            {"greatest", report.greatest_width_m}}},
          {"sampled", CountsToJson(report.sampled)},
          {"shown", CountsToJson(report.shown)}};
}

void PrintReports(const std::vector<ClassReport>& reports, const Console& console) {
  TextTable table({"class", "poses", "width [mm]", "tries"});
  for (const ClassReport& report : reports) {
    table.AddRow({report.object_class,
                  std::to_string(report.num_poses),
                  fmt::format("{:.0f} ({:.0f} to {:.0f})",
                              1000.0F * report.mean_width_m,
                              1000.0F * report.least_width_m,
                              1000.0F * report.greatest_width_m),
                  std::to_string(report.shown.Total())});
  }
  console.out << table.ToText();
}

void RunDemonstrations(const DataSynthDemonstrationsOptions& options, const Console& console) {
  DemonstrationOptions set_options = options.set;
  synthetic::ViewSetOptions& views = set_options.views;
  views.family = synthetic::FamilyNamed(options.family);
  views.sensor = SensorNamed(options.sensor);
  set_options.quota =
      options.size == "full" ? synthetic::PoseQuota::kFull : synthetic::PoseQuota::kSmall;
  ApplyCameraFile(options.camera, views.camera, views.baseline_m);
  ProgressBar bar(console);
  views.progress = bar.Callback();
  const synthetic::MadeDemonstrations made =
      synthetic::MakeDemonstrations(options.out, set_options);
  bar.Clear();
  if (options.json) {
    nlohmann::json classes = nlohmann::json::array();
    for (const ClassReport& report : made.reports) classes.push_back(ReportToJson(report));
    console.Print({{"folder", options.out},
                   {"num_poses", made.set.items.size()},
                   {"num_views_written", made.written.num_pictures},
                   {"fingerprint", datasets::Fingerprint(made.set)},
                   {"classes", classes}});
    return;
  }
  PrintReports(made.reports, console);
  console.out << TellWritten(
      made.written, made.num_views, Counted(made.set.items.size(), "pose"), options.out);
}

}  // namespace

void AddDataSynthDemonstrations(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataSynthDemonstrationsOptions>();
  CLI::App* command = parent.add_subcommand(
      "demonstrations", "Views of objects on a turntable, and poses at which a hand holds them");
  AddSetFolder(*command, options->out);
  AddObjectFamily(*command, options->family);
  CLI::Option* size =
      command
          ->add_option("--size",
                       options->size,
                       "small: 40 poses a view; full: 23948 of the taught family, as in the "
                       "dissertation, or 333 a view")
          ->check(CLI::IsMember({"small", "full"}))
          ->capture_default_str();
  AddNumber(*command,
            "--poses",
            options->set.poses_per_view,
            IntegerWithin(1, synthetic::kMaxPosesPerView),
            "This many in each view instead")
      ->default_str("")
      ->excludes(size);
  AddNumber(*command,
            "--views",
            options->set.views.num_views,
            TakenBy(&synthetic::ViewSetOptions::num_views),
            "Views of each class");
  AddCloudSensor(*command, options->sensor);
  AddCameraFile(*command, options->camera);
  AddSeedOption(*command, options->set.views.seed);
  AddThreadsOption(*command, options->set.views.num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command,
             "handcraft data synth demonstrations --out shown --views 1 --sensor depth-camera");
  command->callback([options, &console] { RunDemonstrations(*options, console); });
}

}  // namespace handcraft::tools
