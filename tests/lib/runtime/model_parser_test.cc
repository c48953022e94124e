// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/model_parser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "tests/lib/runtime/raw_model.h"

namespace handcraft::runtime {
namespace {

using ::testing::HasSubstr;
using testing::kSmallHeader;
using testing::RawModel;
using testing::Replaced;
using testing::SmallData;
using Bytes = std::vector<std::uint8_t>;

Bytes SmallModel() { return RawModel(std::string(kSmallHeader), SmallData()); }

Bytes SmallModelWith(std::string_view from, std::string_view to) {
  return RawModel(Replaced(std::string(kSmallHeader), from, to), SmallData());
}

void ExpectRefused(const Bytes& bytes, hc_status status, const std::string& message) {
  const Result<ParsedModel> model = ParseModel(bytes);
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().status, status) << model.error().message;
  EXPECT_THAT(model.error().message, HasSubstr(message));
}

TEST(ParseModel, FindsTheTensors) {
  const Bytes bytes = SmallModel();
  const Result<ParsedModel> model = ParseModel(bytes);
  ASSERT_TRUE(model) << model.error().message;
  const TensorView& b = *model->FindTensor("b");
  EXPECT_THAT(b.bytes, ::testing::ElementsAre(7, 8, 9));
  EXPECT_EQ(b.bytes.data(), bytes.data() + b.byte_offset);
  EXPECT_EQ(model->FindTensor("a")->byte_offset % 64, 0U);
}

TEST(ParseModel, RefusesEveryFlippedBit) {
  const Bytes bytes = SmallModel();
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    Bytes flipped = bytes;
    flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    ASSERT_FALSE(ParseModel(flipped)) << bit;
  }
}

TEST(ParseModel, CallsEveryShorterFileTruncated) {
  const Bytes bytes = SmallModel();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ExpectRefused({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)},
                  HC_ERROR_TRUNCATED,
                  size == 0 ? "the file is empty" : "the file ends after");
  }
}

TEST(ParseModel, CallsDamageDamageWhateverElseItBroke) {
  Bytes bytes = SmallModel();
  bytes[9] = 'X';
  ExpectRefused(bytes, HC_ERROR_CHECKSUM, "the file is damaged");
  bytes = SmallModel();
  bytes.back() ^= 1;
  ExpectRefused(bytes, HC_ERROR_CHECKSUM, "copy it again");
  bytes = SmallModel();
  bytes[bytes.size() - 8] = 'c';
  ExpectRefused(bytes, HC_ERROR_CHECKSUM, "the file is damaged");
}

TEST(ParseModel, RefusesOtherFiles) {
  const std::string png = "\x89PNG\r\n\x1A\n and what follows it";
  ExpectRefused({png.begin(), png.end()}, HC_ERROR_FORMAT, "not a model file");
  const std::string text = "{\"a\": 1, \"b\": 2}";
  ExpectRefused({text.begin(), text.end()}, HC_ERROR_FORMAT, "not a model file");
}

TEST(ParseModel, RefusesHeadersOfImpossibleLength) {
  Bytes bytes = SmallModel();
  for (const std::uint64_t length : {(std::uint64_t{1} << 20) + 1, UINT64_MAX, UINT64_MAX - 7}) {
    std::memcpy(bytes.data(), &length, 8);
    ExpectRefused(bytes, HC_ERROR_FORMAT, "a header length of at most 1048576");
  }
  const std::uint64_t odd = 60;
  std::memcpy(bytes.data(), &odd, 8);
  testing::Seal(bytes);
  ExpectRefused(bytes, HC_ERROR_FORMAT, "does not put the tensors at a multiple of 64");
}

