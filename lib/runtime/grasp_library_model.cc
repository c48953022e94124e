// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/grasp_library_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "lib/runtime/content_reader.h"

namespace handcraft::runtime {
namespace {

using features::kNumMoments;
using Integers = std::vector<std::int32_t>;
using Numbers = std::vector<double>;

constexpr double kUnitTolerance = 1e-6;
constexpr double kFarthestM = 100.0;
constexpr std::size_t kOutputs = 8;  // α_g, position, quaternion

/// Reads the tensors of § 11 one after another; the first fault ends it.
class GraspLibraryLoader {
 public:
  explicit GraspLibraryLoader(const ParsedModel& parsed) noexcept : reader_(parsed) {}

  Result<GraspLibraryModel> Load() {
    const bool complete = ReadRule() && ReadViews() && ReadAngles() && ReadPoses() &&
                          ReadRejection() && ReadSelfTest() && reader_.RefuseUnknownTensors();
    if (!complete) return reader_.error();
    if (const std::optional<ModelError> error = RunSelfTest()) return *error;
    return std::move(model_);
  }

 private:
  bool ReadRule();
  bool ReadViews();
  bool ReadAngles();
  bool ReadPoses();
  bool ReadRejection();
  bool ReadSelfTest();
  std::optional<ModelError> RunSelfTest();

  bool Require(bool holds, const char* tensor, std::size_t entry, double value, const char* rule);
  bool ReadBegins(const char* tensor, std::size_t num_groups, Integers& begins);
  bool ReadRoundAngles(const char* tensor, std::size_t count, Numbers& angles_rad);
  bool ReadUnits(const char* tensor, std::size_t count, std::size_t width, Numbers& rows);
  bool ReadPlaces(const char* tensor, std::size_t count, Numbers& rows);

  ContentReader reader_;
  GraspLibraryModel model_;
  features::GraspLibrary& library_ = model_.library;
  std::vector<float> test_points_;
  std::vector<std::uint8_t> test_mask_;
  std::size_t test_width_ = 0;
  Numbers test_point_;
  Numbers test_output_;
  double test_tolerance_ = 0.0;
};

bool GraspLibraryLoader::Require(
    bool holds, const char* tensor, std::size_t entry, double value, const char* rule) {
  if (holds) return true;
  return reader_.Fail(MakeError(HC_ERROR_CONTENT,
                                reader_.OffsetOf(tensor),
                                "entry %zu of the tensor '%s' is %g; %s was expected",
                                entry,
                                tensor,
                                value,
                                rule));
}

// num_groups + 1 numbers from 0, strictly rising: no group is empty.
bool GraspLibraryLoader::ReadBegins(const char* tensor, std::size_t num_groups, Integers& begins) {
  if (!reader_.Read(tensor, {num_groups + 1}, begins) ||
      !Require(begins[0] == 0, tensor, 0, begins[0], "0")) {
    return false;
  }
  for (std::size_t i = 1; i < begins.size(); ++i) {
    if (!Require(begins[i] > begins[i - 1], tensor, i, begins[i], "more than the entry before")) {
      return false;
    }
  }
  return true;
}

bool GraspLibraryLoader::ReadRoundAngles(const char* tensor,
                                         std::size_t count,
                                         Numbers& angles_rad) {
  if (!reader_.Read(tensor, {count}, angles_rad)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle_rad = angles_rad[i];
    if (!Require(angle_rad >= 0.0 && angle_rad < 2.0 * std::numbers::pi,
                 tensor,
                 i,
                 angle_rad,
                 "an angle of 0 or more and less than 2 pi")) {
      return false;
    }
  }
  return true;
}

// Rows of length 1.
bool GraspLibraryLoader::ReadUnits(const char* tensor,
                                   std::size_t count,
                                   std::size_t width,
                                   Numbers& rows) {
  if (!reader_.Read(tensor, {count, width}, rows)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    double squared = 0.0;
    for (std::size_t j = 0; j < width; ++j) squared += rows[i * width + j] * rows[i * width + j];
    if (!Require(std::fabs(squared - 1.0) <= kUnitTolerance,
                 tensor,
                 i * width,
                 rows[i * width],
                 "a row of length 1")) {
      return false;
    }
  }
  return true;
}

bool GraspLibraryLoader::ReadPlaces(const char* tensor, std::size_t count, Numbers& rows) {
  if (!reader_.Read(tensor, {count, 3}, rows)) return false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!Require(std::fabs(rows[i]) <= kFarthestM, tensor, i, rows[i], "at most 100 m")) {
      return false;
    }
  }
  return true;
}

