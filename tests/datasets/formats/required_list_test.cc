// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/required_list.h"

#include "datasets/formats/listing_rules.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

TEST(RequireList, SaysWhatAFolderIsInstead) {
  const TemporaryDirectory folder;
  const auto refuses = [&](const std::filesystem::path& root, const std::string& message) {
    EXPECT_THROWS_MESSAGE((RequireList(root, kManifestFileName, "a labelled image set"), 0),
                          Error,
                          HasSubstr(message));
  };
  RequireList(folder / "no", kManifestFileName, "a labelled image set");  // opening it will tell
  refuses(folder.path(), "no manifest.csv in this folder: not a labelled image set (see docs");
  WriteFileAtomically(folder / "dataset.toml", "");
  refuses(folder.path(), "no manifest.csv in this folder: handcraft data synth has not finished");
  WriteFileAtomically(folder / "views.csv", "");
  refuses(folder.path(), "no manifest.csv in this folder but views.csv: not a labelled image set");
  refuses(folder / "views.csv", "views.csv: is a file (give the folder of the data set)");
  WriteFileAtomically(folder / "manifest.csv", "");
  RequireList(folder.path(), kManifestFileName, "a labelled image set");
}

}  // namespace
}  // namespace handcraft::datasets
