// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/base64.h"

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::datasets {
namespace {

std::string Decoded(std::string_view text) {
  const auto bytes = DecodeBase64(text);
  return bytes ? std::string(bytes->begin(), bytes->end()) : "(refused)";
}

// Written bit by bit: the oracle of the law below.
std::string Encode(const std::vector<std::uint8_t>& bytes) {
  const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bits;
  for (const std::uint8_t byte : bytes) {
    for (int bit = 7; bit >= 0; --bit) bits += (byte >> bit & 1) != 0 ? '1' : '0';
  }
  while (bits.size() % 6 != 0) bits += '0';
  std::string text;
  for (std::size_t i = 0; i < bits.size(); i += 6) {
    text += alphabet[std::stoul(bits.substr(i, 6), nullptr, 2)];
  }
  while (text.size() % 4 != 0) text += '=';
  return text;
}

// The test vectors of RFC 4648, section 10.
TEST(DecodeBase64, GivesTheVectorsOfTheStandard) {
  for (const auto& [text, bytes] : {std::pair("", ""),
                                    {"Zg==", "f"},
                                    {"Zm8=", "fo"},
                                    {"Zm9v", "foo"},
                                    {"Zm9vYg==", "foob"},
                                    {"Zm9vYmE=", "fooba"},
                                    {"Zm9vYmFy", "foobar"}}) {
    EXPECT_EQ(Decoded(text), bytes);
  }
  EXPECT_EQ(Decoded("Zm9v\r\nYmFy\n"), "foobar");
}

TEST(DecodeBase64, UndoesTheEncoding) {
  Rng rng(3);
  for (std::size_t size = 0; size < 40; ++size) {
    std::vector<std::uint8_t> bytes(size);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(rng.UniformInt(256));
    EXPECT_EQ(DecodeBase64(Encode(bytes)), bytes);
  }
}

TEST(DecodeBase64, RefusesOtherText) {
  for (const char* text : {"Z",
                           "Zg",
                           "Zg=",
                           "Zg===",
                           "Z===",
                           "====",
                           "Zm9v=",
                           "Zg==Zg==",
                           "Zm-_",
                           "Zm 9",
                           "data:image/png;base64,Zm9v"}) {
    EXPECT_EQ(Decoded(text), "(refused)") << text;
  }
}

}  // namespace
}  // namespace handcraft::datasets