bool GraspLibraryLoader::ReadRule() {
  std::int32_t moments = 0;
  std::int32_t candidates = 0;
  features::RotationRule& rule = library_.rule;
  if (!reader_.ReadOne("compared_moments", moments) ||
      !Require(moments >= 0 && moments <= 2, "compared_moments", 0, moments, "0, 1 or 2") ||
      !reader_.ReadOne("num_candidates", candidates) ||
      !Require(candidates >= 0 && candidates <= static_cast<int>(features::kMaxCandidates),
               "num_candidates",
               0,
               candidates,
               "a number from 0 to 64") ||
      !reader_.ReadOne("angle_weight", rule.angle_weight)) {
    return false;
  }
  rule.moments = static_cast<features::ComparedMoments>(moments);
  rule.num_candidates = static_cast<std::size_t>(candidates);
  return Require(rule.angle_weight >= 0.0 && rule.angle_weight <= 1e6,
                 "angle_weight",
                 0,
                 rule.angle_weight,
                 "a number from 0 to 1e6");
}

bool GraspLibraryLoader::ReadViews() {
  constexpr std::int32_t kMaxClasses = 4096;
  std::int32_t num_classes = 0;
  if (!reader_.ReadOne("num_classes", num_classes) ||
      !Require(num_classes >= 1 && num_classes <= kMaxClasses,
               "num_classes",
               0,
               num_classes,
               "a number from 1 to 4096")) {
    return false;
  }
  const auto count = static_cast<std::size_t>(num_classes);
  if (!reader_.ReadNames("class_names", count, "classes", model_.class_names) ||
      !ReadBegins("view_begins", count, library_.view_begins)) {
    return false;
  }
  const auto num_views = static_cast<std::size_t>(library_.view_begins.back());
  Numbers& moments = library_.view_moments;
  if (!ReadRoundAngles("view_angles", num_views, library_.view_angles_rad) ||
      !ReadUnits("view_normals", num_views, 3, library_.view_normals) ||
      !reader_.Read("view_moments", {num_views, kNumMoments}, moments) ||
      !reader_.Read("moment_scales", {count, kNumMoments}, library_.moment_scales)) {
    return false;
  }
  for (std::size_t i = 0; i < moments.size(); i += features::kMomentsPerHalf) {
    if (!Require(moments[i] > 0.0, "view_moments", i, moments[i], "an area above 0")) return false;
  }
  for (std::size_t i = 0; i < library_.moment_scales.size(); ++i) {
    const double scale = library_.moment_scales[i];
    if (!Require(scale > 0.0, "moment_scales", i, scale, "a number above 0")) return false;
  }
  return true;
}

bool GraspLibraryLoader::ReadAngles() {
  if (!ReadBegins("angle_begins", model_.class_names.size(), library_.angle_begins)) return false;
  const auto num_angles = static_cast<std::size_t>(library_.angle_begins.back());
  return ReadRoundAngles("shown_angles", num_angles, library_.shown_angles_rad) &&
         ReadPlaces("shown_means", num_angles, library_.shown_means_m) &&
         ReadBegins("pose_begins", num_angles, library_.pose_begins);
}

bool GraspLibraryLoader::ReadPoses() {
  const auto num_poses = static_cast<std::size_t>(library_.pose_begins.back());
  if (!ReadPlaces("positions", num_poses, library_.positions_m) ||
      !ReadUnits("rotations", num_poses, 4, library_.rotations) ||
      !reader_.Read("demonstration_numbers", {num_poses}, library_.numbers)) {
    return false;
  }
  for (std::size_t i = 0; i < num_poses; ++i) {
    const std::int32_t number = library_.numbers[i];
    if (!Require(number >= 0, "demonstration_numbers", i, number, "0 or more")) return false;
  }
  for (std::size_t i = 0; i + 1 < library_.pose_begins.size(); ++i) {
    const auto first = static_cast<std::size_t>(library_.pose_begins[i]);
    const auto last = static_cast<std::size_t>(library_.pose_begins[i + 1]);
    const auto rows = std::span<const double>(library_.positions_m);
    if (features::IsTree(rows.subspan(3 * first, 3 * (last - first)))) continue;
    return reader_.Fail(MakeError(HC_ERROR_CONTENT,
                                  reader_.OffsetOf("positions"),
                                  "rows %zu to %zu of the tensor 'positions' are not ordered as a "
                                  "k-d tree; train the model again",
                                  first,
                                  last - 1));
  }
  return true;
}

