// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/grasp_library_models.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "lib/core/check.h"
#include "lib/model_io/column_names.h"
#include "lib/runtime/format.h"

namespace handcraft::model_io {
namespace {

namespace format = runtime::format;
using Metadata = std::map<std::string, std::string>;

template <class T>
Tensor Rows(std::vector<T> values, std::size_t width) {
  const auto count = static_cast<std::int64_t>(values.size() / width);
  if (width == 1) return {std::move(values), {count}};
  return {std::move(values), {count, static_cast<std::int64_t>(width)}};
}

template <class T>
Tensor Scalar(T value) {
  return {std::vector<T>{value}, {1}};
}

void CheckSizes(const features::GraspLibrary& library, const GraspLibraryNames& names) {
  const std::size_t num_classes = library.NumClasses();
  HC_CHECK(num_classes >= 1 && names.classes.size() == num_classes &&
               library.angle_begins.size() == num_classes + 1 &&
               library.moment_scales.size() == num_classes * features::kNumMoments,
           num_classes,
           names.classes.size());
  const std::size_t num_views = library.view_angles_rad.size();
  HC_CHECK(static_cast<std::size_t>(library.view_begins.back()) == num_views &&
               library.view_normals.size() == 3 * num_views &&
               library.view_moments.size() == features::kNumMoments * num_views,
           num_views);
  const std::size_t num_angles = library.shown_angles_rad.size();
  HC_CHECK(static_cast<std::size_t>(library.angle_begins.back()) == num_angles &&
               library.shown_means_m.size() == 3 * num_angles &&
               library.pose_begins.size() == num_angles + 1,
           num_angles);
  const std::size_t num_poses = library.numbers.size();
  HC_CHECK(static_cast<std::size_t>(library.pose_begins.back()) == num_poses &&
               library.positions_m.size() == 3 * num_poses &&
               library.rotations.size() == 4 * num_poses,
           num_poses);
}

void DescribeInterface(const GraspLibraryNames& names, Metadata& metadata) {
  metadata["hc.inputs"] = "class cloud mask point";
  metadata["hc.input.class.dtype"] = "int32";
  metadata["hc.input.class.units"] = "number of the class, from 0, in the tensor class_names";
  metadata["hc.input.cloud.dtype"] = "float32";
  metadata["hc.input.cloud.shape"] = "height width 3";
  metadata["hc.input.cloud.units"] = "m; not a number where nothing was measured";
  metadata["hc.input.mask.dtype"] = "uint8";
  metadata["hc.input.mask.shape"] = "height width";
  metadata["hc.input.mask.encoding"] = "not 0: the object";
  metadata["hc.input.point.dtype"] = "float64";
  metadata["hc.input.point.shape"] = "3";
  metadata["hc.input.point.units"] = "m";
  metadata["hc.outputs"] = "pose angle distance";
  metadata["hc.output.pose.dtype"] = "float64";
  metadata["hc.output.pose.shape"] = "7";
  metadata["hc.output.pose.layout"] = "x y z qx qy qz qw of the end-effector";
  metadata["hc.output.angle.dtype"] = "float64";
  metadata["hc.output.angle.units"] = "rad";
  metadata["hc.output.distance.dtype"] = "float64";
  metadata["hc.output.distance.units"] = "m";
  metadata["hc.frames"] = std::string(kBaseFrame) + " (x forward, y left, z up) " +
                          kGraspCentreFrame + " (z approach axis, x closing axis)";
  metadata["hc.units"] = "m rad";
  metadata["hc.quaternion_order"] = "xyzw";
  metadata["hc.tie_rule"] = "the first view, the first shown angle, the lower demonstration";
  if (!names.robot.empty()) metadata["hc.robot"] = names.robot;
  std::string joints;
  for (const std::string& joint : names.joints)
    joints.append(joints.empty() ? "" : " ").append(joint);
  if (!joints.empty()) metadata["hc.joint_names"] = joints;
}

// A cloud bent in both directions, wider below than above: it has a plane and two unlike halves.
struct TestCloud {
  static constexpr int kWidth = 24;
  static constexpr int kHeight = 16;

  std::vector<float> points;
  std::vector<std::uint8_t> mask;

