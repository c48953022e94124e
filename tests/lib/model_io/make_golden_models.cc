// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// make_golden_models FOLDER: writes the models of tests/data/models. Only for a new format or kind:
// released files are never written again (tests/data/models/README.md).

#include <cstdio>
#include <exception>
#include <filesystem>

#include "lib/core/file.h"
#include "tests/lib/runtime/some_models.h"

namespace {

// Three classes told apart by every third number of a histogram, or none of them.
handcraft::model_io::ModelFile SomeHistogramModel(handcraft::features::CloudDescriptorType type) {
  namespace features = handcraft::features;
  namespace testing = handcraft::testing;
  handcraft::model_io::ObjectClassModel model = testing::SomeObjectClasses();
  model.descriptor = {.type = type, .grid_size = 8, .frame = features::CloudFrame::kCamera};
  const std::size_t p = model.descriptor.NumFeatures();
  model.svm.feature_mean.assign(p, 0.0);
  model.svm.feature_scale.assign(p, 1.0);
  model.svm.support_vectors.assign(3 * p, 0.0);
  for (std::size_t j = 0; j < p; ++j) model.svm.support_vectors[j % 3 * p + j] = 1.0;
  model.svm.rejection_threshold = 0.25;
  return testing::SomeObjectClassModel(model);
}

}  // namespace

int main(int argc, char** argv) {
  using handcraft::WriteFileAtomically;
  namespace testing = handcraft::testing;
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_golden_models FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  try {
    for (const char* spec : {"edges54", "saxena459"}) {
      WriteFileAtomically(folder / ("v1_grasp_point_" + std::string(spec) + ".safetensors"),
                          handcraft::model_io::Serialise(testing::SomeGraspPointModel(spec)));
    }
    WriteFileAtomically(folder / "v1_grasp_library.safetensors",
                        handcraft::model_io::Serialise(testing::SomeGraspLibraryModel()));
    WriteFileAtomically(folder / "v1_logistic.safetensors",
                        handcraft::model_io::Serialise(testing::SomeLogisticModel()));
    WriteFileAtomically(folder / "v1_svm.safetensors",
                        handcraft::model_io::Serialise(testing::SomeSvmModel()));
    WriteFileAtomically(folder / "v1_object_class.safetensors",
                        handcraft::model_io::Serialise(testing::SomeObjectClassModel()));
    for (const auto type : {handcraft::features::CloudDescriptorType::kViewpointHistogram,
                            handcraft::features::CloudDescriptorType::kShapeFunctions}) {
      const std::string name(handcraft::features::NameOf(type));
      WriteFileAtomically(folder / ("v1_object_class_" + name + ".safetensors"),
                          handcraft::model_io::Serialise(SomeHistogramModel(type)));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
