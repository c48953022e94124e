// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/scene_file.h"

#include <string>

#include <gmock/gmock.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/datasets/small_scene_file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

class CheckSceneFileTest : public ::testing::Test {
 protected:
  void Check(const std::string& text) const {
    WriteFileAtomically(folder_ / "a.toml", text);
    CheckSceneFile(folder_ / "a.toml");
  }

  void Refuses(const std::string& text, const std::string& message) const {
    EXPECT_THROWS_MESSAGE((Check(text), 0), Error, HasSubstr("a.toml" + message));
  }

  // The sound file with `now` in the place of `before`.
  void RefusesWith(const std::string& before,
                   const std::string& now,
                   const std::string& message) const {
    std::string text(testing::kSmallSceneFile);
    const std::size_t at = text.find(before);
    ASSERT_NE(at, std::string::npos) << before;
    Refuses(text.replace(at, before.size(), now), message);
  }

  TemporaryDirectory folder_;
};

TEST_F(CheckSceneFileTest, PassesWhatTellsThePoses) {
  const std::string sound(testing::kSmallSceneFile);
  Check(sound);
  Check("angle_deg = 30\n" + sound + "\n[files]\nsha256 = \"0\"\n");
  Check(sound + sound.substr(sound.find("\n[[objects]]")));
}

TEST_F(CheckSceneFileTest, RefusesWhatIsEmptyOrNoToml) {
  Refuses("", ": the file is empty");
  Refuses("\n# nothing\n", ": the file is empty");
  Refuses("class = \"mug\"\nx\n", ":2: not TOML: ");
  EXPECT_THROWS_MESSAGE(
      (CheckSceneFile(folder_ / "gone.toml"), 0), Error, HasSubstr("gone.toml: cannot open"));
}

TEST_F(CheckSceneFileTest, NamesWhatIsMissing) {
  Refuses("x = 1\n", ":1: no class (see docs/datasets.md, Scene)");
  RefusesWith("instance = 3\n", "", ":1: no instance (see");
  RefusesWith("[camera]", "[Camera]", ": no table [camera] (see");
  RefusesWith(
      "base_from_camera_position", "position", ":4: no base_from_camera_position_m in [cam");
  RefusesWith(
      "base_from_camera_quat", "quat", ":4: no base_from_camera_quaternion_xyzw in [camera]");
  RefusesWith("[[objects]]", "[[targets]]", ": no table [[objects]] (see");
  RefusesWith(
      "base_from_object_quat", "q", ":8: no base_from_object_quaternion_xyzw in one of [[obj");
}

TEST_F(CheckSceneFileTest, NamesTheLineOfWhatIsNoPose) {
  RefusesWith("\"mug\"", "1", ":1: class is no text");
  RefusesWith("= 3", "= -1", ":2: instance is no whole number from 0 on");
  RefusesWith("[0, 0, 0.5]", "[0, 0]", ":5: base_from_camera_position_m is no list of 3 finite");
  RefusesWith("[0, 0, 0.5]", "[0, 0, 0, 0]", ":5: base_from_camera_position_m is no list of 3");
  RefusesWith("[0, 0, 0.5]", "[0, nan, 0]", ":5: base_from_camera_position_m is no list of 3");
  RefusesWith("[0, 0, 0.5]", "[0, true, 0]", ":5: base_from_camera_position_m is no list of 3");
  RefusesWith("[0, 0, 0.5]", "0.5", ":5: base_from_camera_position_m is no list of 3");
  RefusesWith("0.6, 0.8", "0.6, 0.6", ":10: base_from_object_quaternion_xyzw has length 0.8485");
  RefusesWith("[[objects]]", "[objects]", ": no table [[objects]]");
}

// Law: wherever a scene is cut, it is refused, or all its poses are there.
TEST_F(CheckSceneFileTest, RefusesEveryTruncation) {
  const std::string sound(testing::kSmallSceneFile);
  for (std::size_t size = 0; size + 1 < sound.size(); ++size) {
    EXPECT_THROW(Check(sound.substr(0, size)), Error) << size;
  }
}

}  // namespace
}  // namespace handcraft::datasets
