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
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunArgs;

class Inspect : public ::testing::Test {
 protected:
  void SetUp() override {
    testing::WriteTable(folder_ / "t.csv");
    testing::TrainLogistic(folder_ / "t.csv", folder_ / "m");
    model_ = (folder_ / "m").string();
  }

  TemporaryDirectory folder_;
  std::string model_;
};

TEST_F(Inspect, ShowsMetadataTensorsAndIdentity) {
  const Outcome outcome = RunArgs({"inspect", model_});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("sha256 " + Sha256Hex(ReadFile(model_))),
                    ContainsRegex("hc.kind +logistic"),
                    ContainsRegex("hc.label_column +class"),
                    ContainsRegex("weights +F64 +\\[2\\]")));
}

TEST_F(Inspect, TellsMachinesTheSame) {
  const auto json = nlohmann::json::parse(RunArgs({"inspect", model_, "--json"}).out);
  EXPECT_EQ(json["bytes"], ReadFile(model_).size());
  EXPECT_EQ(json["metadata"]["hc.kind"], "logistic");
  EXPECT_EQ(json["metadata"]["hc.training.irls.ridge"], "0");
  EXPECT_EQ(json["metadata"]["hc.metrics.train.num_samples"], "60");
  bool has_weights = false;
  for (const auto& tensor : json["tensors"]) {
    if (tensor["name"] != "weights") continue;
    has_weights = true;
    EXPECT_EQ(tensor["dtype"], "F64");
    EXPECT_EQ(tensor["shape"], nlohmann::json::array({2}));
  }
  EXPECT_TRUE(has_weights);
}

TEST_F(Inspect, RefusesWhatIsNoModel) {
  const Outcome outcome = RunArgs({"inspect", (folder_ / "t.csv").string()});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("t.csv"));
}

}  // namespace
}  // namespace handcraft::tools
