// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_data.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/experiments/runner/small_study.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

std::set<std::string> NamesOf(const datasets::LabelledImageSet& set) {
  std::set<std::string> names;
  for (const datasets::LabelledImage& item : set.items) names.insert(item.image);
  return names;
}

class StudyDataTest : public ::testing::Test {
 protected:
  StudyDataTest() { testing::WriteRoughSet(folder_ / "data"); }

  [[nodiscard]] StudyData Prepare(const Study& study) const {
    return PrepareStudyData(study, folder_ / "made", 1, {});
  }
  [[nodiscard]] CellData DivideFirst(const Study& study) const {
    return DivideForCell(study, Prepare(study), MakeCells(study).front());
  }

  testing::TemporaryDirectory folder_;
  Study study_ = testing::SmallStudy(folder_ / "data");
};

TEST_F(StudyDataTest, ReadsTheFoldersAndTheirFingerprints) {
  testing::WriteRoughSet(folder_ / "other", 2);
  study_.test = DataSource{.folder = (folder_ / "other").string()};
  const StudyData data = Prepare(study_);
  EXPECT_EQ(data.train.items.size(), 8U);
  EXPECT_EQ(data.train_fingerprint, datasets::Fingerprint(data.train));
  EXPECT_EQ(data.test_fingerprint, datasets::Fingerprint(*data.test));
  EXPECT_NE(data.train_fingerprint, data.test_fingerprint);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "made"));
}

TEST_F(StudyDataTest, MakesWhatIsToBeMadeAndKeepsIt) {
  study_.train = {.family = "novel", .num_images = 1, .seed = 3};
  const StudyData data = Prepare(study_);
  EXPECT_EQ(data.train.items.size(), 1U);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "made/train/manifest.csv"));
  EXPECT_EQ(Prepare(study_).train_fingerprint, data.train_fingerprint);
}

TEST_F(StudyDataTest, DividesByShareWithoutOverlap) {
  const CellData divided = DivideFirst(study_);
  EXPECT_EQ(divided.train[0].items.size(), 4U);
  EXPECT_EQ(divided.test.items.size(), 4U);
  for (const std::string& name : NamesOf(divided.test)) {
    EXPECT_EQ(NamesOf(divided.train[0]).count(name), 0U);
  }
}

TEST_F(StudyDataTest, DividesAnewForEachRepetition) {
  const StudyData data = Prepare(study_);
  const std::vector<Cell> cells = MakeCells(study_);
  const auto names = [&](const Cell& cell) {
    return NamesOf(DivideForCell(study_, data, cell).train[0]);
  };
  EXPECT_EQ(names(cells[0]), names(cells[0]));
  std::set<std::set<std::string>> different;
  Cell cell = cells[0];
  for (cell.seed = 1; cell.seed < 10; ++cell.seed) different.insert(names(cell));
  EXPECT_GT(different.size(), 1U);
}

TEST_F(StudyDataTest, DividesByClassOrByTheManifest) {
  study_.split = StudySplit::kClass;
  const CellData by_class = DivideFirst(study_);
  EXPECT_NE(by_class.train[0].items[0].object_class, by_class.test.items[0].object_class);
  study_.split = StudySplit::kManifest;
  const CellData by_manifest = DivideFirst(study_);
  EXPECT_EQ(NamesOf(by_manifest.train[0]),
            (std::set<std::string>{"p0.png", "p1.png", "p2.png", "p3.png"}));
}

TEST_F(StudyDataTest, HasObjectsOnBothSidesWhenDividedByPicture) {
  datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(folder_ / "data");
  for (datasets::LabelledImage& item : set.items) {
    item.instance = item.object_class;
    item.split = "unknown";
  }
  WriteManifest(set);
  study_.split = StudySplit::kPicture;
  const CellData divided = DivideFirst(study_);
  const auto instances = [](const datasets::LabelledImageSet& side) {
    std::set<std::string> names;
    for (const datasets::LabelledImage& item : side.items) names.insert(item.instance);
    return names;
  };
  EXPECT_EQ(instances(divided.train[0]), (std::set<std::string>{"even", "odd"}));
  EXPECT_EQ(instances(divided.test), (std::set<std::string>{"even", "odd"}));
}

TEST_F(StudyDataTest, TestsWithAllOfTheOtherPictures) {
  testing::WriteRoughSet(folder_ / "other", 2);
  study_.test = DataSource{.folder = (folder_ / "other").string()};
  EXPECT_EQ(DivideFirst(study_).train[0].items.size(), 4U);
  EXPECT_EQ(DivideFirst(study_).test.items.size(), 8U);
  study_.settings[1].value = "1";
  EXPECT_EQ(DivideFirst(study_).train[0].items.size(), 8U);
}

TEST_F(StudyDataTest, HasTheSameTrainingPicturesInEverySize) {
  study_.settings.push_back({"training_scales", "1+0.5"});
  const CellData divided = DivideFirst(study_);
  ASSERT_EQ(divided.train.size(), 2U);
  ASSERT_EQ(divided.train[1].items.size(), divided.train[0].items.size());
  for (std::size_t i = 0; i < divided.train[0].items.size(); ++i) {
    EXPECT_EQ(divided.train[1].items[i].instance, divided.train[0].items[i].instance);
    EXPECT_EQ(datasets::ReadLabelledPicture(divided.train[1], i).image.width(), 12);
  }
  EXPECT_TRUE(std::filesystem::exists(folder_ / "made/train_0.5/manifest.csv"));
}

TEST_F(StudyDataTest, NamesTheFolderThatIsMissing) {
  study_.train.folder = (folder_ / "absent").string();
  EXPECT_THROWS_MESSAGE(Prepare(study_), Error, ::testing::HasSubstr("absent"));
}

}  // namespace
}  // namespace handcraft::experiments
