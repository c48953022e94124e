// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/content_reader.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/model_io/model_writer.h"
#include "lib/runtime/model_parser.h"

namespace handcraft::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A file and what was read of it, which points into the file.
struct Fixture {
  explicit Fixture(const model_io::ModelFile& model)
      : bytes(model_io::Serialise(model)), parsed(*ParseModel(bytes)), reader(parsed) {}

  void ExpectFailed(const std::string& message) const {
    EXPECT_EQ(reader.error().status, HC_ERROR_CONTENT);
    EXPECT_THAT(reader.error().message, HasSubstr(message));
  }

  std::vector<std::uint8_t> bytes;
  ParsedModel parsed;
  ContentReader reader;
};

model_io::ModelFile SomeModel() {
  model_io::ModelFile model;
  model.tensors["f"] = {std::vector<float>{1, 2, 3, 4, 5, 6}, {2, 3}};
  model.tensors["i"] = {std::vector<std::int32_t>{-7}, {1}};
  model.tensors["feature_mean"] = {std::vector<double>{0.0, -1.0}, {2}};
  model.tensors["feature_scale"] = {std::vector<double>{2.0, 1e-300}, {2}};
  model.metadata["hc.kind"] = "none";
  return model;
}

TEST(ContentReader, CopiesWhatHasTheTypeAndShape) {
  Fixture f(SomeModel());
  std::vector<float> values;
  std::int32_t one = 0;
  EXPECT_TRUE(f.reader.Read("f", {2, 3}, values));
  EXPECT_THAT(values, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_TRUE(f.reader.Read("f", {kAnyLength, 3}, values));
  EXPECT_TRUE(f.reader.ReadOne("i", one));
  EXPECT_EQ(one, -7);
  EXPECT_TRUE(f.reader.CheckNormaliser(2));
  EXPECT_TRUE(f.reader.RefuseUnknownTensors());
}

TEST(ContentReader, NamesAMissingTensorAndItsShape) {
  Fixture f(SomeModel());
  std::vector<double> values;
  EXPECT_FALSE(f.reader.Read("g", {kAnyLength, 4}, values));
  f.ExpectFailed("the tensor 'g' F64[?,4] is missing");
}

TEST(ContentReader, NamesBothShapes) {
  std::vector<float> values;
  std::vector<std::uint8_t> other;
  Fixture wrong_length(SomeModel());
  EXPECT_FALSE(wrong_length.reader.Read("f", {2, 4}, values));
  wrong_length.ExpectFailed("the tensor 'f' is F32[2,3] where F32[2,4] was expected");
  EXPECT_EQ(wrong_length.reader.error().byte_offset,
            wrong_length.parsed.FindTensor("f")->byte_offset);
  Fixture wrong_rank(SomeModel());
  EXPECT_FALSE(wrong_rank.reader.Read("f", {6}, values));
  wrong_rank.ExpectFailed("is F32[2,3] where F32[6] was expected");
  Fixture wrong_type(SomeModel());
  EXPECT_FALSE(wrong_type.reader.Read("f", {2, 3}, other));
  wrong_type.ExpectFailed("is F32[2,3] where U8[2,3] was expected");
}

TEST(ContentReader, KeepsTheFirstError) {
  Fixture f(SomeModel());
  std::vector<float> values;
  EXPECT_FALSE(f.reader.Read("missing", {1}, values));
  EXPECT_FALSE(f.reader.Read("f", {2, 3}, values));
  EXPECT_FALSE(f.reader.RefuseUnknownTensors());
  EXPECT_FALSE(f.reader.ExpectMetadata("hc.kind", "other"));
  f.ExpectFailed("the tensor 'missing'");
}

TEST(ContentReader, RefusesTensorsNobodyAskedFor) {
  Fixture f(SomeModel());
  std::vector<float> values;
  EXPECT_TRUE(f.reader.Read("f", {2, 3}, values));
  EXPECT_TRUE(f.reader.CheckNormaliser(2));
  EXPECT_FALSE(f.reader.RefuseUnknownTensors());
  f.ExpectFailed("the tensor 'i' is unknown");
}

TEST(ContentReader, LeavesExtensionsAlone) {
  model_io::ModelFile model;
  model.tensors["x.thumbnail"] = {std::vector<std::uint8_t>{1, 2}, {2}};
  Fixture f(model);
  EXPECT_TRUE(f.reader.RefuseUnknownTensors());
}

TEST(ContentReader, ComparesMetadata) {
  Fixture f(SomeModel());
  EXPECT_TRUE(f.reader.ExpectMetadata("hc.kind", "none"));
  EXPECT_FALSE(f.reader.ExpectMetadata("hc.kind", "some"));
  f.ExpectFailed("the metadata key hc.kind holds 'none', but the tensors say 'some'");
}

TEST(ContentReader, RefusesScalesThatAreNotPositive) {
  for (const double bad : {0.0, -1.0}) {
    model_io::ModelFile model = SomeModel();
    model.tensors["feature_scale"].values = std::vector<double>{1.0, bad};
    Fixture f(model);
    EXPECT_FALSE(f.reader.CheckNormaliser(2));
    f.ExpectFailed("entry 1 of the tensor 'feature_scale' is");
  }
  Fixture f(SomeModel());
  EXPECT_FALSE(f.reader.CheckNormaliser(3));
  f.ExpectFailed("the tensor 'feature_mean' is F64[2] where F64[3] was expected");
}

}  // namespace
}  // namespace handcraft::runtime
