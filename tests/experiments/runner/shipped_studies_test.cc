// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/shipped_studies.h"

#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "experiments/runner/grid.h"
#include "experiments/runner/study_file.h"
#include "experiments/view_studies/view_study.h"
#include "lib/core/file.h"

namespace handcraft::experiments {
namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(HANDCRAFT_SOURCE_DIR) / "experiments/studies";

TEST(ShippedStudies, AreThoseOfTheFolderEachWithItsPage) {
  std::set<std::string> shipped;
  for (const ShippedStudy& study : ShippedStudies()) {
    const std::string name(study.name);
    shipped.insert(name);
    EXPECT_EQ(study.text, ReadTextFile(kFolder / name / "study.toml")) << name;
    EXPECT_TRUE(std::filesystem::exists(kFolder / name / "README.md")) << name;
  }
  std::set<std::string> there;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.is_directory()) there.insert(entry.path().filename().string());
  }
  EXPECT_EQ(shipped, there);
}

TEST(ShippedStudies, ParseInBothSizes) {
  for (const ShippedStudy& shipped : ShippedStudies()) {
    const std::string name(shipped.name);
    for (const StudySize size : {StudySize::kSmall, StudySize::kFull}) {
      if (IsViewStudy(shipped.text, name)) {
        const ViewStudy study = ParseViewStudy(shipped.text, name, size);
        EXPECT_EQ(study.name, name);
        EXPECT_GE(MakeViewCells(study).size(), 2U) << name;
        EXPECT_FALSE(study.question.empty()) << name;
        continue;
      }
      const Study study = ParseStudy(shipped.text, name, size);
      EXPECT_EQ(study.name, name);
      EXPECT_GE(MakeCells(study).size(), 2U) << name;
      EXPECT_FALSE(study.question.empty()) << name;
    }
  }
}

TEST(FindShippedStudy, FindsByName) {
  ASSERT_NE(FindShippedStudy("chapter3-trained-objects"), nullptr);
  EXPECT_EQ(FindShippedStudy("chapter3-trained-objects")->name, "chapter3-trained-objects");
  EXPECT_EQ(FindShippedStudy("chapter33"), nullptr);
}

}  // namespace
}  // namespace handcraft::experiments
