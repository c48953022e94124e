// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/loaded_model.h"

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;

TEST(LoadModel, LoadsWhatWasTrained) {
  const TemporaryDirectory folder;
  testing::WriteTable(folder / "t.csv");
  testing::TrainLogistic(folder / "t.csv", folder / "m");
  const LoadedModel model = LoadModel(folder / "m");
  EXPECT_EQ(KindName(hc_model_kind(model.get())), "logistic");
  EXPECT_EQ(MetadataOf(model.get(), "hc.label_column"), "class");
  EXPECT_EQ(MetadataOf(model.get(), "hc.no_such_key"), "");
}

TEST(LoadModel, LoadsBytesAsItLoadsFiles) {
  const TemporaryDirectory folder;
  testing::WriteTable(folder / "t.csv");
  testing::TrainLogistic(folder / "t.csv", folder / "m");
  std::vector<std::uint8_t> bytes = ReadFile(folder / "m");
  EXPECT_EQ(MetadataOf(LoadModel(bytes).get(), "hc.label_column"), "class");
  bytes[bytes.size() / 2] ^= 1U;
  EXPECT_THROWS_MESSAGE(LoadModel(bytes), Error, HasSubstr("checksum"));
}

TEST(LoadModel, PassesOnTheRuntimesWordsAndOffset) {
  const TemporaryDirectory folder;
  EXPECT_THROWS_MESSAGE(LoadModel(folder / "missing"),
                        Error,
                        ::testing::EndsWith("missing: cannot open: No such file or directory"));
  WriteFileAtomically(folder / "empty", "");
  EXPECT_THROWS_MESSAGE(LoadModel(folder / "empty"), Error, HasSubstr("empty"));
  WriteFileAtomically(folder / "text", std::string(200, 'x'));
  EXPECT_THROWS_MESSAGE(LoadModel(folder / "text"), Error, HasSubstr(" at byte "));
}

}  // namespace
}  // namespace handcraft::tools
