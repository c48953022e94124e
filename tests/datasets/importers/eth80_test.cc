// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/eth80.h"

#include <map>
#include <string>

#include "datasets/importers/view_set_import.h"
#include "datasets/view_set_faults.h"
#include "tests/datasets/importers/importer_test.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class ListEth80Test : public ImporterTest {
 protected:
  void AddView(const fs::path& folder, const std::string& name) const {
    WriteImage(folder / (name + ".png"), 3, 1);
    Image map(3, 1, 3);
    for (int channel = 0; channel < 3; ++channel) map.At(1, 0, channel) = 255;
    WriteImage(folder / "maps" / (name + "-map.png"), map);
  }
  [[nodiscard]] std::string Refusal(const Eth80Options& options = {}) const {
    return RefusalOf([&] { return ListEth80(tree_, options); });
  }
};

TEST_F(ListEth80Test, ReadsATree) {
  AddView("cup3", "cup3-090-022");  // the folders of the original
  AddView("cup3", "cup3-090-338");
  AddView("cup3", "cup3-045-000");
  AddView("apple/1", "apple1-090-360");
  WriteText("cup3/notes.png", "not a view");
  const SourceSet source = ListEth80(tree_, {});
  ASSERT_THAT(source.pictures, SizeIs(3));
  EXPECT_EQ(source.pictures[0].instance, "apple1");
  EXPECT_EQ(source.pictures[0].angle_deg, 0.0);
  EXPECT_EQ(source.pictures[1].image, "cup3/cup3-090-022.png");
  EXPECT_EQ(source.pictures[1].object_class, "cup");
  EXPECT_EQ(source.pictures[1].instance, "cup3");
  EXPECT_EQ(source.pictures[1].angle_deg, 22.5);
  EXPECT_EQ(source.pictures[2].angle_deg, 337.5);
  EXPECT_EQ(source.pictures[1].make_mask(3, 1).values(), (std::vector<std::uint8_t>{0, 255, 0}));
  EXPECT_THAT(ListEth80(tree_, {.polar_deg = 45}).pictures, SizeIs(1));
}

TEST_F(ListEth80Test, GivesFlatCloudsWhenAsked) {
  AddView("cup3", "cup3-090-022");
  EXPECT_FALSE(ListEth80(tree_, {}).pictures.at(0).make_cloud);
  const SourceSet source = ListEth80(tree_, {.flat_clouds = true});
  const OrganisedCloud cloud = source.pictures.at(0).make_cloud(3, 1);
  EXPECT_TRUE(IsMeasured(cloud.At(1, 0)));
  EXPECT_FALSE(IsMeasured(cloud.At(0, 0)));
}

TEST_F(ListEth80Test, SaysWhatWasExpectedAndFound) {
  AddView("cup3", "cup3-090-022");
  EXPECT_THAT(Refusal({.polar_deg = 22}),
              HasSubstr("with PPP = 22 and its silhouette; angles PPP found: 90"));
  EXPECT_THAT(Refusal({.polar_deg = 91}), HasSubstr("Eth80Options.polar_deg is 91"));
  WriteImage("cup3/maps/cup3-090-022-map.png", 2, 2);
  EXPECT_THAT(Refusal(), HasSubstr("cup3-090-022-map.png: a colour at column 0, row 0"));
  fs::remove(tree_ / "cup3/maps/cup3-090-022-map.png");
  EXPECT_THAT(Refusal(), HasSubstr("cup3-090-022.png: left out: no silhouette maps/"));
  fs::remove(tree_ / "cup3/cup3-090-022.png");
  EXPECT_THAT(Refusal(), HasSubstr("angles PPP found: none"));
}

TEST_F(ListEth80Test, ReadsTheRealPictures) {
  const fs::path source = fs::path(HANDCRAFT_SOURCE_DIR) / "../shared/data/eth80/cup";
  if (!fs::exists(source)) GTEST_SKIP() << "the ETH-80 excerpt is not at " << source;
  SourceSet views = ListEth80(source, {});
  ASSERT_THAT(views.pictures, SizeIs(48));
  std::map<std::string, std::set<double>> angles;
  for (const SourcePicture& view : views.pictures) angles[view.instance].insert(*view.angle_deg);
  ASSERT_THAT(angles, SizeIs(3));
  for (const auto& [object, turns] : angles) {
    EXPECT_THAT(turns, SizeIs(16)) << object;
    for (const double turn : turns) EXPECT_EQ(std::fmod(turn, 22.5), 0.0) << object;
  }
  const ViewSet set = ImportViews(std::move(views), out_, {.max_images = 6});
  EXPECT_THAT(FindFaults(ReadViewSet(out_)), IsEmpty());
  EXPECT_THAT(set.items, SizeIs(6));
}

}  // namespace
}  // namespace handcraft::datasets