  TestCloud() {
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 0; u < kWidth; ++u) {
        points.push_back(0.01F * static_cast<float>(u) - 0.1F);
        points.push_back(0.002F * static_cast<float>(u + v));
        points.push_back(0.01F * static_cast<float>(kHeight - v) +
                         0.0001F * static_cast<float>(u * u));
        mask.push_back(u >= 2 && u <= 8 + v ? 1 : 0);
      }
    }
  }
  [[nodiscard]] features::ObjectCloud View() const {
    return {.points = points.data(),
            .width = kWidth,
            .height = kHeight,
            .row_stride = 3 * kWidth,
            .mask = mask.data(),
            .mask_stride = kWidth};
  }
};

void AddSelfTest(const features::GraspLibrary& library, ModelFile& file) {
  const TestCloud test;
  std::vector<float> scratch(features::ObjectPlaneScratch(TestCloud::kWidth, TestCloud::kHeight));
  features::ViewDescription view;
  const features::CloudFault fault = features::DescribeView(test.View(), scratch, view);
  HC_CHECK(fault == features::CloudFault::kNone, features::NameOf(fault));
  const features::GraspRequest request{.point_m = {0.02, 0.03, 0.12}, .num_neighbours = 3};
  std::vector<double> output;
  for (std::size_t c = 0; c < library.NumClasses(); ++c) {
    const features::FoundGrasp found =
        features::FindGrasp(library.Class(c), library.rule, view, request);
    output.push_back(found.object_angle_rad);
    output.insert(output.end(), found.position_m.begin(), found.position_m.end());
    output.insert(output.end(), found.rotation.begin(), found.rotation.end());
  }
  file.tensors["selftest.cloud"] = {test.points, {TestCloud::kHeight, TestCloud::kWidth, 3}};
  file.tensors["selftest.mask"] = {test.mask, {TestCloud::kHeight, TestCloud::kWidth}};
  file.tensors["selftest.point"] = {
      std::vector<double>(request.point_m.begin(), request.point_m.end()), {3}};
  file.tensors["selftest.output"] = {std::move(output),
                                     {static_cast<std::int64_t>(library.NumClasses()), 8}};
  file.tensors["selftest.tolerance"] = Scalar(1e-9);
}

}  // namespace

ModelFile MakeGraspLibraryModel(const features::GraspLibrary& library,
                                const GraspLibraryNames& names,
                                const Provenance& provenance) {
  CheckSizes(library, names);
  ModelFile file{.tensors = {}, .metadata = DescribeOrigin(provenance)};
  file.metadata[std::string(format::kKindKey)] = format::kGraspLibraryKind;
  file.metadata[std::string(format::kKindVersionKey)] = format::kKindVersion;
  DescribeInterface(names, file.metadata);
  auto& tensors = file.tensors;
  tensors["compared_moments"] = Scalar(static_cast<std::int32_t>(library.rule.moments));
  tensors["num_candidates"] = Scalar(static_cast<std::int32_t>(library.rule.num_candidates));
  tensors["angle_weight"] = Scalar(library.rule.angle_weight);
  tensors["num_classes"] = Scalar(static_cast<std::int32_t>(library.NumClasses()));
  tensors["class_names"] = Rows(JoinNames(names.classes, "class"), 1);
  tensors["view_begins"] = Rows(library.view_begins, 1);
  tensors["view_angles"] = Rows(library.view_angles_rad, 1);
  tensors["view_normals"] = Rows(library.view_normals, 3);
  tensors["view_moments"] = Rows(library.view_moments, features::kNumMoments);
  tensors["moment_scales"] = Rows(library.moment_scales, features::kNumMoments);
  tensors["angle_begins"] = Rows(library.angle_begins, 1);
  tensors["shown_angles"] = Rows(library.shown_angles_rad, 1);
  tensors["shown_means"] = Rows(library.shown_means_m, 3);
  tensors["pose_begins"] = Rows(library.pose_begins, 1);
  tensors["positions"] = Rows(library.positions_m, 3);
  tensors["rotations"] = Rows(library.rotations, 4);
  tensors["demonstration_numbers"] = Rows(library.numbers, 1);
  if (library.rejection_distance_m) {
    tensors["rejection_distance"] = Scalar(*library.rejection_distance_m);
  }
  AddSelfTest(library, file);
  return file;
}

}  // namespace handcraft::model_io
