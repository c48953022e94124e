// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/labelled_image_set.h"

#include <algorithm>
#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "tests/datasets/small_image_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using testing::AddPicture;
using testing::CountedMask;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::NoiseImage;
using ::testing::Pair;
using ::testing::SizeIs;
using ::testing::StartsWith;
using testing::TemporaryDirectory;

constexpr std::string_view kHeader = "image,mask,class,instance,split,licence\n";

LabelledImageSet ReadManifest(std::string_view text) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "manifest.csv", text);
  return ReadLabelledImageSet(folder.path());
}

LabelledImageSet ReadRows(const std::string& rows) {
  return ReadManifest(std::string(kHeader) + rows);
}

// Two sound pictures in "train", one in "test".
LabelledImageSet MakeSet(const std::filesystem::path& root) {
  LabelledImageSet set{.root = root, .items = {}};
  AddPicture(set, "a", NoiseImage(8, 6, 3, 1), CountedMask(8, 6, 5, 7));
  AddPicture(set, "b", NoiseImage(8, 6, 1, 2), CountedMask(8, 6, 1, 1));
  AddPicture(set, "c", NoiseImage(4, 4, 3, 3), CountedMask(4, 4, 2, 2), "test");
  WriteManifest(set);
  return set;
}

TEST(ReadLabelledImageSet, ReadsAManifest) {
  const LabelledImageSet set = ReadRows("i/1.png,m/1.png,mug,mug_1,train,CC0-1.0\n");
  ASSERT_THAT(set.items, SizeIs(1));
  EXPECT_EQ(set.items[0].image, "i/1.png");
  EXPECT_EQ(set.items[0].mask, "m/1.png");
  EXPECT_EQ(set.items[0].object_class, "mug");
  EXPECT_EQ(set.items[0].instance, "mug_1");
  EXPECT_EQ(set.items[0].split, "train");
  EXPECT_EQ(set.items[0].licence, "CC0-1.0");
}

TEST(ReadLabelledImageSet, TakesColumnsInAnyOrderAndIgnoresOthers) {
  const LabelledImageSet set = ReadManifest(
      "\xEF\xBB\xBFsplit,note,licence,instance,class,mask,image\r\n"
      "test,\"a, b\",,7,mug,m.png,i.png\r\n");
  ASSERT_THAT(set.items, SizeIs(1));
  EXPECT_EQ(set.items[0].image, "i.png");
  EXPECT_EQ(set.items[0].split, "test");
  EXPECT_EQ(set.items[0].licence, "");
}

TEST(ReadLabelledImageSet, NamesWhatIsWrongWithTheManifest) {
  const TemporaryDirectory empty;
  EXPECT_THROWS_MESSAGE(
      ReadLabelledImageSet(empty.path()), Error, HasSubstr("not a labelled image set"));
  EXPECT_THROWS_MESSAGE(ReadLabelledImageSet("no/such"), Error, HasSubstr("No such file"));
  EXPECT_THROWS_MESSAGE(ReadManifest(""), Error, HasSubstr("manifest.csv: the file is empty"));
  EXPECT_THROWS_MESSAGE(ReadManifest(kHeader), Error, HasSubstr("no image is listed"));
  EXPECT_THROWS_MESSAGE(ReadManifest("image,class,instance,split,licence\n"),
                        Error,
                        HasSubstr("manifest.csv:1: no column 'mask'"));
  EXPECT_THROWS_MESSAGE(ReadManifest("image,image,mask,class,instance,split,licence\n"),
                        Error,
                        HasSubstr("'image' appears twice"));
  EXPECT_THROWS_MESSAGE(
      ReadRows("i,m,c,1,train\n"), Error, HasSubstr(":2: 5 fields; the first line has 6"));
  EXPECT_THROWS_MESSAGE(ReadRows("i,m,c,1,,x\n"), Error, HasSubstr(":2: no split given"));
}

TEST(ReadLabelledImageSet, KeepsPathsInsideTheFolder) {
  for (const std::string bad : {"../i.png", "a/../../i.png", "/etc/passwd", "a/.."}) {
    EXPECT_THROWS_MESSAGE(ReadRows(bad + ",m.png,c,1,train,\n"),
                          Error,
                          HasSubstr(":2: the image '" + bad + "' lies outside the folder"));
    EXPECT_THROWS_MESSAGE(
        ReadRows("i.png," + bad + ",c,1,train,\n"), Error, HasSubstr("the mask '" + bad));
  }
  EXPECT_THAT(ReadRows("a..b/i..png,./m.png,c,1,train,\n").items, SizeIs(1));
}

