// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/model_header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lib/runtime/raw_model.h"

namespace handcraft::runtime {
namespace {

using ::testing::HasSubstr;
using testing::kSmallHeader;
using testing::Replaced;

Result<ParsedModel> Read(std::string_view header) {
  return ReadModelHeader({reinterpret_cast<const std::uint8_t*>(header.data()), header.size()});
}

void ExpectRefused(const std::string& header,
                   const std::string& message,
                   hc_status status = HC_ERROR_FORMAT) {
  const Result<ParsedModel> model = Read(header);
  ASSERT_FALSE(model) << header.substr(0, 200);
  EXPECT_EQ(model.error().status, status) << model.error().message;
  EXPECT_THAT(model.error().message, HasSubstr(message));
  EXPECT_LE(model.error().byte_offset, 8 + header.size());
}

// The small header with one thing replaced.
void ExpectRefused(std::string_view from, std::string_view to, const std::string& message) {
  ExpectRefused(Replaced(std::string(kSmallHeader), from, to), message);
}

TEST(ReadModelHeader, TakesAHeaderApart) {
  const Result<ParsedModel> model = Read(kSmallHeader);
  ASSERT_TRUE(model) << model.error().message;
  ASSERT_EQ(model->metadata.size(), 2U);
  EXPECT_EQ(*model->FindMetadata("hc.kind"), "none");
  EXPECT_EQ(model->FindMetadata("hc.name"), nullptr);
  ASSERT_EQ(model->tensors.size(), 3U);
  const TensorView& b = *model->FindTensor("b");
  EXPECT_EQ(b.dtype, format::Dtype::kU8);
  EXPECT_EQ(b.rank, 2U);
  EXPECT_EQ(b.shape[0], 1U);
  EXPECT_EQ(b.shape[1], 3U);
  EXPECT_EQ(b.begin, 8U);
  EXPECT_EQ(b.num_bytes, 3U);
  EXPECT_EQ(model->FindTensor("c"), nullptr);
}

TEST(ReadModelHeader, IgnoresUnknownMetadataAndNewerMinorNumbers) {
  EXPECT_TRUE(Read(Replaced(std::string(kSmallHeader), "\"hc.kind\"", "\"hc.new_key\"")));
  EXPECT_TRUE(Read(Replaced(std::string(kSmallHeader), "1.0", "1.9")));
}

TEST(ReadModelHeader, ChecksTheVersionBeforeItReadsTensors) {
  std::string later = Replaced(std::string(kSmallHeader), "1.0", "2.0");
  ExpectRefused(Replaced(later, "\"F32\"", "{\"new\":1}"), "has format 2.0", HC_ERROR_VERSION);
  ExpectRefused(
      Replaced(std::string(kSmallHeader), "\"hc.kind\":\"none\"", "\"hc.requires\":\"magic\""),
      "requires 'magic'",
      HC_ERROR_VERSION);
  ExpectRefused(R"("hc.format":"1.0",)", "", "hc.format holds ''");
}

TEST(ReadModelHeader, RefusesDuplicateAndUnsortedKeys) {
  ExpectRefused(R"("hc.kind":"none")", R"("hc.format":"1.0")", "holds the key 'hc.format' twice");
  ExpectRefused(R"("hc.kind":"none")", R"("a":"")", "the key 'a' out of order");
  ExpectRefused(R"("b":)", R"("a":)", "holds the key 'a' twice");
  ExpectRefused(R"("a":)", R"("c":)", "the key 'b' out of order");
  ExpectRefused(R"("b":)", R"("__metadata__":)", "the tensor name '__metadata__' breaks the rule");
}

TEST(ReadModelHeader, RefusesTrailingCommasAndSpaces) {
  ExpectRefused(R"("none"})", R"("none",})", "holds '}' (0x7d) where a string");
  ExpectRefused(R"([2],)", R"([2,],)", "holds ']' (0x5d) where a whole number");
  ExpectRefused(R"([0,8]})", R"([0,8],})", "where } was expected");
  ExpectRefused(R"([11,19]}})", R"([11,19]},})", "holds '}' (0x7d) where a string");
  ExpectRefused(R"("shape")", R"( "shape")", "holds ' ' (0x20) where \"shape\"");
  ExpectRefused(R"([11,19]}})", R"([11,19]}}x)", "nothing but spaces");
}

TEST(ReadModelHeader, RefusesOtherJson) {
  ExpectRefused("", "the header ends");
  ExpectRefused("[]", "where { was expected");
  ExpectRefused("{}", R"(where "__metadata__":{ was expected)");
  ExpectRefused(R"({"__metadata__":{}})", "where a string was expected");
  ExpectRefused(R"("none")", "1", "where a string was expected");
  ExpectRefused(R"("none")", "null", "where a string was expected");
  ExpectRefused(R"("none")", R"({"deep":{}})", "where a string was expected");
  ExpectRefused(R"("dtype":"F32","shape":[2])", R"("shape":[2],"dtype":"F32")", "was expected");
  ExpectRefused(R"(,"data_offsets":[0,8])", "", "was expected");
  ExpectRefused(R"(,"data_offsets":[0,8])", R"(,"data_offsets":[0,8,9])", "where ] was expected");
}

TEST(ReadModelHeader, SurvivesDeepNesting) {
  ExpectRefused("{\"__metadata__\":" + std::string(500000, '{'), "was expected");
  ExpectRefused(R"([2])", std::string(500000, '['), "where a whole number of at least 0");
}

TEST(ReadModelHeader, RefusesOtherNamesTypesAndShapes) {
  ExpectRefused(R"("a")", R"("A")", "the tensor name 'A' breaks the rule");
  ExpectRefused(R"("a")", R"("")", "the tensor name '' breaks the rule");
  ExpectRefused(R"("a")", R"(".a")", "breaks the rule");
  ExpectRefused(R"("a")", '"' + std::string(64, 'a') + '"', "a string of more than 63 bytes");
  ExpectRefused(R"("zz.crc")", R"("zz.crd")", "sorts after 'zz.crc'");
  ExpectRefused("hc.kind", "hc kind", "the metadata key 'hc kind' breaks the rule");
  ExpectRefused(R"("hc.kind")", R"("")", "the metadata key '' breaks the rule");
  ExpectRefused("F32", "F16", "the dtype 'F16' is not one of");
  ExpectRefused("[2]", "[]", "where a whole number");
  ExpectRefused("[2]", "[0]", "the shape of tensor 'a' must have 1 to 4 dimensions");
  ExpectRefused("[2]", "[1,1,1,1,2]", "the shape of tensor 'a' must have 1 to 4 dimensions");
  ExpectRefused("[2]", "[-2]", "holds '-'");
  ExpectRefused("[2]", "[2.0]", "holds '.'");
  ExpectRefused("[2]", "[2e0]", "holds 'e'");
}

TEST(ReadModelHeader, RefusesSizesThatOverflow) {
  ExpectRefused("[2]", "[9007199254740992]", "fit into a file");
  ExpectRefused("[2]", "[65536,65536,65536,65536]", "fit into a file");
  ExpectRefused("[2]", "[4294967296,4294967296]", "fit into a file");
  ExpectRefused("[0,8]", "[0,18446744073709551616]", "above 2^53");
}

TEST(ReadModelHeader, RefusesOffsetsThatDoNotFitTheShape) {
  ExpectRefused("[0,8]", "[0,9]", "spans the offsets 0 to 9, but its shape takes 8 bytes");
  ExpectRefused("[0,8]", "[8,0]", "spans the offsets 8 to 0");
  ExpectRefused("[0,8]", "[0,7]", "spans the offsets 0 to 7");
}

TEST(ReadModelHeader, KeepsToItsLimits) {
  std::string many_tensors = R"({"__metadata__":{"hc.format":"1.0"})";
  for (int i = 100; i < 165; ++i) {
    many_tensors +=
        ",\"t" + std::to_string(i) + R"(":{"dtype":"U8","shape":[1],"data_offsets":[0,1]})";
  }
  ExpectRefused(many_tensors + "}", "more than 64 tensors");

  std::string many_keys = R"({"__metadata__":{"hc.format":"1.0")";
  for (int i = 1000; i < 1256; ++i) many_keys += ",\"k" + std::to_string(i) + "\":\"\"";
  ExpectRefused(many_keys + "}}", "more than 256 metadata keys");

  ExpectRefused("none", std::string((16 << 10) + 1, 'x'), "a string of more than 16384 bytes");
  EXPECT_TRUE(Read(Replaced(std::string(kSmallHeader), "none", std::string(16 << 10, 'x'))));
  ExpectRefused("hc.kind", std::string(128, 'x'), "a string of more than 127 bytes");
}

}  // namespace
}  // namespace handcraft::runtime
