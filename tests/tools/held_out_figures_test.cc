// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/held_out_figures.h"

#include <limits>

#include <gmock/gmock.h>

#include "experiments/evaluation/loaded_model.h"
#include "lib/core/file.h"
#include "tests/tools/support/generated_data.h"

namespace handcraft::tools {
namespace {

using ::testing::Pair;
using ::testing::UnorderedElementsAre;

class EvaluateHeldOutTest : public testing::ImageSetTest {};

// A model in memory gives the figures that its file gives.
TEST_F(EvaluateHeldOutTest, IsTheEvaluationOfTheFile) {
  testing::TrainGraspPoints(set_, folder_ / "m");
  const datasets::LabelledImageSet test = datasets::ReadLabelledImageSet(set_).Only("test");
  const auto expected =
      experiments::EvaluateGraspPoints(experiments::LoadModel(folder_ / "m").get(), test, {});
  const auto evaluation = EvaluateHeldOut(ReadFile(folder_ / "m"), test, {});
  EXPECT_EQ(ToJson(evaluation, test), ToJson(expected, test));
}

TEST(MetadataOfEvaluation, LeavesOutWhatIsNotANumber) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  experiments::GraspPointEvaluation evaluation;
  evaluation.data_fingerprint = "abc";
  evaluation.all.num_images = 2;
  evaluation.all.confusion = {.true_positive = 3, .false_negative = 1};
  evaluation.all.accuracy = {.value = 0.75, .low = 0.5, .high = 1.0};
  evaluation.all.auc = {.value = kNan, .low = kNan, .high = kNan};
  evaluation.all.best_pixel_accuracy = {.value = 1.0, .low = kNan, .high = kNan};
  evaluation.all.log_loss.value = 0.25;
  EXPECT_THAT(MetadataOf(evaluation, "test"),
              UnorderedElementsAre(Pair("held_out.split", "test"),
                                   Pair("held_out.data_fingerprint", "abc"),
                                   Pair("held_out.num_images", "2"),
                                   Pair("held_out.num_pixels", "4"),
                                   Pair("held_out.log_loss", "0.25"),
                                   Pair("held_out.accuracy", "0.75"),
                                   Pair("held_out.accuracy_low", "0.5"),
                                   Pair("held_out.accuracy_high", "1"),
                                   Pair("held_out.best_pixel_accuracy", "1")));
}

}  // namespace
}  // namespace handcraft::tools
