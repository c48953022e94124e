// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/object_class_model.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "lib/runtime/aligned_buffer.h"
#include "lib/runtime/content_reader.h"
#include "lib/runtime/svm_loader.h"

namespace handcraft::runtime {
namespace {

using features::CloudDescriptor;

constexpr std::size_t kAlignment = 64;

constexpr std::size_t Aligned(std::size_t num_bytes) noexcept {
  return (num_bytes + kAlignment - 1) / kAlignment * kAlignment;
}

// § 10.1: a made-small cloud of one training view.
struct SelfTest {
  std::vector<float> points;
  std::vector<std::uint8_t> mask;
  std::vector<double> decisions;
  double tolerance = 0.0;
  std::size_t width = 0;
  std::size_t height = 0;

  [[nodiscard]] features::ObjectCloud View() const noexcept {
    return {.points = points.data(),
            .width = static_cast<int>(width),
            .height = static_cast<int>(height),
            .row_stride = static_cast<std::ptrdiff_t>(3 * width),
            .point_stride = 3,
            .mask = mask.data(),
            .mask_stride = static_cast<std::ptrdiff_t>(width)};
  }
};

bool ReadDescriptor(ContentReader& reader, CloudDescriptor& descriptor) {
  std::int32_t type = 0;
  std::int32_t scaling = 0;
  std::int32_t frame = 0;
  std::int32_t box = 0;
  const bool complete =
      reader.ReadOne("cloud_descriptor", type) &&
      RequireWithin(reader, "cloud_descriptor", type, 0, features::kNumCloudDescriptors - 1) &&
      reader.ReadOne("cloud_grid_size", descriptor.grid_size) &&
      RequireWithin(reader, "cloud_grid_size", descriptor.grid_size, 1, features::kMaxGridSize) &&
      reader.ReadOne("cloud_scaling", scaling) &&
      RequireWithin(reader, "cloud_scaling", scaling, 0, 1) &&
      reader.ReadOne("cloud_frame", frame) && RequireWithin(reader, "cloud_frame", frame, 0, 1) &&
      reader.ReadOne("cloud_box", box) && RequireWithin(reader, "cloud_box", box, 0, 1);
  descriptor.type = static_cast<features::CloudDescriptorType>(type);
  descriptor.scaling = static_cast<features::CloudScaling>(scaling);
  descriptor.frame = static_cast<features::CloudFrame>(frame);
  descriptor.box = static_cast<features::GridBox>(box);
  if (!complete || descriptor.FrameFits()) return complete;
  return reader.Fail(MakeError(HC_ERROR_CONTENT,
                               reader.OffsetOf("cloud_frame"),
                               "'cloud_frame' is base; a viewpoint histogram needs camera, whose "
                               "origin is the viewpoint"));
}

bool ReadMachine(ContentReader& reader, ObjectClassModel& model) {
  double outlier_step = 0.0;  // for who takes the object out of a cloud
  if (!SvmLoader(reader, model.svm).Read() || !reader.ReadOne("cloud_outlier_step", outlier_step)) {
    return false;
  }
  if (model.svm.NumFeatures() == model.descriptor.NumFeatures()) return true;
  return reader.Fail(MakeError(HC_ERROR_CONTENT,
                               reader.OffsetOf("feature_mean"),
                               "the machine reads %zu features and the descriptor has %zu; train "
                               "the model again",
                               model.svm.NumFeatures(),
                               model.descriptor.NumFeatures()));
}

bool ReadSelfTest(ContentReader& reader, const SvmModel& svm, SelfTest& test) {
  constexpr std::uint64_t kMaxSide = 256;
  const TensorView* mask = reader.Find("selftest.mask");
  if (mask != nullptr && mask->rank == 2 && mask->shape[0] <= kMaxSide &&
      mask->shape[1] <= kMaxSide) {
    test.height = static_cast<std::size_t>(mask->shape[0]);
    test.width = static_cast<std::size_t>(mask->shape[1]);
  }
  return reader.Read("selftest.mask", {test.height, test.width}, test.mask) &&
         reader.Read("selftest.input", {test.height, test.width, 3}, test.points) &&
         reader.Read("selftest.output", {svm.NumMachines()}, test.decisions) &&
         ReadSelfTestTolerance(reader, test.tolerance);
}

std::optional<ModelError> RunSelfTest(const ObjectClassModel& model, const SelfTest& test) {
  const AlignedBuffer workspace(model.WorkspaceBytes());
  if (!model.Predict(test.View(), workspace.Bytes())) {
    return MakeError(HC_ERROR_SELF_TEST, kNoOffset, "the self-test's cloud has too few points");
  }
  return CheckSelfTestRow(model.svm, test.decisions, test.tolerance, 0, workspace.Bytes());
}

}  // namespace

std::size_t ObjectClassModel::WorkspaceBytes() const noexcept {
  const std::size_t num_features = descriptor.NumFeatures();
  return Aligned(svm.WorkspaceBytes()) + Aligned(descriptor.WorkspaceBytes()) +
         Aligned(num_features * sizeof(float)) + Aligned(num_features * sizeof(double));
}

std::optional<SvmModel::Prediction> ObjectClassModel::Predict(
    const features::ObjectCloud& cloud, std::span<std::byte> workspace) const noexcept {
  const std::size_t num_features = descriptor.NumFeatures();
  std::byte* const sums = workspace.data() + Aligned(svm.WorkspaceBytes());
  std::byte* const floats = sums + Aligned(descriptor.WorkspaceBytes());
  const std::span features(reinterpret_cast<float*>(floats), num_features);
  const std::span row(reinterpret_cast<double*>(floats + Aligned(features.size_bytes())),
                      num_features);
  if (!descriptor.Compute(cloud, {sums, descriptor.WorkspaceBytes()}, features))
    return std::nullopt;
  for (std::size_t j = 0; j < num_features; ++j) row[j] = static_cast<double>(features[j]);
  return svm.Predict(row, workspace);
}

Result<ObjectClassModel> LoadObjectClassModel(const ParsedModel& parsed) {
  ContentReader reader(parsed);
  ObjectClassModel model;
  SelfTest test;
  const bool complete = ReadDescriptor(reader, model.descriptor) && ReadMachine(reader, model) &&
                        ReadSelfTest(reader, model.svm, test) && reader.RefuseUnknownTensors();
  if (!complete) return reader.error();
  if (const std::optional<ModelError> error = RunSelfTest(model, test)) return *error;
  return model;
}

}  // namespace handcraft::runtime
