// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/grasp_planning/grasp_library_input.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/model_io/grasp_library_models.h"
#include "lib/robot/robot_file.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"
#include "tools/rotation_options.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using experiments::GraspLibraryInput;
using Json = nlohmann::ordered_json;

struct TrainGraspLibraryOptions {
  std::string views;
  std::string demonstrations;
  std::string robot;
  std::string out;
  std::string name = "grasp_library";
  RotationArguments rotation = {};
  double max_distance_m = 0.0;
  int num_threads = 1;
  bool json = false;
};

grasp_library::Options TrainerOptions(const TrainGraspLibraryOptions& options) {
  return {.compared_moments = RuleOf(options.rotation).moments,
          .num_candidates = options.rotation.num_candidates,
          .angle_weight = options.rotation.angle_weight,
          .rejection_distance_m = options.max_distance_m};
}

// What a class of the library holds.
struct ClassCounts {
  std::string name;
  std::int32_t num_views = 0;
  std::int32_t num_angles = 0;
  std::int32_t num_poses = 0;
};

std::vector<ClassCounts> Count(const features::GraspLibrary& library,
                               const std::vector<std::string>& classes) {
  std::vector<ClassCounts> counts;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const auto first_angle = static_cast<std::size_t>(library.angle_begins[c]);
    const auto last_angle = static_cast<std::size_t>(library.angle_begins[c + 1]);
    counts.push_back(
        {.name = classes[c],
         .num_views = library.view_begins[c + 1] - library.view_begins[c],
         .num_angles = library.angle_begins[c + 1] - library.angle_begins[c],
         .num_poses = library.pose_begins[last_angle] - library.pose_begins[first_angle]});
  }
  return counts;
}

model_io::GraspLibraryNames NamesOf(const TrainGraspLibraryOptions& options,
                                    const grasp_library::TrainingSet& set) {
  model_io::GraspLibraryNames names{.classes = set.classes};
  if (options.robot.empty()) return names;
  const robot::RobotArm arm = robot::ReadRobotFile(options.robot);
  names.robot = arm.robot;
  for (const robot::Joint& joint : arm.chain.joints) names.joints.push_back(joint.name);
  return names;
}

std::vector<std::uint8_t> ModelBytes(const TrainGraspLibraryOptions& options,
                                     const GraspLibraryInput& input,
                                     const model_io::GraspLibraryNames& names,
                                     const features::GraspLibrary& library) {
  std::string class_counts;
  for (const ClassCounts& one : Count(library, names.classes)) {
    class_counts +=
        fmt::format("{}{}: {}", class_counts.empty() ? "" : ", ", one.name, one.num_poses);
  }
  const std::string fingerprints = datasets::Fingerprint(input.views) +
                                   datasets::Fingerprint(input.shown_views) +
                                   datasets::Fingerprint(input.demonstrations);
  return model_io::Serialise(model_io::MakeGraspLibraryModel(
      library,
      names,
      {.name = options.name,
       .task = "grasp_library",
       .intended_use = "end-effector poses for upright objects like those that were shown",
       .limits = "objects turn about z alone; the camera stands as in training",
       .algorithm = "grasp_library",
       .data_fingerprint = Sha256Hex(std::span(
           reinterpret_cast<const std::uint8_t*>(fingerprints.data()), fingerprints.size())),
       .class_counts = class_counts,
       .hyper_parameters = FieldsToText(TrainerOptions(options))}));
}

void PrintResult(const TrainGraspLibraryOptions& options,
                 const std::vector<ClassCounts>& counts,
                 const Console& console) {
  if (options.json) {
    Json classes = Json::array();
    for (const ClassCounts& one : counts) {
      classes.push_back({{"class", one.name},
                         {"views", one.num_views},
                         {"angles", one.num_angles},
                         {"poses", one.num_poses}});
    }
    console.Print({{"views", options.views},
                   {"demonstrations", options.demonstrations},
                   {"classes", classes},
                   {"model", options.out}});
    return;
  }
  TextTable table({"class", "views", "shown angles", "poses"});
  for (const ClassCounts& one : counts) {
    table.AddRow({one.name,
                  std::to_string(one.num_views),
                  std::to_string(one.num_angles),
                  std::to_string(one.num_poses)});
  }
  console.out << table.ToText();
  if (!options.out.empty()) console.out << "\nGrasp library written to " << options.out << '\n';
}

void RunTrainGraspLibrary(const TrainGraspLibraryOptions& options, const Console& console) {
  RequireWritable(options.out);
  const GraspLibraryInput input = experiments::ReadGraspLibraryInput(
      datasets::ReadViewSet(options.views), options.demonstrations);
  RequireNotAnInput(options.out, FilesOf(input.views));
  RequireNotAnInput(options.out, FilesOf(input.shown_views));
  grasp_library::TrainingSet set;
  {
    ProgressBar bar(console);
    set = experiments::DescribeInput(input, options.num_threads, bar.Callback());
  }
  const grasp_library::Options trainer = TrainerOptions(options);
  const features::GraspLibrary library = grasp_library::TrainGraspLibrary(set, trainer);
  const model_io::GraspLibraryNames names = NamesOf(options, set);
  if (!options.out.empty()) {
    WriteFileAtomically(options.out, ModelBytes(options, input, names, library));
  }
  PrintResult(options, Count(library, set.classes), console);
}

}  // namespace

void AddTrainGraspLibrary(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<TrainGraspLibraryOptions>();
  CLI::App* command = parent.add_subcommand(
      "grasp-library", "Object rotation from views, and end-effector poses from demonstrations");
  command->add_option("--views", options->views, "View set: every class at many angles")
      ->required();
  command
      ->add_option("--demonstrations", options->demonstrations, "Demonstration set with its views")
      ->required();
  command->add_option("--out", options->out, "Model file to write");
  command->add_option("--name", options->name, "Name of the model")->capture_default_str();
  command->add_option("--robot", options->robot, "Robot file of the arm that showed the poses");
  AddRotationOptions(*command, options->rotation);
  AddNumber(*command,
            "--max-distance-m",
            options->max_distance_m,
            TakenBy(&grasp_library::Options::rejection_distance_m),
            "Reject points farther from every demonstration; 0: never");
  AddThreadsOption(*command, options->num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command,
             "handcraft train grasp-library --views out/turntable --demonstrations out/shown "
             "--out grasp_library.safetensors");
  command->callback([options, &console] { RunTrainGraspLibrary(*options, console); });
}

}  // namespace handcraft::tools
