// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/coil.h"

#include <string>

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

TEST_F(ListCoilTest, SaysWhatWasExpected) {
  WriteText("a.png", "");
  EXPECT_THAT(RefusalOf([&] { return ListCoil(tree_, {}); }), HasSubstr("no objN__K.png in it"));
  EXPECT_THAT(RefusalOf([&] { return ListCoil(tree_, {.threshold = 256}); }),
              HasSubstr("CoilOptions.threshold is 256; it must be from 0 to 255"));
}

}  // namespace
}  // namespace handcraft::datasets