TEST(ReadLabelledImageSet, NamesTheLineThatIsNotUtf8) {
  EXPECT_THROWS_MESSAGE(ReadRows("a,b,mug,m1,train,x\nc,d,gr\xF6\xDF"
                                 "e,m2,train,x\n"),
                        Error,
                        HasSubstr("manifest.csv:3: not UTF-8 text"));
}

TEST(ReadLabelledImageSet, RefusesAnImageTwice) {
  EXPECT_THROWS_MESSAGE(
      ReadRows("a.png,m.png,c,1,train,\nb.png,m.png,c,1,train,\n./a.png,n.png,c,1,train,\n"),
      Error,
      HasSubstr(":4: the image './a.png' stands on line 2 already"));
}

TEST(ReadLabelledImageSet, RefusesAnInstanceInTwoSplits) {
  EXPECT_THROWS_MESSAGE(
      ReadRows("a,m,c,mug 1,train,\nb,m,c,mug 2,test,\nc,m,c,mug 1,test,\n"),
      Error,
      HasSubstr(":4: instance 'mug 1' is in split 'test' here and in 'train' on line 2"));
}

TEST(ReadLabelledImageSet, KeepsOtherColumns) {
  const LabelledImageSet set = ReadManifest(
      "depth,note,image,mask,class,instance,split,licence,,\n"
      "d/1.png,\"a, b\",i.png,m.png,mug,7,test,,x,y\n"
      ",,j.png,n.png,mug,7,test,,,\n");
  EXPECT_THAT(set.items[0].others, ElementsAre(Pair("depth", "d/1.png"), Pair("note", "a, b")));
  EXPECT_EQ(set.items[0].Companion(kDepth), "d/1.png");
  EXPECT_EQ(set.items[0].Companion(kCloud), "");
  EXPECT_THAT(set.items[1].others, IsEmpty());
  EXPECT_THROWS_MESSAGE(ReadManifest("image,mask,class,instance,split,licence,scene\n"
                                     "i,m,c,1,train,,../s.toml\n"),
                        Error,
                        HasSubstr(":2: the scene '../s.toml' lies outside the folder"));
  EXPECT_THROWS_MESSAGE(ReadManifest("image,mask,class,instance,split,licence,note,note\n"),
                        Error,
                        HasSubstr("'note' appears twice"));
}

TEST(WriteManifest, ComesBackUnchanged) {
  const TemporaryDirectory folder;
  LabelledImageSet set{.root = folder.path(), .items = {}};
  set.items.push_back(
      {"a, \"b\".png", "m\n.png", "größe", "1", "train", "see \"LICENCE\", please"});
  set.items.push_back({"c.png", "d.png", "x", "2", "hold out", ""});
  set.items[0].others = {{"a note", "x,y"}, {"scene", "s.toml"}, {"object_mask", "o.png"}};
  WriteManifest(set);
  EXPECT_THAT(ReadTextFile(folder / "manifest.csv"),
              StartsWith("image,mask,class,instance,split,licence,object_mask,scene,a note\n"));
  const LabelledImageSet read = ReadLabelledImageSet(folder.path());
  ASSERT_THAT(read.items, SizeIs(2));
  EXPECT_EQ(read.items[0].image, set.items[0].image);
  EXPECT_EQ(read.items[0].mask, set.items[0].mask);
  EXPECT_EQ(read.items[0].object_class, set.items[0].object_class);
  EXPECT_EQ(read.items[0].licence, set.items[0].licence);
  EXPECT_EQ(read.items[1].split, "hold out");
  EXPECT_EQ(read.items[0].others, set.items[0].others);
  EXPECT_THAT(read.items[1].others, IsEmpty());
}

TEST(LabelledImageSet, ChoosesASplit) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  EXPECT_THAT(set.Only("").items, SizeIs(3));
  const LabelledImageSet train = set.Only("train");
  ASSERT_THAT(train.items, SizeIs(2));
  EXPECT_EQ(train.items[1].image, "b.png");
  EXPECT_EQ(train.root, set.root);
  EXPECT_THROWS_MESSAGE(set.Only("validation"),
                        Error,
                        HasSubstr("no split 'validation'; there are: 'test', 'train'"));
}

