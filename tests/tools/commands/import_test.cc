// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;
using testing::NumEntries;
using testing::Outcome;
using testing::RunLine;

const std::string kReferences = HANDCRAFT_SOURCE_DIR "/tests/data/trainers/svm_classes";

TEST(Import, TakesOverWhatSvmTrainWrote) {
  const TemporaryDirectory folder;
  const std::string model = (folder / "m.safetensors").string();
  const Outcome outcome =
      RunLine("import " + kReferences + "_rbf.model --from libsvm --out " + model);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Model of 4 classes"));
  EXPECT_EQ(RunLine("check-model " + model).code, 0);
  EXPECT_EQ(RunLine("evaluate " + model + " " + kReferences + ".libsvm").code, 0);
}

TEST(Import, LeavesNothingBehindWhenTheFileIsWrong) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "m.model", "svm_type c_svc\nkernel_type sigmoid\nSV\n");
  const std::string line = "import " + (folder / "m.model").string() + " --from libsvm --out ";
  const Outcome outcome = RunLine(line + (folder / "m").string());
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("m.model:3: kernel_type sigmoid"));
  EXPECT_EQ(NumEntries(folder.path()), 1U);
  EXPECT_EQ(RunLine(line + (folder / "m.model").string()).code, 2);
}

}  // namespace
}  // namespace handcraft::tools
