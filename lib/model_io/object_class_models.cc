// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/object_class_models.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/model_io/column_names.h"
#include "lib/model_io/svm_models.h"
#include "lib/model_io/svm_tensors.h"
#include "lib/runtime/format.h"

namespace handcraft::model_io {
namespace {

namespace format = runtime::format;
using features::CloudDescriptor;
using Metadata = std::map<std::string, std::string>;

constexpr int kMaxTestSide = 48;

// An object's cloud in memory of its own; what was not measured is 0 and not in the mask.
struct SmallCloud {
  std::vector<float> points;
  std::vector<std::uint8_t> mask;
  int width = 0;
  int height = 0;

  [[nodiscard]] features::ObjectCloud View() const noexcept {
    return {.points = points.data(),
            .width = width,
            .height = height,
            .row_stride = std::ptrdiff_t{3} * width,
            .point_stride = 3,
            .mask = mask.data(),
            .mask_stride = width};
  }
};

// Every so many rows and columns of the object's box that no more than kMaxTestSide are left.
SmallCloud Thin(const features::ObjectCloud& cloud) {
  const features::PixelExtent box = features::FindExtent(cloud);
  const int step =
      std::max(1, (std::max(box.Width(), box.Height()) + kMaxTestSide - 1) / kMaxTestSide);
  SmallCloud small;
  for (int v = box.v_begin; v < box.v_end; v += step, ++small.height) {
    small.width = 0;
    for (int u = box.u_begin; u < box.u_end; u += step, ++small.width) {
      const bool is_there = cloud.Has(u, v);
      small.mask.push_back(is_there ? 255 : 0);
      for (int axis = 0; axis < 3; ++axis) {
        small.points.push_back(is_there ? cloud.Point(u, v)[axis] : 0.0F);
      }
    }
  }
  return small;
}

void AddSelfTest(const ObjectClassModel& model,
                 const features::ObjectCloud& cloud,
                 ModelFile& file) {
  SmallCloud small = Thin(cloud);
  std::vector<std::byte> workspace(model.descriptor.WorkspaceBytes());
  std::vector<float> features(model.descriptor.NumFeatures());
  if (!model.descriptor.Compute(small.View(), workspace, features)) {
    throw Error({.reason = "the object of the self-test has too few measured points",
                 .remedy = "train on views whose objects are seen larger"});
  }
  const std::vector<double> row(features.begin(), features.end());
  file.tensors["selftest.input"] = {std::move(small.points), {small.height, small.width, 3}};
  file.tensors["selftest.mask"] = {std::move(small.mask), {small.height, small.width}};
  file.tensors["selftest.output"] = VectorTensor(DecisionValues(model.svm, row));
  file.tensors["selftest.tolerance"] = ScalarTensor(1e-9);
}

void DescribeInterface(const ObjectClassModel& model, Metadata& metadata) {
  metadata["hc.inputs"] = "cloud mask";
  metadata["hc.input.cloud.dtype"] = "float32";
  metadata["hc.input.cloud.shape"] = "height width 3";
  metadata["hc.input.cloud.layout"] = "row-major, x y z of each pixel; not finite: not measured";
  metadata["hc.input.cloud.units"] = "m";
  metadata["hc.input.mask.dtype"] = "uint8";
  metadata["hc.input.mask.shape"] = "height width";
  metadata["hc.input.mask.encoding"] = "0 where the pixel is not the object's";
  metadata["hc.outputs"] = "class margin";
  metadata["hc.output.class.dtype"] = "int32";
  metadata["hc.output.class.shape"] = "1";
  metadata["hc.output.class.units"] = "number of the class, from 0, in the tensor class_names";
  metadata["hc.output.margin.dtype"] = "float64";
  metadata["hc.output.margin.shape"] = "1";
  metadata["hc.output.margin.units"] = "smallest decision value of the class against another";
  metadata["hc.frames"] = model.descriptor.frame == features::CloudFrame::kBase
                              ? "base: x forward, y left, z up (REP-103)"
                              : "camera: optical, z forward, x right, y down (REP-103)";
  metadata["hc.units"] = "m";
}

}  // namespace

ModelFile MakeObjectClassModel(const ObjectClassModel& model,
                               const features::ObjectCloud& cloud,
                               const Provenance& provenance) {
  HC_CHECK(model.descriptor.NumFeatures() == model.svm.NumFeatures(),
           model.descriptor.NumFeatures(),
           model.svm.NumFeatures());
  ModelFile file{.tensors = {}, .metadata = DescribeOrigin(provenance)};
  file.metadata[std::string(format::kKindKey)] = format::kObjectClassKind;
  file.metadata[std::string(format::kKindVersionKey)] = format::kKindVersion;
  DescribeInterface(model, file.metadata);
  const CloudDescriptor& descriptor = model.descriptor;
  file.tensors["cloud_descriptor"] = ScalarTensor(static_cast<std::int32_t>(descriptor.type));
  file.tensors["cloud_grid_size"] = ScalarTensor<std::int32_t>(descriptor.grid_size);
  file.tensors["cloud_scaling"] = ScalarTensor(static_cast<std::int32_t>(descriptor.scaling));
  file.tensors["cloud_frame"] = ScalarTensor(static_cast<std::int32_t>(descriptor.frame));
  file.tensors["cloud_box"] = ScalarTensor(static_cast<std::int32_t>(descriptor.box));
  file.tensors["cloud_outlier_step"] = ScalarTensor(model.outlier_step);
  AddSvmTensors(model.svm, model.classes, file);
  file.metadata["hc.tie_rule"] = TieRuleOf(model.svm.scheme);
  AddSelfTest(model, cloud, file);
  return file;
}

ObjectClassModel ReadObjectClassModel(const ModelFile& file) {
  RequireKind(file, format::kObjectClassKind, "handcraft train object-class");
  const auto integer = [&file](const std::string& name) {
    return ValuesOf<std::int32_t>(file, name)[0];
  };
  return {.descriptor = {.type = static_cast<features::CloudDescriptorType>(
                             integer("cloud_descriptor")),
                         .grid_size = integer("cloud_grid_size"),
                         .scaling = static_cast<features::CloudScaling>(integer("cloud_scaling")),
                         .frame = static_cast<features::CloudFrame>(integer("cloud_frame")),
                         .box = static_cast<features::GridBox>(integer("cloud_box"))},
          .outlier_step = ValuesOf<double>(file, "cloud_outlier_step")[0],
          .svm = ReadSvmTensors(file),
          .classes = NamesIn(file, "class_names")};
}

}  // namespace handcraft::model_io