bool GraspLibraryLoader::ReadRejection() {
  if (reader_.Find("rejection_distance") == nullptr) return true;
  double& distance_m = library_.rejection_distance_m.emplace();
  return reader_.ReadOne("rejection_distance", distance_m) &&
         Require(distance_m > 0.0, "rejection_distance", 0, distance_m, "a distance above 0");
}

bool GraspLibraryLoader::ReadSelfTest() {
  constexpr std::uint64_t kMaxSide = 256;
  const TensorView* mask = reader_.Find("selftest.mask");
  const std::uint64_t height = mask == nullptr ? kAnyLength : mask->shape[0];
  const std::uint64_t width = mask == nullptr ? kAnyLength : mask->shape[1];
  if (!reader_.Read("selftest.mask", {kAnyLength, kAnyLength}, test_mask_) ||
      !Require(height <= kMaxSide && width <= kMaxSide,
               "selftest.mask",
               0,
               static_cast<double>(test_mask_.size()),
               "at most 256 rows and columns") ||
      !reader_.Read("selftest.cloud", {height, width, 3}, test_points_) ||
      !reader_.Read("selftest.point", {3}, test_point_) ||
      !reader_.Read("selftest.output", {model_.class_names.size(), kOutputs}, test_output_) ||
      !reader_.ReadOne("selftest.tolerance", test_tolerance_)) {
    return false;
  }
  test_width_ = static_cast<std::size_t>(width);
  return Require(test_tolerance_ > 0.0 && test_tolerance_ <= 1e-3,
                 "selftest.tolerance",
                 0,
                 test_tolerance_,
                 "above 0 and at most 0.001");
}

// § 11.2: three neighbours of the point, for every class.
std::optional<ModelError> GraspLibraryLoader::RunSelfTest() {
  const features::ObjectCloud cloud{.points = test_points_.data(),
                                    .width = static_cast<int>(test_width_),
                                    .height = static_cast<int>(test_mask_.size() / test_width_),
                                    .row_stride = static_cast<std::ptrdiff_t>(3 * test_width_),
                                    .mask = test_mask_.data(),
                                    .mask_stride = static_cast<std::ptrdiff_t>(test_width_)};
  std::vector<float> scratch(features::ObjectPlaneScratch(cloud.width, cloud.height));
  const features::GraspRequest request{.point_m = {test_point_[0], test_point_[1], test_point_[2]},
                                       .num_neighbours = 3};
  for (std::size_t c = 0; c < model_.class_names.size(); ++c) {
    const GraspLibraryModel::Answer answer = model_.Find(c, cloud, request, scratch);
    const auto& [p, q] = std::pair(answer.grasp.position_m, answer.grasp.rotation);
    const double found[kOutputs] = {
        answer.grasp.object_angle_rad, p[0], p[1], p[2], q[0], q[1], q[2], q[3]};
    for (std::size_t i = 0; i < kOutputs; ++i) {
      const double expected = test_output_[c * kOutputs + i];
      // A NaN fails as well.
      if (answer.fault == features::CloudFault::kNone &&
          std::fabs(found[i] - expected) <= test_tolerance_) {
        continue;
      }
      return MakeError(HC_ERROR_SELF_TEST,
                       kNoOffset,
                       "the self-test gives %.17g for number %zu of class %zu where the model "
                       "stores %.17g; train it again with this version of Handcraft",
                       found[i],
                       i,
                       c,
                       expected);
    }
  }
  return std::nullopt;
}

}  // namespace

GraspLibraryModel::Answer GraspLibraryModel::Find(std::size_t number,
                                                  const features::ObjectCloud& cloud,
                                                  const features::GraspRequest& request,
                                                  std::span<float> scratch) const noexcept {
  features::ViewDescription view;
  Answer answer{.fault = features::DescribeView(cloud, scratch, view), .grasp = {}};
  if (answer.fault != features::CloudFault::kNone) return answer;
  answer.grasp = features::FindGrasp(library.Class(number), library.rule, view, request);
  answer.is_rejected =
      library.rejection_distance_m && !(answer.grasp.distance_m <= *library.rejection_distance_m);
  return answer;
}

Result<GraspLibraryModel> LoadGraspLibrary(const ParsedModel& parsed) {
  return GraspLibraryLoader(parsed).Load();
}

}  // namespace handcraft::runtime
