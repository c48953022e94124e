// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/npy_header.h"

#include <string>
#include <vector>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::filesystem::path kPath = "a.npy";

// A file of format 1 with this header and so many bytes behind it.
std::vector<std::uint8_t> FileOf(const std::string& header, std::size_t data_bytes = 0) {
  std::string text(kNpyMagic);
  text.append({'\x01', '\x00', static_cast<char>(header.size()), '\x00'});
  text += header + std::string(data_bytes, 'x');
  return {text.begin(), text.end()};
}

NpyHeader Read(const std::string& header) {
  const std::vector<std::uint8_t> bytes = FileOf(header);
  return ReadNpyHeader({kPath, bytes});
}

TEST(ReadNpyHeader, TellsTypeOrderAndShape) {
  const NpyHeader header = Read("{'descr': '<f4', 'fortran_order': True, 'shape': (2, 3, 4), }");
  EXPECT_EQ(header.type, "<f4");
  EXPECT_TRUE(header.fortran_order);
  EXPECT_THAT(header.shape, ElementsAre(2, 3, 4));
  EXPECT_EQ(header.data_begin, 10U + 61U);
  EXPECT_THAT(Read("{'descr': '|b1', 'fortran_order': False, 'shape': ()}").shape, IsEmpty());
}

TEST(ReadNpyHeader, NamesTheByteOfWhatIsWrong) {
  EXPECT_THROWS_MESSAGE(Read("{}"), Error, HasSubstr("an NPY header without 'descr'"));
  EXPECT_THROWS_MESSAGE(Read("{'descr': [('x', '<f4')], 'fortran_order': False, 'shape': (1,)}"),
                        Error,
                        HasSubstr("an array of records"));
  const std::vector<std::uint8_t> whole = FileOf("{'descr': '<f4', 'shape': (1,)}");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::vector<std::uint8_t> part(whole.begin(),
                                         whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW(static_cast<void>(ReadNpyHeader({kPath, part})), Error) << size;
  }
}

TEST(RequireNpyLength, ComparesTheShapeWithTheFile) {
  const auto require = [](std::vector<std::size_t> shape, std::size_t data_bytes) {
    const std::vector<std::uint8_t> bytes(10 + data_bytes);
    const NpyHeader header{
        .type = "<f4", .fortran_order = false, .shape = std::move(shape), .data_begin = 10};
    RequireNpyLength({kPath, bytes}, header, 4);
  };
  EXPECT_NO_THROW(require({2, 3}, 24));
  EXPECT_NO_THROW(require({}, 4));
  EXPECT_NO_THROW(require({0, 7}, 0));
  const std::size_t huge = std::size_t{1} << 62U;
  EXPECT_NO_THROW(require({huge, huge, 0}, 0));
  EXPECT_THROWS_MESSAGE(
      (require({2, 3}, 23), 0), Error, HasSubstr("23 bytes of data for 2x3 elements of 4 bytes"));
  EXPECT_THROWS_MESSAGE((require({huge, 4}, 0), 0), Error, HasSubstr("0 bytes of data"));
  EXPECT_THROWS_MESSAGE((require({huge, 4}, 16), 0), Error, HasSubstr("16 bytes of data"));
}

TEST(ShapeText, PutsCrossesBetween) {
  EXPECT_EQ(ShapeText(std::vector<std::size_t>{2, 3, 4}), "2x3x4");
  EXPECT_EQ(ShapeText({}), "");
}

}  // namespace
}  // namespace handcraft::datasets
