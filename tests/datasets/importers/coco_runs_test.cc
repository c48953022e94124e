// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/coco_runs.h"

#include <cstdint>
#include <map>
#include <string>

#include <gmock/gmock.h>

#include "lib/core/rng.h"

namespace handcraft::datasets {
namespace {

using ::testing::Optional;

// Written from the description of the code, by arithmetic alone: the oracle.
std::string Encode(const PixelRuns& runs) {
  std::string text;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::int64_t number = runs[i];
    if (i > 2) number -= runs[i - 2];
    for (bool more = true; more;) {
      std::int64_t group = number % 32;
      if (group < 0) group += 32;
      number = (number - group) / 32;
      more = !((number == 0 && group < 16) || (number == -1 && group >= 16));
      text += static_cast<char>('0' + group + (more ? 32 : 0));
    }
  }
  return text;
}

// Pairs that other implementations of the COCO API publish in their tests.
TEST(DecodeCocoRuns, ReadsPublishedTexts) {
  const std::map<std::string, PixelRuns> cases = {{"061M", {0, 6, 1, 3}},
                                                  {"061", {0, 6, 1}},
                                                  {"061K", {0, 6, 1, 1}},
                                                  {"061O", {0, 6, 1, 5}},
                                                  {"0610", {0, 6, 1, 6}},
                                                  {"011101010", {0, 1, 1, 2, 1, 3, 1, 4, 1}},
                                                  {"0PP1", {0, 1024}}};
  for (const auto& [text, runs] : cases) {
    EXPECT_THAT(DecodeCocoRuns(text), Optional(runs)) << text;
    EXPECT_EQ(Encode(runs), text);
  }
  EXPECT_THAT(DecodeCocoRuns(""), Optional(PixelRuns{}));
}

// A published mask of 50 rows and 70 columns: its runs fill it.
TEST(DecodeCocoRuns, FillsAPublishedMask) {
  const auto runs = DecodeCocoRuns(
      "0g05b08J4M2N2NA^O1`0OCO=0E090H080IO68DH;>@C>a0_O_O`0j0OWOF<:CM72I24NL43JM92FN;1ENKO72L0LO91J"
      "0MO92INO0NO122OO0M031O000NO31OO11MO40N011MO41MO21L06OL021L06OL021L06OL021L060J040L060J040L06"
      "0J040L060J040L060J040L060J040L060KO31L060KO31L06OL021L06OL021L06OL021MO41MO21MO40N100NO310O0"
      "0M0310O00NO1220NO92IONO91KOMO72M0<1EO:2GN63KM34OLM73JF<;=1G_O_Ob0=AC`07EH=1IO71H090F0:1DO>1_"
      "O1b0>2N2N3L6H]O");
  ASSERT_TRUE(runs);
  std::uint64_t sum = 0;
  for (const std::uint32_t run : *runs) sum += run;
  EXPECT_EQ(sum, 50U * 70U);
}

TEST(DecodeCocoRuns, UndoesTheEncoding) {
  Rng rng(5);
  for (int round = 0; round < 300; ++round) {
    PixelRuns runs(rng.UniformInt(12));
    for (std::uint32_t& run : runs) {
      run =
          static_cast<std::uint32_t>(rng.UniformInt(std::uint64_t{1} << (1 + rng.UniformInt(32))));
    }
    EXPECT_THAT(DecodeCocoRuns(Encode(runs)), Optional(runs));
  }
}

TEST(DecodeCocoRuns, RefusesWhatIsNoCode) {
  EXPECT_FALSE(DecodeCocoRuns("06p")) << "a letter above the code";
  EXPECT_FALSE(DecodeCocoRuns("06 1")) << "a letter below";
  EXPECT_FALSE(DecodeCocoRuns("0\xC3")) << "not ASCII";
  EXPECT_FALSE(DecodeCocoRuns("0P")) << "a number without its end";
  EXPECT_FALSE(DecodeCocoRuns("O")) << "less than nothing: -1";
  EXPECT_FALSE(DecodeCocoRuns("011J")) << "1 - 6";
  EXPECT_FALSE(DecodeCocoRuns("PPPPPP4")) << "2 to the 32";
  EXPECT_FALSE(DecodeCocoRuns(std::string(1000, 'P') + "1")) << "huge";
}

}  // namespace
}  // namespace handcraft::datasets
