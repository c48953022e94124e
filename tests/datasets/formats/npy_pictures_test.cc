// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/npy_pictures.h"

#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

// Reads an array of format 1 with this type and shape and these bytes behind the header.
std::vector<Image> Read(const std::string& type,
                        const std::string& shape,
                        const std::string& data,
                        const std::string& fortran_order = "False") {
  const std::string header = "{'descr': '" + type + "', 'fortran_order': " + fortran_order +
                             ", 'shape': " + shape + ", }\n";
  std::string text = std::string("\x93NUMPY\x01") + '\0';
  text.push_back(static_cast<char>(header.size()));
  text.push_back('\0');
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "p.npy", text + header + data);
  return ReadNpyPictures(folder / "p.npy");
}

TEST(ReadNpyPictures, TakesRowsOfColumns) {
  const std::vector<Image> pictures = Read("|u1", "(2, 2, 3)", "abcdefghijkl");
  ASSERT_THAT(pictures, SizeIs(2));
  EXPECT_EQ(pictures[0].width(), 3);
  EXPECT_EQ(pictures[0].height(), 2);
  EXPECT_EQ(pictures[0].channels(), 1);
  EXPECT_THAT(pictures[0].values(), ElementsAre('a', 'b', 'c', 'd', 'e', 'f'));
  EXPECT_EQ(pictures[1].At(2, 1), 'l');
}

TEST(ReadNpyPictures, NamesWhatItDoesNotRead) {
  const auto refuses = [](const std::string& type,
                          const std::string& shape,
                          const std::string& data,
                          const std::string& message) {
    EXPECT_THROWS_MESSAGE(Read(type, shape, data), Error, HasSubstr(message));
  };
  refuses("|u1", "(2, 3)", "abcdef", "rank 2; rank 3 is due: picture, row, column");
  refuses("<f4", "(1, 1, 1)", "abcd", "elements of type '<f4'; bytes in C order are due");
  refuses("", "(1, 1, 1)", "a", "elements of type ''");
  refuses("|u1", "(1, 2, 3)", "abcde", "5 bytes of data for 1x2x3 elements of 1 bytes");
  refuses("|u1", "(1, 2, 3)", "abcdefg", "7 bytes of data");
  refuses("|u1", "(4294967296, 4294967296, 1)", "", "0 bytes of data for 4294967296x4294967296x1");
  refuses("|u1", "(0, 2, 3)", "", "an array of 0x2x3; one or more pictures");
  refuses("|u1", "(1, 0, 3)", "", "an array of 1x0x3");
  refuses("|u1", "(1, 1, 65536)", std::string(65536, 'a'), "1 to 65535 pixels a side");
  EXPECT_THROWS_MESSAGE(
      Read("|u1", "(1, 1, 2)", "ab", "True"), Error, HasSubstr("type '|u1' in Fortran order"));
  EXPECT_THROWS_MESSAGE(ReadNpyPictures("no.npy"), Error, HasSubstr("no.npy: cannot open"));
}

}  // namespace
}  // namespace handcraft::datasets
