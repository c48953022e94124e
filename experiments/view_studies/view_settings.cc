// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_settings.h"

#include <array>

#include "experiments/runner/setting_values.h"
#include "lib/features/grasp_search.h"

namespace handcraft::experiments {
namespace {

using features::ClassScheme;
using features::CloudDescriptorType;
using features::CloudFrame;
using features::CloudScaling;
using features::ComparedMoments;
using features::GridBox;
using features::SimilarityType;

template <class Number>
Number ParseWithin(const Setting& setting, Number low, Number high) {
  const std::string rule = fmt::format("a number from {} to {}", low, high);
  const auto number = ParseNumber<Number>(setting, rule);
  if (!(number >= low && number <= high)) FailSetting(setting, rule);
  return number;
}

double ParseAboveZero(const Setting& setting) {
  constexpr std::string_view kRule = "a number above 0";
  const auto number = ParseNumber<double>(setting, kRule);
  if (!(number > 0.0)) FailSetting(setting, kRule);
  return number;
}

double ParseFromZero(const Setting& setting) { return ParseWithin(setting, 0.0, 1e9); }

bool ParseSwitch(const Setting& setting) {
  if (setting.value != "yes" && setting.value != "no") FailSetting(setting, "yes or no");
  return setting.value == "yes";
}

struct Key {
  std::string_view name;
  void (*apply)(const Setting& setting, ViewSettings& settings);
};

constexpr std::array kKeys = {
    Key{"descriptor",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.descriptor.type = ParseWord(setting,
                                                       {CloudDescriptorType::kGrid,
                                                        CloudDescriptorType::kDepthGrid,
                                                        CloudDescriptorType::kPolar,
                                                        CloudDescriptorType::kViewpointHistogram,
                                                        CloudDescriptorType::kShapeFunctions});
        }},
    Key{"grid_size",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.descriptor.grid_size = ParseWithin(setting, 1, features::kMaxGridSize);
        }},
    Key{"scaling",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.descriptor.scaling =
              ParseWord(setting, {CloudScaling::kMetric, CloudScaling::kUnit});
        }},
    Key{"frame",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.descriptor.frame =
              ParseWord(setting, {CloudFrame::kBase, CloudFrame::kCamera});
        }},
    Key{"outlier_step",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.outlier_step = ParseWithin(setting, 0.0, 100.0);
        }},
    Key{"box",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.descriptor.box =
              ParseWord(setting, {GridBox::kFitted, GridBox::kSquare});
        }},
    Key{"moved_copies",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.moved.num_copies = ParseWithin(setting, 0, 100);
        }},
    Key{"kernel",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.svm.kernel = ParseWord(
              setting,
              {SimilarityType::kLinear, SimilarityType::kPolynomial, SimilarityType::kRbf});
        }},
    Key{"degree",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.svm.degree = ParseWithin(setting, 1, 1000);
        }},
    Key{"gamma",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.svm.gamma = ParseFromZero(setting);
        }},
    Key{"coef0",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.svm.coef0 = ParseFromZero(setting);
        }},
    Key{"C",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.svm.penalty = ParseAboveZero(setting);
        }},
    Key{"scheme",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.svm.scheme =
              setting.value == "one-against-all"   ? ClassScheme::kOneAgainstAll
              : setting.value == "one-against-one" ? ClassScheme::kOneAgainstOne
                                                   : (FailSetting(setting,
                                                                  "one-against-one or "
                                                                  "one-against-all"),
                                                      ClassScheme::kOneAgainstOne);
        }},
    Key{"standardize",
        [](const Setting& setting, ViewSettings& settings) {
          settings.classes.svm.standardize = ParseSwitch(setting);
        }},
    Key{"rejection",
        [](const Setting& setting, ViewSettings& settings) {
          settings.rejection =
              ParseWord(setting, {ClassRejection::kNone, ClassRejection::kCalibrated});
        }},
    Key{"moments",
        [](const Setting& setting, ViewSettings& settings) {
          settings.rotation.moments = ParseWord(
              setting,
              {ComparedMoments::kPrinted, ComparedMoments::kScaleFree, ComparedMoments::kAll});
        }},
    Key{"candidates",
        [](const Setting& setting, ViewSettings& settings) {
          settings.rotation.num_candidates =
              ParseWithin(setting, std::size_t{0}, features::kMaxCandidates);
        }},
    Key{"angle_weight",
        [](const Setting& setting, ViewSettings& settings) {
          settings.rotation.angle_weight = ParseFromZero(setting);
        }},
    Key{"neighbours",
        [](const Setting& setting, ViewSettings& settings) {
          settings.grasps.num_neighbours =
              ParseWithin(setting, std::size_t{1}, features::kMaxGraspNeighbours);
        }},
    Key{"max_distance_m",
        [](const Setting& setting, ViewSettings& settings) {
          settings.grasps.max_distance_m = ParseFromZero(setting);
        }},
    Key{"held_out",
        [](const Setting& setting, ViewSettings& settings) {
          settings.grasps.held_out =
              ParseWord(setting, {HeldOutPart::kDemonstration, HeldOutPart::kView});
        }},
    Key{"attempts",
        [](const Setting& setting, ViewSettings& settings) {
          settings.grasps.max_attempts =
              ParseWithin(setting, 1, static_cast<int>(features::kMaxRankedGrasps));
        }},
    Key{"robot",
        [](const Setting& setting, ViewSettings& settings) {
          settings.grasps.robot = setting.value;
        }},
    Key{"grasp_points",
        [](const Setting& setting, ViewSettings& settings) {
          settings.grasps.grasp_points = setting.value;
        }},
    Key{"click",
        [](const Setting& setting, ViewSettings& settings) {
          settings.grasps.click = ParseWord(setting, {GraspClick::kPicture, GraspClick::kObject});
        }},
    Key{"told_class",
        [](const Setting& setting, ViewSettings& settings) {
          settings.grasps.is_class_told = ParseSwitch(setting);
        }},
    Key{"position",
        [](const Setting& setting, ViewSettings& settings) {
          settings.grasps.position =
              ParseWord(setting, {GraspPosition::kGraspPoint, GraspPosition::kDemonstration});
        }},
    Key{"num_classes",
        [](const Setting& setting, ViewSettings& settings) {
          settings.num_classes = ParseWithin(setting, std::size_t{0}, std::size_t{4096});
        }},
};

constexpr auto kKeyNames = [] {
  std::array<std::string_view, kKeys.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kKeys[i].name;
  return names;
}();

}  // namespace

std::string_view NameOf(ClassRejection rejection) noexcept {
  return rejection == ClassRejection::kNone ? "none" : "calibrated";
}

std::string_view NameOf(HeldOutPart part) noexcept {
  return part == HeldOutPart::kDemonstration ? "demonstration" : "view";
}

std::string_view NameOf(GraspClick click) noexcept {
  return click == GraspClick::kPicture ? "picture" : "object";
}

std::span<const std::string_view> ViewSettingKeys() { return kKeyNames; }

void ApplyViewSetting(const Setting& setting, ViewSettings& settings) {
  ApplyByKey(kKeys, kKeyNames, setting, settings);
}

}  // namespace handcraft::experiments