TEST(ParseModel, RefusesGapsOverlapsAndOtherOrders) {
  ExpectRefused(SmallModelWith("[8,11]", "[9,12]"),
                HC_ERROR_FORMAT,
                "tensor 'b' begins at offset 9 where 8 was expected");
  ExpectRefused(SmallModelWith("[8,11]", "[5,8]"),
                HC_ERROR_FORMAT,
                "tensor 'b' begins at offset 5 where 8 was expected");
  ExpectRefused(SmallModelWith("[0,8]", "[1,9]"),
                HC_ERROR_FORMAT,
                "tensor 'a' begins at offset 1 where 0 was expected");
  // Sorted by name alone would put the bytes of the wide tensor behind those of the narrow one.
  const std::string by_name = R"({"__metadata__":{"hc.format":"1.0"},)"
                              R"("a":{"dtype":"U8","shape":[1],"data_offsets":[0,1]},)"
                              R"("b":{"dtype":"F32","shape":[1],"data_offsets":[1,5]},)"
                              R"("zz.crc":{"dtype":"U8","shape":[8],"data_offsets":[5,13]}})";
  ExpectRefused(RawModel(by_name, Bytes(5)),
                HC_ERROR_FORMAT,
                "tensor 'b' begins at offset 1 where 0 was expected");
}

TEST(ParseModel, RefusesMissingAndOddChecksumTensors) {
  ExpectRefused(SmallModelWith("zz.crc", "c"), HC_ERROR_FORMAT, "lacks the checksum");
  ExpectRefused(
      SmallModelWith(R"("shape":[8])", R"("shape":[2,4])"), HC_ERROR_FORMAT, "lacks the checksum");
  ExpectRefused(SmallModelWith(R"("zz.crc":{"dtype":"U8","shape":[8])",
                               R"("zz.crc":{"dtype":"I64","shape":[1])"),
                HC_ERROR_FORMAT,
                "lacks the checksum");
  ExpectRefused(RawModel(R"({"__metadata__":{"hc.format":"1.0"}})", {}),
                HC_ERROR_FORMAT,
                "lacks the checksum");
}

TEST(ParseModel, RefusesBytesBehindTheLastTensor) {
  Bytes data = SmallData();
  data.push_back(0);
  ExpectRefused(
      RawModel(std::string(kSmallHeader), data), HC_ERROR_FORMAT, "1 bytes follow the last tensor");
}

TEST(ParseModel, RefusesNumbersThatAreNotFinite) {
  const float bad_floats[] = {std::numeric_limits<float>::quiet_NaN(),
                              std::numeric_limits<float>::signaling_NaN(),
                              std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity()};
  for (const float bad : bad_floats) {
    Bytes data = SmallData();
    std::memcpy(data.data() + 4, &bad, 4);
    ExpectRefused(RawModel(std::string(kSmallHeader), data),
                  HC_ERROR_FORMAT,
                  "entry 1 of tensor 'a' is not a finite number");
  }
  Bytes data = SmallData();
  const double bad = std::numeric_limits<double>::infinity();
  std::memcpy(data.data(), &bad, 8);
  const std::string header =
      Replaced(std::string(kSmallHeader), R"("F32","shape":[2])", R"("F64","shape":[1])");
  ExpectRefused(RawModel(header, data), HC_ERROR_FORMAT, "entry 0 of tensor 'a'");
}

TEST(ParseModel, TakesTheLargestFiniteNumbers) {
  Bytes data = SmallData();
  const float largest = std::numeric_limits<float>::max();
  std::memcpy(data.data(), &largest, 4);
  EXPECT_TRUE(ParseModel(RawModel(std::string(kSmallHeader), data)));
}

// Sealed again after each change, so that the rules behind the checksum are reached.
TEST(ParseModel, NeverReadsOutsideHoweverTheHeaderIsChanged) {
  const Bytes bytes = SmallModel();
  Rng rng(1);
  int num_accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    Bytes changed = bytes;
    const auto num_changes = 1 + rng.UniformInt(3);
    for (std::uint64_t k = 0; k < num_changes; ++k) {
      changed[rng.UniformInt(changed.size() - 8)] = static_cast<std::uint8_t>(rng.Next());
    }
    testing::Seal(changed);
    if (ParseModel(changed)) ++num_accepted;
  }
  // Some only change a tensor's values or a metadata text.
  EXPECT_GT(num_accepted, 0);
  EXPECT_LT(num_accepted, 10000);
}

}  // namespace
}  // namespace handcraft::runtime
