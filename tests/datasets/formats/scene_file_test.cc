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

class ReadSceneFileTest : public ::testing::Test {
 protected:
  [[nodiscard]] SceneRecord Read(const std::string& text) const {
    WriteFileAtomically(folder_ / "a.toml", text);
    return ReadSceneFile(folder_ / "a.toml");
  }

  void Refuses(const std::string& text, const std::string& message) const {
    EXPECT_THROWS_MESSAGE(static_cast<void>(Read(text)), Error, HasSubstr("a.toml" + message));
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

TEST_F(ReadSceneFileTest, TellsThePosesAndPassesOverOtherKeys) {
  const std::string sound(testing::kSmallSceneFile);
  const SceneRecord scene = Read("angle_deg = 30\n" + sound + "\n[files]\nsha256 = \"0\"\n");
  EXPECT_EQ(scene.object_class, "mug");
  EXPECT_EQ(scene.instance, 3);
  EXPECT_EQ(scene.base_from_camera.translation(), Eigen::Vector3d(0.0, 0.0, 0.5));
  EXPECT_TRUE((scene.base_from_camera * Eigen::Vector3d(1.0, 2.0, 3.0))
                  .isApprox(Eigen::Vector3d(1.0, -2.0, -2.5)));
  ASSERT_EQ(scene.base_from_objects.size(), 1U);
  const Eigen::Isometry3d& object = scene.base_from_objects.front();
  EXPECT_EQ(object.translation(), Eigen::Vector3d(0.25, 1e-3, 0.0));
  EXPECT_TRUE(object.linear().col(0).isApprox(Eigen::Vector3d(0.28, 0.96, 0.0)));
  EXPECT_EQ(Read(sound + sound.substr(sound.find("\n[[objects]]"))).base_from_objects.size(), 2U);
}

TEST_F(ReadSceneFileTest, AScaleMayBeMissing) {
  const std::string sound(testing::kSmallSceneFile);
  EXPECT_EQ(Read(sound).scale, 1.0);
  EXPECT_EQ(Read("scale = 1.25\n" + sound).scale, 1.25);
  for (const char* wrong : {"0", "-1.0", "inf", "true", "\"1\""}) {
    Refuses("scale = " + std::string(wrong) + "\n" + sound, ":1: scale is no number above 0");
  }
}

TEST_F(ReadSceneFileTest, RefusesWhatIsEmptyOrNoToml) {
  Refuses("", ": the file is empty");
  Refuses("\n# nothing\n", ": the file is empty");
  Refuses("class = \"mug\"\nx\n", ":2: not TOML: ");
  EXPECT_THROWS_MESSAGE(static_cast<void>(ReadSceneFile(folder_ / "gone.toml")),
                        Error,
                        HasSubstr("gone.toml: cannot open"));
}

TEST_F(ReadSceneFileTest, NamesWhatIsMissing) {
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

TEST_F(ReadSceneFileTest, NamesTheLineOfWhatIsNoPose) {
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
TEST_F(ReadSceneFileTest, RefusesEveryTruncation) {
  const std::string sound(testing::kSmallSceneFile);
  for (std::size_t size = 0; size + 1 < sound.size(); ++size) {
    EXPECT_THROW(static_cast<void>(Read(sound.substr(0, size))), Error) << size;
  }
}

}  // namespace
}  // namespace handcraft::datasets
