// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "lib/model_io/model_writer.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
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
  EXPECT_THAT(
      logistic.err,
      AllOf(HasSubstr(model), HasSubstr("of kind logistic"), HasSubstr("handcraft train svm")));
  const std::string clouds = (folder / "clouds").string();
  WriteFileAtomically(clouds, model_io::Serialise(handcraft::testing::SomeObjectClassModel()));
  const Outcome object_class = RunLine("export " + clouds + " --to libsvm" + out);
  EXPECT_EQ(object_class.code, 3);
  EXPECT_THAT(object_class.err, AllOf(HasSubstr(clouds), HasSubstr("cannot describe a cloud")));
  EXPECT_EQ(RunLine("export " + model + " --to onnx" + out).code, 2);
  EXPECT_EQ(RunLine("export " + model + " --to libsvm --out " + model).code, 2);
  ASSERT_EQ(RunLine("train svm " + kBreast + " --label class --standardize --out " + model).code,
            0);
  EXPECT_THAT(RunLine("export " + model + " --to libsvm" + out).err,
              AllOf(HasSubstr(model), HasSubstr("train it without --standardize")));
}

TEST(Export, SaysWhichNamesAreLostAndImportTakesThemBack) {
  const TemporaryDirectory folder;
  const std::string model = (folder / "m").string();
  const std::string text = (folder / "t").string();
  const std::string again = (folder / "again").string();
  // The last column is 0 everywhere: libsvm leaves it out.
  std::string rows = "length,width,none,object\n";
  for (int i = 1; i < 9; ++i) {
    const std::string off = std::to_string(i);
    rows.append(off).append(",1,0,mug\n").append(off).append(",9,0,can\n");
  }
  WriteFileAtomically(folder / "t.csv", rows);
  const std::string table = (folder / "t.csv").string();
  ASSERT_EQ(RunLine("train svm " + table + " --label object --out " + model).code, 0);
  const Outcome exported = RunLine("export " + model + " --to libsvm --out " + text);
  ASSERT_EQ(exported.code, 0) << exported.err;
  EXPECT_THAT(exported.err,
              AllOf(HasSubstr("warning: libsvm's text holds no names"),
                    HasSubstr("--columns 'length,width,none' --classes 'mug,can' "
                              "--label 'object'")));
  const std::string import = "import " + text + " --from libsvm --out " + again;
  ASSERT_EQ(RunLine(import).code, 0);
  EXPECT_NE(RunLine("evaluate " + again + " " + table).code, 0);
  ASSERT_EQ(RunLine(import + " --columns length,width,none --classes mug,can --label object").code,
            0);
  const Outcome first = RunLine("evaluate " + model + " " + table + " --json");
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(RunLine("evaluate " + again + " " + table + " --json").out, first.out);
  const Outcome few = RunLine(import + " --columns length");
  EXPECT_EQ(few.code, 2);
  EXPECT_THAT(few.err, HasSubstr("1 columns are named; the support vectors have 2"));
  EXPECT_THAT(RunLine(import + " --classes mug").err,
              HasSubstr("1 classes are named; the model has 2"));
}

}  // namespace
}  // namespace handcraft::tools
