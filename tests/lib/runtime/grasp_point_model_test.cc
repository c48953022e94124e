// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/grasp_point_model.h"

#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/runtime/model_parser.h"
#include "tests/lib/runtime/some_models.h"

namespace handcraft::runtime {
namespace {

using model_io::ModelFile;
using model_io::Tensor;
using ::testing::HasSubstr;

Result<features::PixelScorer> Load(const ModelFile& model) {
  const std::vector<std::uint8_t> bytes = model_io::Serialise(model);
  return LoadGraspPointScorer(*ParseModel(bytes));
}

void ExpectRefused(const std::function<void(ModelFile&)>& change,
                   const std::string& message,
                   hc_status status = HC_ERROR_CONTENT) {
  ModelFile model = testing::SomeGraspPointModel("edges54");
  change(model);
  const auto scorer = Load(model);
  ASSERT_FALSE(scorer) << message;
  EXPECT_EQ(scorer.error().status, status) << scorer.error().message;
  EXPECT_THAT(scorer.error().message, HasSubstr(message));
}

template <class T>
std::vector<T>& ValuesOf(ModelFile& model, const std::string& name) {
  return std::get<std::vector<T>>(model.tensors.at(name).values);
}

TEST(LoadGraspPointScorer, KeepsTheSpecification) {
  for (const std::string_view text : {"all500",
                                      "edges150,energy=abs",
                                      "window180,energy=log",
                                      "edges54",
                                      "saxena459",
                                      "filters=laplacian,window=1"}) {
    const auto scorer = Load(testing::SomeGraspPointModel(text));
    ASSERT_TRUE(scorer) << text << ": " << scorer.error().message;
    EXPECT_EQ(scorer->spec(), features::ParseFeatureSpec(text));
  }
}

TEST(LoadGraspPointScorer, RefusesEachMissingTensor) {
  const ModelFile whole = testing::SomeGraspPointModel("edges54");
  EXPECT_EQ(whole.tensors.size(), 12U);
  for (const auto& entry : whole.tensors) {
    const std::string& name = entry.first;
    ExpectRefused([&](ModelFile& model) { model.tensors.erase(name); },
                  "the tensor '" + name + "' ");
  }
}

TEST(LoadGraspPointScorer, RefusesEachTensorOfAnotherShape) {
  const ModelFile whole = testing::SomeGraspPointModel("edges54");
  for (const auto& entry : whole.tensors) {
    const std::string& name = entry.first;
    std::int64_t size = 1;
    for (const std::int64_t dimension : entry.second.shape) size *= dimension;
    ExpectRefused(
        [&](ModelFile& model) {
          auto& shape = model.tensors[name].shape;
          shape = shape.size() == 1 ? std::vector<std::int64_t>{1, size} : std::vector{size};
        },
        "the tensor '" + name + "' is");
  }
}

TEST(LoadGraspPointScorer, RefusesUnknownTensorsUnlessTheyAreExtensions) {
  const Tensor extra{std::vector<float>{1.0F}, {1}};
  ExpectRefused([&](ModelFile& model) { model.tensors["gain"] = extra; },
                "the tensor 'gain' is unknown to this kind of model");
  ModelFile extended = testing::SomeGraspPointModel("edges54");
  extended.tensors["x.gain"] = extra;
  extended.metadata["other.key"] = "ignored";
  EXPECT_TRUE(Load(extended));
}

TEST(LoadGraspPointScorer, RefusesNumbersOutOfRange) {
  using Ints = std::vector<std::int32_t>;
  const auto set = [](const std::string& name, const Ints& values) {
    return [=](ModelFile& model) { ValuesOf<std::int32_t>(model, name) = values; };
  };
  ExpectRefused(set("filter_ids", {9, 10, 11, 12, 13, 22}),
                "the tensor 'filter_ids' holds 22; this library has the filters 0 to 21");
  ExpectRefused(set("filter_ids", {9, 10, 11, 12, 13, -1}), "holds -1");
  ExpectRefused(set("filter_ids", {9, 10, 11, 12, 13, 13}), "the feature specification is invalid");
  ExpectRefused(set("energy", {3}), "the tensor 'energy' holds 3");
  ExpectRefused(set("energy", {-1}), "the tensor 'energy' holds -1");
  for (const std::int32_t window : {0, 2, 4, 7, -3, 2147483647}) {
    ExpectRefused(set("window", {window}), "the feature specification is invalid");
  }
  for (const Ints& scales : {Ints{1}, Ints{0}, Ints{9, 3}, Ints{17}, Ints{-3}, Ints{3, 3}}) {
    ExpectRefused(
        [&](ModelFile& model) {
          model.tensors["scales"] = {scales, {static_cast<std::int64_t>(scales.size())}};
        },
        "the feature specification is invalid");
  }
}

TEST(LoadGraspPointScorer, RefusesOtherFilters) {
  ExpectRefused(
      [](ModelFile& model) {
        float& last = ValuesOf<float>(model, "filters").back();
        last = std::nextafter(last, 1.0F);
      },
      "filter 'edge_150' of the model differs from that of Handcraft");
  ExpectRefused([](ModelFile& model) { ValuesOf<float>(model, "energy_offset") = {2e-5F}; },
                "the tensor 'energy_offset' holds 2e-05; this library has 1e-05");
}

TEST(LoadGraspPointScorer, RefusesFeatureTextThatSaysSomethingElse) {
  ExpectRefused([](ModelFile& model) { model.metadata["hc.features"] = "edges54"; },
                "the metadata key hc.features holds 'edges54', but the tensors say");
  ExpectRefused([](ModelFile& model) { model.metadata.erase("hc.features"); },
                "the metadata key hc.features holds ''");
  ExpectRefused([](ModelFile& model) { model.metadata["hc.features.sha256"].back() ^= 1; },
                "the metadata key hc.features.sha256");
}

TEST(LoadGraspPointScorer, RunsTheSelfTest) {
  const auto moved = [](ModelFile& model) { ValuesOf<double>(model, "intercept")[0] += 0.01; };
  ExpectRefused(moved, "the self-test gives", HC_ERROR_SELF_TEST);
  ExpectRefused([](ModelFile& model) { ValuesOf<float>(model, "selftest.output")[45] += 0.01F; },
                "at pixel (5, 1)",
                HC_ERROR_SELF_TEST);
  for (const float tolerance : {0.0F, -1.0F, 0.11F}) {
    ExpectRefused(
        [&](ModelFile& model) { ValuesOf<float>(model, "selftest.tolerance") = {tolerance}; },
        "the tensor 'selftest.tolerance' holds");
  }
  ExpectRefused(
      [](ModelFile& model) {
        model.tensors["selftest.input"] = {std::vector<std::uint8_t>(3 * 257), {1, 257, 3}};
      },
      "larger than 256 pixels a side");
}

// Weights as large as floats go must neither crash nor pass a test they fail.
TEST(LoadGraspPointScorer, SurvivesHugeWeights) {
  ExpectRefused(
      [](ModelFile& model) {
        for (float& weight : ValuesOf<float>(model, "weights")) weight = 3e38F;
      },
      "the self-test gives",
      HC_ERROR_SELF_TEST);
}

}  // namespace
}  // namespace handcraft::runtime
