// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"
#include "tests/tools/support/small_camera_file.h"

namespace handcraft::tools::testing {

/// A test of a kind of `handcraft data synth`, which makes its set in out_, below a folder of its
/// own, with a small camera.
class SynthTest : public ::testing::Test {
 protected:
  /// Runs it with these options, and with other keys in the camera's file if there are any.
  [[nodiscard]] Outcome Synth(const std::string& kind,
                              const std::string& options,
                              std::string_view camera_keys = "") const {
    return RunLine("data synth " + kind + " --out " + out_.string() + " --camera " +
                   CameraFile(folder_.path(), camera_keys) + " " + options);
  }

  handcraft::testing::TemporaryDirectory folder_;
  std::filesystem::path out_ = folder_ / "made";
};

}  // namespace handcraft::tools::testing
