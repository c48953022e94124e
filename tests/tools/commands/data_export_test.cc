// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/npy.h"
#include "datasets/formats/table.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

class DataExport : public testing::ImageSetTest {
 protected:
  [[nodiscard]] Outcome Export(const std::string& file, const std::string& options = "") const {
    return RunLine("data export " + set_.string() + " --out " + (folder_ / file).string() +
                   " --features edges54 " + options);
  }
};

TEST_F(DataExport, BothFormatsHoldTheSameTable) {
  ASSERT_EQ(Export("t.csv", "--samples 100").code, 0);
  const Outcome outcome = Export("t.npy", "--samples 100");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Wrote 100 samples with 54 features and a label to "));
  const datasets::Table csv = datasets::ReadTable(folder_ / "t.csv", "label");
  const datasets::Table npy = datasets::ReadTable(folder_ / "t.npy", "-1");
  EXPECT_EQ(csv.num_rows, 100U);
  EXPECT_EQ(csv.columns.size(), 54U);
  ASSERT_EQ(csv.values.size(), npy.values.size());
  for (std::size_t i = 0; i < csv.values.size(); ++i) {  // shortest text of a float
    EXPECT_EQ(static_cast<float>(csv.values[i]), static_cast<float>(npy.values[i]));
  }
  EXPECT_EQ(csv.labels, npy.labels);
}

// The table trains the very model that the pictures train.
TEST_F(DataExport, TrainsTheSameModelAsThePictures) {
  ASSERT_EQ(Export("t.npy", "--samples 400 --seed 5").code, 0);
  const auto from_table = nlohmann::json::parse(
      RunLine("train logistic " + (folder_ / "t.npy").string() + " --label -1 --ridge 1 --json")
          .out);
  const auto from_pictures = nlohmann::json::parse(
      RunLine("train grasp-points " + set_.string() + " --out " + (folder_ / "m").string() +
              " --features edges54 --samples 400 --seed 5 --ridge 1 --json")
          .out);
  EXPECT_EQ(from_table["deviance"], from_pictures["deviance"]);
  EXPECT_EQ(from_table["num_samples"], from_pictures["num_samples"]);
}

TEST_F(DataExport, RefusesAnotherExtensionAndItsOwnInputs) {
  const Outcome outcome = Export("t.txt");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--out must end in .csv or .npy"));
  const Outcome manifest =
      RunLine("data export " + set_.string() + " --out " + (set_ / "manifest.csv").string());
  EXPECT_EQ(manifest.code, 2);
  EXPECT_THAT(manifest.err, HasSubstr("manifest.csv"));
  EXPECT_EQ(Export("t.csv", "--samples 0 --bad-per-good 2").code, 2);
  EXPECT_EQ(testing::NumEntries(folder_.path()), 1U);
}

TEST_F(DataExport, TellsMachinesTheSame) {
  const auto json = nlohmann::json::parse(Export("t.npy", "--samples 100 --json").out);
  EXPECT_EQ(json["num_samples"], 100);
  EXPECT_EQ(json["num_features"], 54);
  EXPECT_EQ(json["num_images"], 4);
}

}  // namespace
}  // namespace handcraft::tools
