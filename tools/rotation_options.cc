// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/rotation_options.h"

#include "tools/number_option.h"

namespace handcraft::tools {

void AddRotationOptions(CLI::App& command, RotationArguments& arguments) {
  command.add_option("--moments", arguments.moments, "What tells like planes apart")
      ->check(CLI::IsMember({"printed", "scale_free", "all"}))
      ->capture_default_str();
  AddNumber(command,
            "--candidates",
            arguments.num_candidates,
            TakenBy(&grasp_library::Options::num_candidates),
            "Views nearest by plane that are compared; 0: all; the dissertation's are 6");
  AddNumber(command,
            "--angle-weight",
            arguments.angle_weight,
            TakenBy(&grasp_library::Options::angle_weight),
            "Weight of the angle between planes beside the moments [1/rad]");
}

features::RotationRule RuleOf(const RotationArguments& arguments) {
  using features::ComparedMoments;
  return {.moments = arguments.moments == "printed"      ? ComparedMoments::kPrinted
                     : arguments.moments == "scale_free" ? ComparedMoments::kScaleFree
                                                         : ComparedMoments::kAll,
          .num_candidates = static_cast<std::size_t>(arguments.num_candidates),
          .angle_weight = arguments.angle_weight};
}

}  // namespace handcraft::tools
