// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/loaded_model.h"

#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/model_io/linear_models.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;

std::vector<std::uint8_t> LogisticModelBytes() {
  return model_io::Serialise(model_io::MakeLogisticModel(
      {"a", "b"}, "class", "no", "yes", {.weights = {1.0, -2.0}, .intercept = 0.5}, {}));
}

TEST(LoadModel, LoadsWhatWasWritten) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "m", LogisticModelBytes());
  const LoadedModel model = LoadModel(folder / "m");
  EXPECT_EQ(KindName(hc_model_kind(model.get())), "logistic");
  EXPECT_EQ(MetadataOf(model.get(), "hc.label_column"), "class");
  EXPECT_EQ(MetadataOf(model.get(), "hc.no_such_key"), "");
}

TEST(LoadModel, LoadsBytesAsItLoadsFiles) {
  std::vector<std::uint8_t> bytes = LogisticModelBytes();
  EXPECT_EQ(MetadataOf(LoadModel(bytes).get(), "hc.label_column"), "class");
  bytes[bytes.size() / 2] ^= 1U;
  EXPECT_THROWS_MESSAGE(LoadModel(bytes), Error, HasSubstr("checksum"));
}

TEST(LoadModel, PassesOnTheRuntimesWordsAndOffset) {
  const testing::TemporaryDirectory folder;
  EXPECT_THROWS_MESSAGE(LoadModel(folder / "missing"),
                        Error,
                        ::testing::EndsWith("missing: cannot open: No such file or directory"));
  WriteFileAtomically(folder / "empty", "");
  EXPECT_THROWS_MESSAGE(LoadModel(folder / "empty"), Error, HasSubstr("empty"));
  WriteFileAtomically(folder / "text", std::string(200, 'x'));
  EXPECT_THROWS_MESSAGE(LoadModel(folder / "text"), Error, HasSubstr(" at byte "));
}

}  // namespace
}  // namespace handcraft::experiments
