// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunArgs;
using ::testing::StartsWith;

class CheckModelTest : public ::testing::Test {
 protected:
  void SetUp() override {
    testing::WriteTable(folder_ / "t.csv");
    testing::TrainLogistic(folder_ / "t.csv", folder_ / "m");
    model_ = (folder_ / "m").string();
    bytes_ = ReadFile(model_);
  }

  [[nodiscard]] Outcome Check() const { return RunArgs({"check-model", model_}); }

  TemporaryDirectory folder_;
  std::string model_;
  std::vector<std::uint8_t> bytes_;
};

TEST_F(CheckModelTest, AcceptsAGoodModel) {
  const Outcome outcome = Check();
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, AllOf(StartsWith("OK: "), HasSubstr("sha256 " + Sha256Hex(bytes_))));
}

TEST_F(CheckModelTest, AnswersMachines) {
  const auto json = nlohmann::json::parse(RunArgs({"check-model", model_, "--json"}).out);
  EXPECT_EQ(json["ok"], true);
  EXPECT_EQ(json["kind"], "logistic");
  EXPECT_EQ(json["sha256"], Sha256Hex(bytes_));
}

TEST_F(CheckModelTest, RefusesADamagedModelWithTheRuntimesReason) {
  bytes_[bytes_.size() / 2] ^= 1U;
  WriteFileAtomically(model_, bytes_);
  const Outcome outcome = Check();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, AllOf(StartsWith("handcraft: error: " + model_), HasSubstr("damaged")));
}

TEST_F(CheckModelTest, RefusesTruncatedAndEmptyModels) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, bytes_.size() - 1}) {
    WriteFileAtomically(model_, std::span(bytes_).first(size));
    EXPECT_EQ(Check().code, 3) << size;
    EXPECT_THAT(Check().err, StartsWith("handcraft: error: " + model_)) << size;
  }
}

TEST_F(CheckModelTest, RefusesAFolderAndAMissingFile) {
  EXPECT_EQ(RunArgs({"check-model", folder_.path().string()}).code, 3);
  EXPECT_EQ(RunArgs({"check-model", "no/such/model"}).code, 3);
}

}  // namespace
}  // namespace handcraft::tools
