// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/npy.h"

#include <sys/stat.h>

#include <fstream>
#include <string>
#include <string_view>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::filesystem::path Stored(const std::string& name) {
  return std::filesystem::path(HANDCRAFT_SOURCE_DIR) / "tests/data/npy" / (name + ".npy");
}

NpyMatrix ReadText(std::string_view text) {
  const testing::TemporaryDirectory folder;
  std::ofstream(folder / "m.npy", std::ios::binary) << text;
  return ReadNpy(folder / "m.npy");
}

// A file of format 1 with this header and `data_bytes` zeros behind it.
std::string NpyFile(const std::string& header, std::size_t data_bytes) {
  std::string text = std::string("\x93NUMPY\x01") + '\0';
  text.push_back(static_cast<char>(header.size()));
  text.push_back('\0');
  return text + header + std::string(data_bytes, '\0');
}

// Oracle: numpy (tests/data/npy/make_npy.py).
TEST(ReadNpy, ReadsWhatNumpyWrote) {
  for (const char* kind : {"le_f4",
                           "le_f8",
                           "be_f4",
                           "be_f8",
                           "i1",
                           "u1",
                           "le_i2",
                           "le_i4",
                           "le_i8",
                           "be_u2",
                           "le_u4",
                           "le_u8",
                           "fortran",
                           "version_2"}) {
    SCOPED_TRACE(kind);
    const NpyMatrix matrix = ReadNpy(Stored(std::string("good_") + kind));
    EXPECT_EQ(matrix.rows, 2U);
    EXPECT_EQ(matrix.columns, 3U);
    EXPECT_THAT(matrix.values, ElementsAre(0, 1, 2, 10, 11, 12));
  }
}

TEST(WriteNpy, WritesTheBytesNumpyWrites) {
  const testing::TemporaryDirectory folder;
  const std::vector<float> single = {0, 1, 2, 10, 11, 12};
  WriteNpy(folder / "f4.npy", single.data(), 2, 3);
  EXPECT_EQ(ReadFile(folder / "f4.npy"), ReadFile(Stored("good_le_f4")));
  const std::vector<double> twice(single.begin(), single.end());
  WriteNpy(folder / "f8.npy", twice.data(), 2, 3);
  EXPECT_EQ(ReadFile(folder / "f8.npy"), ReadFile(Stored("good_le_f8")));
}

TEST(WriteNpy, ComesBackUnchanged) {
  const testing::TemporaryDirectory folder;
  Rng rng(3);
  for (const auto& [rows, columns] : {std::pair<std::size_t, std::size_t>{0, 3}, {1, 1}, {7, 5}}) {
    std::vector<double> values(rows * columns);
    for (double& value : values) value = 1e300 * rng.Normal();
    WriteNpy(folder / "m.npy", values.data(), rows, columns);
    const NpyMatrix matrix = ReadNpy(folder / "m.npy");
    EXPECT_EQ(matrix.rows, rows);
    EXPECT_EQ(matrix.columns, columns);
    EXPECT_EQ(matrix.values, values);
  }
}

TEST(ReadNpy, RefusesEveryTruncation) {
  const std::string whole = ReadTextFile(Stored("good_le_f4"));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW(static_cast<void>(ReadText(whole.substr(0, size))), Error) << size;
  }
  EXPECT_THROWS_MESSAGE(
      ReadText(whole + "x"), Error, HasSubstr("25 bytes of data for 2x3 elements of 4 bytes"));
}

TEST(ReadNpy, NamesWhatItDoesNotRead) {
  EXPECT_THROWS_MESSAGE(ReadNpy("no/such.npy"), Error, HasSubstr("no/such.npy: cannot open"));
  EXPECT_THROWS_MESSAGE(ReadText("a,b\n"), Error, HasSubstr("not an NPY file"));
  EXPECT_THROWS_MESSAGE(ReadText("PK\x03\x04"), Error, HasSubstr("zip archive (.npz)"));
  EXPECT_THROWS_MESSAGE(ReadText("\x93NUMPY\x09"), Error, HasSubstr("NPY format 9; 1, 2 or 3"));
  EXPECT_THROWS_MESSAGE(ReadNpy(Stored("half")), Error, HasSubstr("type '<f2'; float32, float64"));
  EXPECT_THROWS_MESSAGE(ReadNpy(Stored("complex")), Error, HasSubstr("type '<c16'"));
  EXPECT_THROWS_MESSAGE(ReadNpy(Stored("rank_1")), Error, HasSubstr("rank 1; rank 2 is due"));
  EXPECT_THROWS_MESSAGE(ReadNpy(Stored("rank_3")), Error, HasSubstr("rank 3; rank 2 is due"));
  EXPECT_THROWS_MESSAGE(ReadNpy(Stored("records")), Error, HasSubstr("an array of records"));
  EXPECT_THROWS_MESSAGE(ReadNpy(Stored("nan")), Error, HasSubstr("144: a NaN or an infinity"));
}

TEST(ReadNpy, SurvivesHostileHeaders) {
  EXPECT_THROWS_MESSAGE(ReadText(NpyFile("{}", 0)), Error, HasSubstr("without 'descr':"));
  EXPECT_THROWS_MESSAGE(ReadText(NpyFile("{'descr': '<f8', 'fortran_order': False, 'shape': "
                                         "(4294967296, 4294967296), }",
                                         0)),
                        Error,
                        HasSubstr("0 bytes of data for 4294967296x4294967296 elements"));
  EXPECT_THROWS_MESSAGE(ReadText(NpyFile("{'descr': '<f8', 'fortran_order': False, 'shape': "
                                         "(99999999999999999999999, 1), }",
                                         8)),
                        Error,
                        HasSubstr("beyond all bounds"));
  EXPECT_THROWS_MESSAGE(
      ReadText(NpyFile("{'descr': '', 'fortran_order': False, 'shape': (1, 1)}", 8)),
      Error,
      HasSubstr("type ''"));
  EXPECT_EQ(ReadText(NpyFile("{'descr':'<f8','fortran_order':False,'shape':(1,1)}", 8)).rows, 1U);
  const std::string front = "{'descr': '<f8', 'fortran_order': False, 'shape': ";
  for (const char* shape : {"(-1, 1)", "(1, +1)", "(1.0, 1)", "(1, 1"}) {
    EXPECT_THROWS_MESSAGE(ReadText(NpyFile(front + shape, 8)), Error, HasSubstr("an NPY shape "));
  }
}

// Law: a damaged file is an Error or a matrix, never another exception.
TEST(ReadNpy, SurvivesFlippedBits) {
  const std::string whole = ReadTextFile(Stored("good_le_f4"));
  const testing::TemporaryDirectory folder;
  for (std::size_t bit = 0; bit < 8 * whole.size(); bit += 7) {
    std::string flipped = whole;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    try {
      EXPECT_LE(ReadText(flipped).values.size(), 6U);
    } catch (const Error&) {
    }
  }
}

TEST(IsNpy, LooksAtTheFirstBytesAndDoesNotWaitForAPipe) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "a.csv", "\x93NUMPYx");
  WriteFileAtomically(folder / "b.npy", "\x93NUMP");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_TRUE(IsNpy(folder / "a.csv"));
  EXPECT_FALSE(IsNpy(folder / "b.npy"));
  EXPECT_FALSE(IsNpy(folder / "pipe"));
  EXPECT_FALSE(IsNpy(folder / "nothing"));
  EXPECT_FALSE(IsNpy("/dev/zero"));
}

}  // namespace
}  // namespace handcraft::datasets
