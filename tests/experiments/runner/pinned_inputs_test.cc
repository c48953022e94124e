// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/pinned_inputs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(PinnedInputs, TakesTheSameInputsAgain) {
  const testing::TemporaryDirectory folder;
  PinnedInputs(folder / "a/out").Pin("study", "x = 1\ny = 2\n");
  PinnedInputs(folder / "a/out").Pin("study", "x = 1\ny = 2\n");
  EXPECT_EQ(ReadTextFile(folder / "a/out/inputs/study"), "x = 1\ny = 2\n");
}

TEST(PinnedInputs, NamesTheInputAndTheLineThatChanged) {
  const testing::TemporaryDirectory folder;
  const PinnedInputs inputs(folder / "out");
  inputs.Pin("study", "x = 1\ny = 2\n");
  EXPECT_THROWS_MESSAGE(inputs.Pin("study", "x = 1\ny = 3\n"),
                        Error,
                        AllOf(HasSubstr("another input \"study\": y = 2, now y = 3"),
                              HasSubstr("give a new folder")));
  EXPECT_THROWS_MESSAGE(inputs.Pin("study", "x = 1\n"), Error, HasSubstr("y = 2, now (nothing)"));
  EXPECT_THROWS_MESSAGE(
      inputs.Pin("study", "x = 1\ny = 2\nz\n"), Error, HasSubstr("(nothing), now z"));
  EXPECT_EQ(ReadTextFile(folder / "out/inputs/study"), "x = 1\ny = 2\n");
}

TEST(PinnedInputs, RefusesFoldersOfOthers) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "letter.txt", "Dear");
  EXPECT_THROWS_MESSAGE(
      PinnedInputs(folder.path()), Error, HasSubstr("something else than the results of a study"));
  EXPECT_THROWS_MESSAGE(
      PinnedInputs(folder / "letter.txt"), Error, HasSubstr("cannot create the folder"));
}

}  // namespace
}  // namespace handcraft::experiments
