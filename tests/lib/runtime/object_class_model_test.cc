// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/object_class_model.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/runtime/model_parser.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/lib/runtime/stored_model.h"

namespace handcraft::runtime {
namespace {

using model_io::ModelFile;
using testing::In;

Result<ObjectClassModel> Load(const ModelFile& model) {
  return testing::LoadStored<&LoadObjectClassModel>(model);
}

void ExpectRefused(const std::function<void(ModelFile&)>& change,
                   const std::string& message,
                   hc_status status = HC_ERROR_CONTENT) {
  testing::ExpectRefusal<&LoadObjectClassModel>(
      testing::SomeObjectClassModel(), change, message, status);
}

TEST(ObjectClassModel, ClassifiesByHand) {
  const auto model = Load(testing::SomeObjectClassModel());
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->descriptor.type, features::CloudDescriptorType::kDepthGrid);
  // Depths 1, 3, 2, 2: F = (−1, 1, 0, 0).
  const std::vector<float> points = {1, 0, 0, 3, 1, 0, 2, 0, 1, 2, 1, 1};
  const features::ObjectCloud cloud{
      .points = points.data(), .width = 2, .height = 2, .row_stride = 6};
  const AlignedBuffer workspace(model->WorkspaceBytes());
  const auto prediction = model->Predict(cloud, workspace.Bytes());
  ASSERT_TRUE(prediction);
  EXPECT_EQ(prediction->vote.winner, 1U);
  EXPECT_EQ(prediction->vote.margin, 1.0);
  EXPECT_FALSE(prediction->is_rejected);
  EXPECT_FALSE(model->Predict({}, workspace.Bytes()));
}

TEST(ObjectClassModel, RefusesEachMissingTensor) {
  const ModelFile whole = testing::SomeObjectClassModel();
  EXPECT_EQ(whole.tensors.size(), 25U);
  for (const auto& entry : whole.tensors) {
    const std::string& name = entry.first;
    ExpectRefused([&](ModelFile& model) { model.tensors.erase(name); },
                  "the tensor '" + name + "' ");
  }
}

TEST(ObjectClassModel, RefusesDescriptorsItDoesNotKnow) {
  const auto set = [](const std::string& name, std::int32_t value) {
    return [=](ModelFile& model) { In<std::int32_t>(model, name)[0] = value; };
  };
  ExpectRefused(set("cloud_descriptor", -1), "'cloud_descriptor' is -1; a number from 0 to ");
  ExpectRefused(set("cloud_descriptor", 99), "'cloud_descriptor' is 99; a number from 0 to ");
  ExpectRefused(set("cloud_grid_size", 0), "'cloud_grid_size' is 0; a number from 1 to 128");
  ExpectRefused(set("cloud_grid_size", 129), "'cloud_grid_size' is 129; a number from 1 to 128");
  ExpectRefused(set("cloud_scaling", 2), "'cloud_scaling' is 2; a number from 0 to 1");
  ExpectRefused(set("cloud_box", 2), "'cloud_box' is 2; a number from 0 to 1");
  ExpectRefused(set("cloud_frame", 2), "'cloud_frame' is 2; a number from 0 to 1");
  ExpectRefused(set("cloud_grid_size", 3),
                "the machine reads 4 features and the descriptor has 9; train the model again");
  ExpectRefused(set("cloud_descriptor", 3), "a viewpoint histogram needs camera");
}

// Features of an object, of length 1.
std::vector<double> UnitFeatures(const features::CloudDescriptor& descriptor,
                                 const testing::SomeObject& object) {
  std::vector<std::byte> workspace(descriptor.WorkspaceBytes());
  std::vector<float> features(descriptor.NumFeatures());
  EXPECT_TRUE(descriptor.Compute(object.View(), workspace, features));
  double squares = 0.0;
  for (const float value : features) squares += double{value} * double{value};
  std::vector<double> unit;
  unit.reserve(features.size());
  for (const float value : features) {
    unit.push_back(static_cast<double>(static_cast<float>(double{value} / std::sqrt(squares))));
  }
  return unit;
}

// Linear machines whose weights are the features of the objects: each tells its own.
TEST(ObjectClassModel, ClassifiesByHistograms) {
  using features::CloudDescriptorType;
  for (const CloudDescriptorType type :
       {CloudDescriptorType::kViewpointHistogram, CloudDescriptorType::kShapeFunctions}) {
    const testing::SomeObject first(24, 20);
    const testing::SomeObject second(40, 9, 5);
    model_io::ObjectClassModel classes = testing::SomeObjectClasses();
    classes.descriptor = {.type = type, .grid_size = 10, .frame = features::CloudFrame::kCamera};
    const std::size_t p = classes.descriptor.NumFeatures();
    classes.svm.feature_mean.assign(p, 0.0);
    classes.svm.feature_scale.assign(p, 1.0);
    classes.svm.support_vectors = UnitFeatures(classes.descriptor, first);
    for (const double value : UnitFeatures(classes.descriptor, second)) {
      classes.svm.support_vectors.push_back(value);
    }
    classes.svm.support_vectors.resize(3 * p);
    const auto model = Load(testing::SomeObjectClassModel(classes));
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_EQ(model->descriptor.type, type);
    const AlignedBuffer workspace(model->WorkspaceBytes());
    EXPECT_EQ(model->Predict(first.View(), workspace.Bytes())->vote.winner, 0U);
    EXPECT_EQ(model->Predict(second.View(), workspace.Bytes())->vote.winner, 1U);
  }
}

TEST(ObjectClassModel, RefusesAMachineThatDoesNotDecideAsStored) {
  ExpectRefused([](ModelFile& model) { In<double>(model, "selftest.output")[1] += 1e-3; },
                "the self-test gives",
                HC_ERROR_SELF_TEST);
  ExpectRefused(
      [](ModelFile& model) {
        for (std::uint8_t& value : In<std::uint8_t>(model, "selftest.mask")) value = 0;
      },
      "too few points",
      HC_ERROR_SELF_TEST);
  ExpectRefused([](ModelFile& model) { In<double>(model, "selftest.tolerance")[0] = 0.1; },
                "above 0 and at most 0.001");
}

TEST(ObjectClassModel, RefusesASelfTestOfAnotherShape) {
  ExpectRefused(
      [](ModelFile& model) {
        const auto size =
            static_cast<std::int64_t>(In<std::uint8_t>(model, "selftest.mask").size());
        model.tensors.at("selftest.mask").shape = {1, size};
      },
      "the tensor 'selftest.input'");
  ExpectRefused(
      [](ModelFile& model) {
        model.tensors["column_names"] = {std::vector<double>{1.0}, {1}};
      },
      "'column_names'");
}

}  // namespace
}  // namespace handcraft::runtime
