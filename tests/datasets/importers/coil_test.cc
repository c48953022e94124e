// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/coil.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

#include "datasets/importers/view_set_import.h"
#include "datasets/view_set_faults.h"
#include "tests/datasets/importers/importer_test.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class ListCoilTest : public ImporterTest {
 protected:
  // A bright row on black, another one for each view.
  void AddView(const std::string& name) const {
    Image image(8, 4);
    const Image noise = testing::NoiseImage(8, 4, 1, std::hash<std::string>()(name));
    for (int u = 1; u < 7; ++u) image.At(u, 2) = static_cast<std::uint8_t>(noise.At(u, 0) / 2 + 99);
    image.At(0, 0) = 3;
    WriteImage(name, image);
  }
};

TEST_F(ListCoilTest, CountsStepsInCoil20) {
  for (const char* name : {"obj1__0.png", "obj1__71.png", "obj3__9.png"}) AddView(name);
  WriteText("obj1.txt", "not a view");
  const SourceSet source = ListCoil(tree_, {.threshold = 3});
  ASSERT_THAT(source.pictures, SizeIs(3));
  EXPECT_EQ(source.pictures[0].angle_deg, 0.0);
  EXPECT_EQ(source.pictures[1].angle_deg, 355.0);
  EXPECT_EQ(source.pictures[1].object_class, "obj1");
  EXPECT_EQ(source.pictures[2].instance, "obj3");
  EXPECT_EQ(source.pictures[2].angle_deg, 45.0);
  ImportViews(source, out_, {});
  EXPECT_THAT(FindFaults(ReadViewSet(out_)), IsEmpty());
  const Image mask = ReadObjectMask(ReadViewSet(out_), 0);
  EXPECT_EQ(mask.At(3, 2), kObject);
  EXPECT_EQ(mask.At(3, 1), kNoObject);
  EXPECT_EQ(mask.At(0, 0), kNoObject);
  EXPECT_EQ(ListCoil(tree_, {}).pictures[0].make_mask(8, 4).At(0, 0), kObject);
}

TEST_F(ListCoilTest, TakesNumbersForDegreesInCoil100) {
  for (const char* name : {"coil-100/obj1__0.png", "coil-100/obj1__355.png"}) AddView(name);
  const SourceSet source = ListCoil(tree_, {});
  ASSERT_THAT(source.pictures, SizeIs(2));
  EXPECT_EQ(source.pictures[1].angle_deg, 355.0);
  EXPECT_EQ(source.pictures[1].image, "coil-100/obj1__355.png");
}

// Pictures × rows × columns of bytes.
void WriteNpyPictures(const std::filesystem::path& path, std::size_t num_pictures) {
  const std::string header = "{'descr': '|u1', 'fortran_order': False, 'shape': (" +
                             std::to_string(num_pictures) + ", 2, 3), }";
  std::string text = std::string("\x93NUMPY\x01") + '\0';
  text.append({static_cast<char>(header.size()), '\0'}).append(header);
  for (std::size_t i = 0; i < num_pictures; ++i) {
    text.append(4, '\0').append({static_cast<char>(1 + i), '\0'});
  }
  WriteFileAtomically(path, text);
}

TEST_F(ListCoilTest, ReadsAnArrayOfPictures) {
  const std::filesystem::path path = folder_ / "coil20.npy";
  WriteNpyPictures(path, 144);
  const SourceSet source = ListCoil(path, {.threshold = 0});
  ASSERT_THAT(source.pictures, SizeIs(144));
  EXPECT_EQ(source.pictures[71].instance, "obj1");
  EXPECT_EQ(source.pictures[71].angle_deg, 355.0);
  EXPECT_EQ(source.pictures[74].image, "obj2__2.png");
  EXPECT_EQ(source.pictures[74].angle_deg, 10.0);
  const ViewSet set = ImportViews(source, out_, {});
  EXPECT_THAT(FindFaults(set), IsEmpty());
  const LoadedView view = ReadView(set, 74);
  EXPECT_EQ(view.image.At(1, 1), 75);
  EXPECT_EQ(view.object_mask.At(1, 1), kObject);
  EXPECT_EQ(view.object_mask.At(0, 1), kNoObject);
  const SourceSet with_clouds = ListCoil(path, {.flat_clouds = true});
  EXPECT_TRUE(IsMeasured(with_clouds.pictures[74].make_cloud(3, 2).At(1, 1)));
  WriteNpyPictures(path, 100);
  EXPECT_THAT(RefusalOf([&] { return ListCoil(path, {}); }),
              HasSubstr("coil20.npy: 100 pictures; 72 of each object are due"));
  WriteFileAtomically(path, "");
  EXPECT_THAT(RefusalOf([&] { return ListCoil(path, {}); }), HasSubstr("coil20.npy at byte 0: "));
}

// Two objects of the real pictures: a duck and a block, which turn.
TEST_F(ListCoilTest, ReadsTheRealArray) {
  const std::filesystem::path path = std::filesystem::path(HANDCRAFT_SOURCE_DIR) /
                                     "../shared/data/coil20_32x32/coil20_u8_1440x32x32.npy";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "COIL-20 is not at " << path;
  SourceSet source = ListCoil(path, {});
  ASSERT_THAT(source.pictures, SizeIs(1440));
  EXPECT_EQ(source.pictures.back().instance, "obj20");
  source.pictures.resize(144);
  const ViewSet set = ImportViews(std::move(source), out_, {.test_share = 0.0, .max_images = 12});
  EXPECT_THAT(FindFaults(set), IsEmpty());
  EXPECT_EQ(ReadView(set, 0).image.width(), 32);
}

TEST_F(ListCoilTest, SaysWhatWasExpected) {
  WriteText("a.png", "");
  EXPECT_THAT(RefusalOf([&] { return ListCoil(tree_, {}); }), HasSubstr("no objN__K.png in it"));
  EXPECT_THAT(RefusalOf([&] { return ListCoil(tree_, {.threshold = 256}); }),
              HasSubstr("CoilOptions.threshold is 256; it must be from 0 to 255"));
}

}  // namespace
}  // namespace handcraft::datasets
