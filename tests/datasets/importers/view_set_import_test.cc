// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/view_set_import.h"

#include <string>
#include <utility>
#include <vector>

#include "datasets/view_set_faults.h"
#include "tests/datasets/importers/importer_test.h"

namespace handcraft::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

OrganisedCloud Flat(int width, int height) {
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {.width = width,
          .height = height,
          .points = std::vector<Eigen::Vector3f>(count, Eigen::Vector3f(0.5F, 0, 0.1F))};
}

class ImportViewsTest : public ImporterTest {
 protected:
  [[nodiscard]] SourceSet Source() const {
    SourceSet source;
    for (const std::string name : {"cup/a", "cup/b"}) {
      WriteImage(name + ".png", 4, 3);
      source.pictures.push_back(
          {.path = tree_ / (name + ".png"),
           .image = name + ".png",
           .mask = name + ".png",
           .object_class = "cup",
           .instance = name,
           .make_mask = [](int width, int height) { return Image(width, height, 1, kObject); }});
    }
    source.pictures[0].angle_deg = 22.5;
    source.pictures[0].make_cloud = Flat;
    return source;
  }
};

TEST_F(ImportViewsTest, WritesASetWithoutFaults) {
  const ViewSet set = ImportViews(Source(), out_, {.licence = "CC0-1.0", .num_threads = 2});
  ASSERT_THAT(set.items, SizeIs(2));
  EXPECT_EQ(set.items[0].image, "images/cup/a.png");
  EXPECT_EQ(set.items[0].object_mask, "object_masks/cup/a.png");
  EXPECT_EQ(set.items[0].cloud, "clouds/cup/a.pcd");
  EXPECT_EQ(set.items[1].cloud, "");
  const ViewSet again = ReadViewSet(out_);
  EXPECT_THAT(FindFaults(again), IsEmpty());
  EXPECT_EQ(again.items[0].angle_deg, 22.5);
  EXPECT_EQ(again.items[1].angle_deg, std::nullopt);
  EXPECT_EQ(again.items[0].split, "train");
  EXPECT_EQ(again.items[1].split, "test");
  EXPECT_EQ(again.items[0].licence, "CC0-1.0");
  EXPECT_EQ(ReadFile(out_ / "images/cup/a.png"), ReadFile(tree_ / "cup/a.png"));
  const LoadedView view = ReadView(again, 0);
  ASSERT_TRUE(view.cloud);
  EXPECT_TRUE(view.cloud->At(3, 2).isApprox(Eigen::Vector3f(0.5F, 0, 0.1F)));
}

TEST_F(ImportViewsTest, LeavesOutAViewWithoutAnObject) {
  SourceSet source = Source();
  source.pictures[1].make_mask = [](int width, int height) { return Image(width, height); };
  std::vector<std::string> told;
  const auto tell = [&](const Fault& note) { told.push_back(note.path + ": " + note.reason); };
  const ViewSet set = ImportViews(std::move(source), out_, {.on_note = tell});
  EXPECT_THAT(told,
              ElementsAre((tree_ / "cup/b.png").string() +
                          ": left out: no object is seen: its mask has no pixel of one"));
  EXPECT_THAT(set.items, SizeIs(1));
  EXPECT_THAT(FindFaults(ReadViewSet(out_)), IsEmpty());
  EXPECT_FALSE(std::filesystem::exists(out_ / "images/cup/b.png"));
  source = Source();
  for (SourcePicture& picture : source.pictures) {
    picture.make_mask = [](int width, int height) { return Image(width, height); };
  }
  EXPECT_THROWS_MESSAGE(ImportViews(source, folder_ / "none", {}),
                        Error,
                        HasSubstr("cup/a.png: no object is seen in this view nor in the others"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none"));
}

TEST_F(ImportViewsTest, LeavesNothingBehindOnFailure) {
  SourceSet source = Source();
  source.pictures[1].make_cloud = [](int width, int height) { return Flat(height, width); };
  EXPECT_THROWS_MESSAGE(ImportViews(source, out_, {}),
                        Error,
                        HasSubstr("cup/b.png: the cloud is 3x4 pixels, its picture 4x3"));
  source = Source();
  source.pictures[1].make_mask = [](int, int) { return Image(1, 1); };
  EXPECT_THROWS_MESSAGE(
      ImportViews(source, out_, {}), Error, HasSubstr("cup/b.png: the object mask is 1x1 pixels"));
  EXPECT_FALSE(std::filesystem::exists(out_));
}

}  // namespace
}  // namespace handcraft::datasets
