// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/model_writer.h"

#include <limits>
#include <stdexcept>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "lib/core/sha256.h"
#include "tests/lib/runtime/raw_model.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::model_io {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

bool Same(const ModelFile& a, const ModelFile& b) {
  if (a.metadata != b.metadata || a.tensors.size() != b.tensors.size()) return false;
  for (const auto& [name, tensor] : a.tensors) {
    const auto other = b.tensors.find(name);
    if (other == b.tensors.end() || other->second.shape != tensor.shape ||
        other->second.values != tensor.values) {
      return false;
    }
  }
  return true;
}

ModelFile SmallModel() {
  ModelFile model;
  model.tensors["a"] = {std::vector<float>{1.0F, 2.0F}, {2}};
  model.tensors["b"] = {std::vector<std::uint8_t>{7, 8, 9}, {1, 3}};
  model.metadata["hc.kind"] = "none";
  return model;
}

TEST(Serialise, WritesTheBytesOfTheSpecification) {
  EXPECT_EQ(Serialise(SmallModel()),
            testing::RawModel(std::string(testing::kSmallHeader), testing::SmallData()));
}

TEST(Serialise, PutsWideEntriesFirst) {
  ModelFile model;
  model.tensors["a"] = {std::vector<std::uint8_t>{1}, {1}};
  model.tensors["b"] = {std::vector<std::int32_t>{2}, {1}};
  model.tensors["c"] = {std::vector<std::int64_t>{3}, {1}};
  model.tensors["d"] = {std::vector<double>{4.0}, {1}};
  const Bytes bytes = Serialise(model);
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_THAT(text,
              AllOf(HasSubstr(R"("a":{"dtype":"U8","shape":[1],"data_offsets":[20,21]})"),
                    HasSubstr(R"("b":{"dtype":"I32","shape":[1],"data_offsets":[16,20]})"),
                    HasSubstr(R"("c":{"dtype":"I64","shape":[1],"data_offsets":[0,8]})"),
                    HasSubstr(R"("d":{"dtype":"F64","shape":[1],"data_offsets":[8,16]})")));
}

TEST(Parse, GivesBackWhatWasWritten) {
  for (ModelFile model : {SmallModel(),
                          testing::SomeLogisticModel(),
                          testing::SomeGraspPointModel("saxena459,energy=log")}) {
    const Bytes bytes = Serialise(model);
    const ModelFile parsed = Parse(bytes, "m");
    model.metadata["hc.format"] = "1.0";
    EXPECT_TRUE(Same(parsed, model));
    EXPECT_EQ(Serialise(parsed), bytes);
  }
}

TEST(Parse, GivesBackRandomModels) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Rng rng = Rng::Stream(1, "model_writer", i);
    ModelFile model;
    model.metadata["hc.format"] = "1.0";
    for (std::uint64_t k = rng.UniformInt(10); k > 0; --k) {
      std::string text;
      for (std::uint64_t n = rng.UniformInt(30); n > 0; --n) {
        text += "ab\"\\\n\t{}:,/\x7F"[rng.UniformInt(12)];
      }
      model.metadata["Key-" + std::to_string(k)] = text + "é→";
    }
    for (std::uint64_t k = rng.UniformInt(20); k > 0; --k) {
      const std::size_t size = 1 + rng.UniformInt(50);
      std::vector<double> doubles(size);
      for (double& value : doubles) value = rng.Normal();
      Tensor tensor{doubles, {1, static_cast<std::int64_t>(size), 1}};
      if (k % 3 == 0) tensor.values = std::vector<float>(doubles.begin(), doubles.end());
      if (k % 3 == 1) tensor.values = std::vector<std::uint8_t>(size, 255);
      model.tensors["t" + std::to_string(k)] = tensor;
    }
    ASSERT_TRUE(Same(Parse(Serialise(model), "m"), model)) << i;
  }
}

TEST(Serialise, GivesTheSameBytesForTheSameModel) {
  EXPECT_EQ(Sha256Hex(Serialise(testing::SomeGraspPointModel("all500"))),
            Sha256Hex(Serialise(testing::SomeGraspPointModel("all500"))));
}

TEST(Serialise, RefusesWhatTheReaderWouldRefuse) {
  const auto expect_refused = [](const auto& change, const std::string& message) {
    ModelFile model = SmallModel();
    change(model);
    EXPECT_THROWS_MESSAGE(Serialise(model),
                          Error,
                          AllOf(HasSubstr("the model cannot be written"), HasSubstr(message)));
  };
  const Tensor one{std::vector<std::uint8_t>{1}, {1}};
  expect_refused(
      [](ModelFile& m) {
        m.tensors["a"].values = std::vector<float>{1, std::numeric_limits<float>::quiet_NaN()};
      },
      "entry 1 of tensor 'a' is not a finite number");
  expect_refused([&](ModelFile& m) { m.tensors["Upper"] = one; }, "the tensor name 'Upper'");
  expect_refused([&](ModelFile& m) { m.tensors["zzz"] = one; }, "sorts after 'zz.crc'");
  expect_refused([&](ModelFile& m) { m.tensors[std::string(64, 'a')] = one; }, "63 bytes");
  expect_refused(
      [&](ModelFile& m) {
        for (int i = 0; i < 64; ++i) m.tensors["t" + std::to_string(i)] = one;
      },
      "more than 64 tensors");
  expect_refused([](ModelFile& m) { m.tensors["c"] = {std::vector<float>{}, {0}}; }, "the shape");
  expect_refused([](ModelFile& m) { m.tensors["b"].shape = {1, 1, 1, 1, 3}; }, "the shape");
  expect_refused([](ModelFile& m) { m.metadata["k"] = std::string(16385, 'x'); }, "16384 bytes");
  expect_refused([](ModelFile& m) { m.metadata["k"] = "bell \a"; }, "a printable character");
  expect_refused([](ModelFile& m) { m.metadata["k"] = "\xFF"; }, "not UTF-8");
  expect_refused([](ModelFile& m) { m.metadata["two words"] = ""; },
                 "the metadata key 'two words'");
  expect_refused([](ModelFile& m) { m.metadata["hc.requires"] = "magic"; }, "requires 'magic'");
  expect_refused(
      [](ModelFile& m) {
        for (int i = 0; i < 100; ++i) m.metadata["k" + std::to_string(i)] = std::string(16384, 'x');
      },
      "a header length of at most 1048576");
}

TEST(Serialise, RefusesAShapeThatIsNotThatOfTheValues) {
  ModelFile model = SmallModel();
  model.tensors["a"].shape = {3};
  EXPECT_THROWS_MESSAGE(Serialise(model), std::logic_error, HasSubstr("a, 3, 2"));
}

TEST(Parse, NamesThePathAndTheByte) {
  Bytes bytes = Serialise(SmallModel());
  bytes.resize(100);
  EXPECT_THROWS_MESSAGE(Parse(bytes, "m.safetensors"),
                        Error,
                        HasSubstr("m.safetensors at byte 100: the file ends after 100 bytes"));
  EXPECT_THROWS_MESSAGE(Parse({}, "e"), Error, HasSubstr("e at byte 0: the file is empty"));
}

}  // namespace
}  // namespace handcraft::model_io
