// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/evaluation/grasp_point_evaluation.h"
#include "experiments/evaluation/grasp_point_figures.h"

namespace handcraft::experiments {

/// A line of the model's description, as plain text.
struct ModelFact {
  std::string name;
  std::string value;
};

/// One image of the gallery; the pictures are JPEG files in memory.
struct ReportPicture {
  std::string name;
  std::string object_class;
  BestPixelCounts best;
  std::vector<std::uint8_t> overlay_jpeg;
  std::vector<std::uint8_t> mask_jpeg;
  std::vector<std::uint8_t> close_up_jpeg;  ///< empty without best pixels
};

struct ReportContents {
  std::string model_name = {};
  std::string data_name = {};
  std::vector<ModelFact> model_facts = {};
  std::vector<ReportPicture> pictures = {};  ///< all images of the set, or some of them
};

/// The report page as HTML. Pure: reads no file and no clock, so that the same contents give the
/// same bytes.
[[nodiscard]] std::string MakeGraspPointPage(const GraspPointEvaluation& evaluation,
                                             const ReportContents& contents);

}  // namespace handcraft::experiments
