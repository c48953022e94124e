// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/mat_array.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

const std::filesystem::path kFolder = HANDCRAFT_SOURCE_DIR "/tests/data/mat";  // by make_mat.py

MatArray Read(const Bytes& bytes, const std::string& name = "a") {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "a.mat", bytes);
  return ReadMatArray(folder / "a.mat", name);
}

// A file written by hand, in either byte order.
class MatFile {
 public:
  explicit MatFile(bool is_big_endian = false) : is_big_endian_(is_big_endian) {
    bytes_.resize(124, ' ');
    Add<std::uint16_t>(0x0100);
    Add<std::uint16_t>(0x4D49);  // "MI" as a number
  }
  template <class T>
  MatFile& Add(T value) {
    std::array<std::uint8_t, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, sizeof(T));
    if (is_big_endian_) std::reverse(raw.begin(), raw.end());
    bytes_.insert(bytes_.end(), raw.begin(), raw.end());
    return *this;
  }
  MatFile& AddWords(const std::vector<std::uint32_t>& words) {
    for (const std::uint32_t word : words) Add(word);
    return *this;
  }
  [[nodiscard]] const Bytes& bytes() const { return bytes_; }

 private:
  bool is_big_endian_;
  Bytes bytes_;
};

// The 1 × 2 array a = (3, 7) of 16 bits: flags, dimensions, small name, small data.
MatFile TwoNumbers(bool is_big_endian = false) {
  MatFile file(is_big_endian);
  file.AddWords({14, 48, 6, 8, 10, 0, 5, 8, 1, 2, 1U << 16 | 1});
  file.Add<std::uint8_t>('a').Add<std::uint8_t>(0).Add<std::uint16_t>(0);
  file.AddWords({4U << 16 | 3}).Add<std::int16_t>(3).Add<std::int16_t>(7);
  return file;
}

TEST(ReadMatArray, ReadsAFileWrittenByHandInEitherByteOrder) {
  for (const bool is_big_endian : {false, true}) {
    const MatArray array = Read(TwoNumbers(is_big_endian).bytes());
    EXPECT_THAT(array.dimensions, ElementsAre(1, 2));
    EXPECT_THAT(array.values, ElementsAre(3, 7));
  }
}

TEST(ReadMatArray, ReadsWhatScipyWrites) {
  for (const char* name : {"plain.mat", "compressed.mat"}) {
    const std::filesystem::path path = kFolder / name;
    const MatArray labels = ReadMatArray(path, "gt_label");
    EXPECT_THAT(labels.dimensions, ElementsAre(2, 3));
    EXPECT_THAT(labels.values, ElementsAre(0, 10, 1, 11, 2, 12)) << "column after column";
    EXPECT_THAT(ReadMatArray(path, "small").values, ElementsAre(0, 1, 2));
    EXPECT_THAT(ReadMatArray(path, "wide").values, ElementsAre(0, 2.5, 0.25, 2.75, 0.5, 3));
    EXPECT_THAT(ReadMatArray(path, "flags").values, ElementsAre(0, 1, 0, 1, 1, 1));
    EXPECT_THAT(ReadMatArray(path, "single").values, ElementsAre(0, 10, 1, 11, 2, 12));
    EXPECT_DOUBLE_EQ(ReadMatArray(path, "big").values[5], 12 * 0x1p40);
    const MatArray cube = ReadMatArray(path, "cube");
    EXPECT_THAT(cube.dimensions, ElementsAre(2, 3, 4));
    EXPECT_EQ(cube.values[1 + 2 * (2 + 3 * 3)], 1 * 12 + 2 * 4 + 3);
  }
}

TEST(ReadMatArray, RefusesWhatIsNoArrayOfNumbers) {
  for (const char* name : {"plain.mat", "compressed.mat"}) {
    for (const std::string array : {"note", "complex", "cells"}) {
      EXPECT_THROWS_MESSAGE(ReadMatArray(kFolder / name, array),
                            Error,
                            HasSubstr("'" + array + "' is not a full array of real numbers"));
    }
    EXPECT_THROWS_MESSAGE(ReadMatArray(kFolder / name, "label"),
                          Error,
                          HasSubstr("no array 'label'; there are: 'note', 'small', 'gt_label'"));
  }
}

TEST(ReadMatArray, RefusesOtherKindsOfFiles) {
  EXPECT_THROWS_MESSAGE(ReadMatArray(kFolder / "level_4.mat", "gt_label"),
                        Error,
                        HasSubstr("not a MAT-file of level 5 (save it with -v7)"));
  EXPECT_THROWS_MESSAGE(Read({}), Error, HasSubstr("not a MAT-file of level 5"));
  const std::string hdf5 = "MATLAB 7.3 MAT-file, Platform: GLNXA64";
  EXPECT_THROWS_MESSAGE(Read({hdf5.begin(), hdf5.end()}),
                        Error,
                        HasSubstr("a MAT-file of version 7.3 (save it with -v7)"));
  Bytes version = TwoNumbers().bytes();
  version[125] = 2;
  EXPECT_THROWS_MESSAGE(Read(version), Error, HasSubstr("at byte 124: another version"));
  EXPECT_THROWS_MESSAGE(Read(MatFile().bytes()), Error, HasSubstr("there are: none"));
}

TEST(ReadMatArray, NamesTheByteOfAFault) {
  const auto refusal = [](std::size_t word, std::uint32_t value, const char* message) {
    Bytes bytes = TwoNumbers().bytes();
    std::memcpy(bytes.data() + 128 + word * 4, &value, sizeof value);
    EXPECT_THROWS_MESSAGE(Read(bytes), Error, HasSubstr(message));
  };
  refusal(1, 49, "at byte 184: a MAT-file cut off here");
  refusal(2, 7, "at byte 136: a data element of type 7 where 6 is due");
  refusal(4, 4, "'a' is not a full array");
  refusal(4, 0x0800 | 10, "'a' is not a full array");
  refusal(6, 6, "a data element of type 6 where 5 is due");
  refusal(7, 4, "an array without rows and columns");
  refusal(8, 0xFFFFFFFF, "a negative dimension");
  refusal(8, 1U << 27, "an array of more than 2^24 numbers");
  refusal(8, 2, "'a' holds 2 numbers; its dimensions ask for 4");
  refusal(10, 5U << 16 | 1, "a small data element of more than four bytes");
  refusal(12, 3U << 16 | 3, "a part of a number at the end");
  refusal(12, 4U << 16 | 8, "data of type 8; numbers are due");
}

// Adversaries: cut anywhere, and compressed data that is damaged.
TEST(ReadMatArray, RefusesAFileThatIsCutOffOrDamaged) {
  const Bytes whole = TwoNumbers().bytes();
  for (std::size_t size = 0; size < whole.size(); size += size < 120 ? 40 : 5) {
    EXPECT_THROW(Read(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))),
                 Error);
  }
  Bytes compressed = ReadFile(kFolder / "compressed.mat");
  compressed[128 + 8 + 10] ^= 0x55;
  EXPECT_THROWS_MESSAGE(Read(compressed, "gt_label"),
                        Error,
                        AllOf(HasSubstr("at byte 136"), HasSubstr("compressed data that is")));
}

}  // namespace
}  // namespace handcraft::datasets
