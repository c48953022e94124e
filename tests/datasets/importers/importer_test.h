// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "datasets/importers/image_set_import.h"
#include "datasets/labelled_image_faults.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/datasets/small_image_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {

/// A test of an importer: a foreign tree in tree_, a place for what is made of it in out_.
class ImporterTest : public ::testing::Test {
 protected:
  /// Writes a picture below the tree, with the folders it lies in.
  void WriteImage(const std::filesystem::path& name, const Image& image) const {
    MakeFoldersOf(name);
    perception::WritePng(tree_ / name, image);
  }
  /// A picture of noise, another one for each name.
  void WriteImage(const std::filesystem::path& name, int width, int height) const {
    const std::uint64_t seed = std::hash<std::string>()(name.string());
    WriteImage(name, testing::NoiseImage(width, height, 3, seed));
  }
  void WriteText(const std::filesystem::path& name, std::string_view text) const {
    MakeFoldersOf(name);
    WriteFileAtomically(tree_ / name, text);
  }

  /// What the Error says that `list`, a function that returns a SourceSet, or the import of what it
  /// lists throws.
  template <class List>
  [[nodiscard]] std::string RefusalOf(const List& list) const {
    try {
      static_cast<void>(ImportPictures(list(), out_, {}));
    } catch (const Error& error) {
      return error.what();
    }
    return "(nothing was thrown)";
  }

  testing::TemporaryDirectory folder_;
  std::filesystem::path tree_ = folder_ / "tree";
  std::filesystem::path out_ = folder_ / "out";

 private:
  void MakeFoldersOf(const std::filesystem::path& name) const {
    std::filesystem::create_directories((tree_ / name).parent_path());
  }
};

}  // namespace handcraft::datasets
