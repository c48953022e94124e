// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.h"

namespace handcraft::tools::testing {

/// A labelled image set of six noisy 64 × 48 pictures (four "train", two "test", classes "bar" and
/// "disc"), each with one bright object whose middle is good. Easy, but not separable.
void WriteImageSet(const std::filesystem::path& folder, int channels = 3);

/// A test with such a set in set_, in a folder of its own.
class ImageSetTest : public ::testing::Test {
 protected:
  void SetUp() override { WriteImageSet(set_); }

  handcraft::testing::TemporaryDirectory folder_;
  std::filesystem::path set_ = folder_ / "set";
};

/// A table "x1,x2,class" of 60 rows, labels "no" and "yes", not separable.
void WriteTable(const std::filesystem::path& path);

/// Trains on such an image set, in half a second, and writes the model.
void TrainGraspPoints(const std::filesystem::path& dataset,
                      const std::filesystem::path& model,
                      const std::string& features = "filters=laws+edges,window=1,energy=log");

/// Trains on such a table.
void TrainLogistic(const std::filesystem::path& table, const std::filesystem::path& model);

/// Number of files and folders directly in a folder.
[[nodiscard]] std::size_t NumEntries(const std::filesystem::path& folder);

}  // namespace handcraft::tools::testing