TEST(ReadLabelledPicture, ReadsPictureAndMask) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  const LabelledPicture picture = ReadLabelledPicture(set, 0);
  EXPECT_EQ(picture.image.values(), NoiseImage(8, 6, 3, 1).values());
  EXPECT_EQ(picture.mask.values(), CountedMask(8, 6, 5, 7).values());
  EXPECT_EQ(ReadMask(set, 0).values(), picture.mask.values());
  EXPECT_THROW(static_cast<void>(ReadLabelledPicture(set, 3)), std::logic_error);
}

TEST(ReadLabelledPicture, NamesWhatIsWrongWithTheMask) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  perception::WritePng(folder / "a_mask.png", CountedMask(6, 8, 5, 7));
  EXPECT_THROWS_MESSAGE(ReadLabelledPicture(set, 0),
                        Error,
                        HasSubstr("a_mask.png: the mask is 6x8 pixels, its picture 8x6"));
  Image smoothed = CountedMask(8, 6, 5, 7);
  smoothed.At(3, 2) = 254;
  perception::WritePng(folder / "a_mask.png", smoothed);
  EXPECT_THROWS_MESSAGE(ReadLabelledPicture(set, 0),
                        Error,
                        HasSubstr("a_mask.png: value 254 at column 3, row 2; 255 (good)"));
  perception::WritePng(folder / "a_mask.png", NoiseImage(8, 6, 3, 1));
  EXPECT_THROWS_MESSAGE(ReadLabelledPicture(set, 0), Error, HasSubstr("a colour picture"));
  std::filesystem::remove(folder / "a_mask.png");
  EXPECT_THROWS_MESSAGE(ReadLabelledPicture(set, 0), Error, HasSubstr("a_mask.png: cannot open"));
  WriteFileAtomically(folder / "a_mask.png", "");
  EXPECT_THROWS_MESSAGE(
      ReadLabelledPicture(set, 0), Error, HasSubstr("a_mask.png: the file is empty"));
}

TEST(LicencesOf, NamesEachOnce) {
  const LabelledImageSet set = ReadRows(
      "i/1.png,m/1.png,mug,a,train,MIT\ni/2.png,m/2.png,mug,b,train,CC0-1.0\n"
      "i/3.png,m/3.png,mug,c,train,MIT\n");
  EXPECT_THAT(LicencesOf(set), ElementsAre("CC0-1.0", "MIT"));
}

TEST(Fingerprint, IsTheHashOfTheDocumentedText) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path()).Only("test");
  const auto digest = [&](const char* name) { return Sha256Hex(ReadFile(folder / name)); };
  std::string text = "c.png";
  for (const std::string& part :
       {digest("c.png"), digest("c_mask.png"), std::string("object"), std::string("c")}) {
    text.append(1, '\0').append(part);
  }
  text.append(1, '\0').append("test\n");
  Sha256 hash;
  hash.Update(text);
  EXPECT_EQ(Fingerprint(set), hash.HexDigest());
}

TEST(Fingerprint, DependsOnTheDataAlone) {
  const TemporaryDirectory here;
  const TemporaryDirectory there;
  LabelledImageSet set = MakeSet(here.path());
  const std::string fingerprint = Fingerprint(set);
  EXPECT_EQ(Fingerprint(MakeSet(there.path())), fingerprint) << "the folder does not matter";
  std::reverse(set.items.begin(), set.items.end());
  set.items[0].licence = "other";
  EXPECT_EQ(Fingerprint(set), fingerprint) << "order and licence do not matter";
  for (std::string LabelledImage::*field :
       {&LabelledImage::object_class, &LabelledImage::instance, &LabelledImage::split}) {
    LabelledImageSet changed = set;
    changed.items[1].*field += "x";
    EXPECT_NE(Fingerprint(changed), fingerprint);
  }
  perception::WritePng(here / "a_mask.png", CountedMask(8, 6, 5, 8));
  EXPECT_NE(Fingerprint(set), fingerprint) << "one pixel of a mask matters";
}

}  // namespace
}  // namespace handcraft::datasets
