// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

const std::string kReferences = HANDCRAFT_SOURCE_DIR "/tests/data/trainers/svm_classes";
const std::string kBreast = HANDCRAFT_SOURCE_DIR "/datasets/samples/tables/breast_w.csv";

TEST(Export, WritesLibsvmsTextThatIsReadAgain) {
  const TemporaryDirectory folder;
  const std::string model = (folder / "m.safetensors").string();
  const std::string text = (folder / "m.txt").string();
  const std::string again = (folder / "again.safetensors").string();
  ASSERT_EQ(RunLine("train svm " + kReferences + ".libsvm --out " + model).code, 0);
  const Outcome outcome = RunLine("export " + model + " --to libsvm --out " + text);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(ReadTextFile(text), HasSubstr("svm_type c_svc\nkernel_type polynomial\n"));
  ASSERT_EQ(RunLine("import " + text + " --from libsvm --out " + again).code, 0);
  const std::string table = kReferences + ".libsvm";
  const Outcome first = RunLine("evaluate " + model + " " + table + " --json");
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(RunLine("evaluate " + again + " " + table + " --json").out, first.out);
}

TEST(Export, RefusesOtherModelsAndFormats) {
  const TemporaryDirectory folder;
  const std::string model = (folder / "m.safetensors").string();
  const std::string out = " --out " + (folder / "m.txt").string();
  ASSERT_EQ(RunLine("train logistic " + kBreast + " --label class --out " + model).code, 0);
  const Outcome logistic = RunLine("export " + model + " --to libsvm" + out);
  EXPECT_EQ(logistic.code, 3);
  EXPECT_THAT(logistic.err, HasSubstr("not of kind svm"));
  EXPECT_EQ(RunLine("export " + model + " --to onnx" + out).code, 2);
  EXPECT_EQ(RunLine("export " + model + " --to libsvm --out " + model).code, 2);
  ASSERT_EQ(RunLine("train svm " + kBreast + " --label class --standardize --out " + model).code,
            0);
  EXPECT_THAT(RunLine("export " + model + " --to libsvm" + out).err,
              HasSubstr("train it without --standardize"));
}

}  // namespace
}  // namespace handcraft::tools
