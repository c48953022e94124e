// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/image_header.h"

#include <array>
#include <cstdlib>
#include <string>

#include "lib/core/error.h"
#include "lib/perception/png_crc.h"

namespace handcraft::perception {
namespace {

using Bytes = std::span<const std::uint8_t>;

// A file with its name: reads numbers and fails with the place.
struct File {
  const std::filesystem::path& path;
  Bytes bytes;
  ChannelBits due = ChannelBits::k8;

  [[noreturn]] void Fail(std::size_t byte, std::string reason, std::string remedy = {}) const {
    throw Error({.path = path.string(),
                 .byte = byte,
                 .reason = std::move(reason),
                 .remedy = std::move(remedy)});
  }

  [[nodiscard]] std::uint32_t BigEndian(std::size_t at, std::size_t count) const {
    if (at > bytes.size() || bytes.size() - at < count) FailCutOff();
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value << 8 | bytes[at + i];
    return value;
  }

  [[nodiscard]] std::uint32_t LittleEndian(std::size_t at, std::size_t count) const {
    if (at > bytes.size() || bytes.size() - at < count) FailCutOff();
    std::uint32_t value = 0;
    for (std::size_t i = count; i-- > 0;) value = value << 8 | bytes[at + i];
    return value;
  }

  [[noreturn]] void FailCutOff() const {
    Fail(bytes.size(), "the file is cut off here", "copy it again from its source");
  }

  void CheckDepth(std::size_t byte, std::string_view format, std::uint32_t bits) const {
    if (due == ChannelBits::k8 ? bits <= 8 : bits == 16) return;
    const std::string wanted = due == ChannelBits::k8 ? "8" : "16";
    Fail(byte,
         "a " + std::string(format) + " of " + std::to_string(bits) + " bits a channel; " + wanted +
             " bits are due",
         "convert it to " + wanted + " bits a channel");
  }

  void CheckSize(std::size_t byte, std::int64_t width, std::int64_t height) const {
    const bool empty = width < 1 || height < 1;
    const bool huge = width > kMaxImageSide_px || height > kMaxImageSide_px ||
                      (!empty && width > kMaxImagePixels / height);
    if (!empty && !huge) return;
    Fail(byte,
         "a picture of " + std::to_string(width) + "x" + std::to_string(height) + " pixels; " +
             (empty ? "at least 1x1 is due"
                    : "at most " + std::to_string(kMaxImageSide_px) + " a side and " +
                          std::to_string(kMaxImagePixels) + " in all are allowed"));
  }

  // `needed` bytes of the file are spoken for by its header.
  void CheckLength(std::uint64_t needed) const {
    if (bytes.size() < needed) FailCutOff();
  }
};

bool StartsWith(Bytes bytes, std::string_view magic) {
  if (bytes.size() < magic.size()) return false;
  for (std::size_t i = 0; i < magic.size(); ++i) {
    if (bytes[i] != static_cast<std::uint8_t>(magic[i])) return false;
  }
  return true;
}

ImageHeader ReadPng(const File& file) {
  constexpr std::size_t kFirstChunk = 8;
  constexpr std::uint32_t kIhdr = 0x49484452;
  constexpr std::uint32_t kIdat = 0x49444154;
  constexpr std::uint32_t kIend = 0x49454E44;
  constexpr std::uint32_t kExif = 0x65584966;
  if (file.BigEndian(kFirstChunk + 4, 4) != kIhdr) {
    file.Fail(kFirstChunk, "a PNG that does not begin with its header");
  }
  const std::uint32_t width = file.BigEndian(16, 4);
  const std::uint32_t height = file.BigEndian(20, 4);
  const std::uint32_t colour_type = file.BigEndian(25, 1);
  file.CheckDepth(24, "PNG", file.BigEndian(24, 1));
  file.CheckSize(16, width, height);

  // Chunk: length, type, data, CRC over type and data.
  bool has_pixels = false;
  bool has_exif = false;
  for (std::size_t at = kFirstChunk;;) {
    const std::size_t length = file.BigEndian(at, 4);
    const std::uint32_t type = file.BigEndian(at + 4, 4);
    file.CheckLength(std::uint64_t{at} + 12 + length);
    if (PngCrc(file.bytes.subspan(at + 4, 4 + length)) != file.BigEndian(at + 8 + length, 4)) {
      file.Fail(at, "a damaged PNG: the checksum of this chunk is wrong", "copy it again");
    }
    if (type == kIend && !has_pixels) file.Fail(at, "a damaged PNG: no pixels before its end");
    if (type == kIend) break;
    has_pixels = has_pixels || type == kIdat;
    has_exif = has_exif || type == kExif;
    at += 12 + length;
  }
  // Colour types 0 and 4 are gray, without and with alpha.
  return {"PNG",
          static_cast<int>(width),
          static_cast<int>(height),
          colour_type == 0 || colour_type == 4,
          has_exif,
          colour_type == 3};
}

// Behind a start of scan: the place of the next marker that ends the entropy-coded data.
std::size_t SkipScan(const File& file, std::size_t at) {
  for (;; ++at) {
    if (file.BigEndian(at, 1) != 0xFF) continue;
    const std::uint32_t next = file.BigEndian(at + 1, 1);
    const bool inside = next == 0x00 || next == 0xFF || (next >= 0xD0 && next <= 0xD7);
    if (!inside) return at;
  }
}

bool IsStartOfFrame(std::uint32_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

// The channels that the frame at `at` has.
std::uint32_t NumChannels(const File& file, std::size_t at) { return file.BigEndian(at + 5, 1); }

ImageHeader ReadFrame(const File& file, std::size_t at) {
  file.CheckDepth(at, "JPEG", file.BigEndian(at, 1));
  const std::uint32_t height = file.BigEndian(at + 1, 2);
  const std::uint32_t width = file.BigEndian(at + 3, 2);
  file.CheckSize(at + 1, width, height);
  const std::uint32_t channels = NumChannels(file, at);
  if (channels != 1 && channels != 3 && channels != 4) {
    file.Fail(at + 5,
              "a JPEG of " + std::to_string(channels) + " channels; 1, 3 or 4 are due",
              "convert it to RGB");
  }
  return {"JPEG", static_cast<int>(width), static_cast<int>(height), channels == 1};
}

// Adobe's mark of four inks: CMYK (0) or YCCK (2).
bool TellsOfInks(const File& file, std::size_t at) {
  constexpr std::uint32_t kApp14 = 0xEE;
  if (file.BigEndian(at + 1, 1) != kApp14 || file.BigEndian(at + 2, 2) < 14 ||
      !StartsWith(file.bytes.subspan(at + 4), "Adobe")) {
    return false;
  }
  const std::uint32_t code = file.BigEndian(at + 15, 1);
  return code == 0 || code == 2;
}

// Adobe's programs write four inks inverted (255: none) and mark the file; without their mark,
// programs disagree on which end is full ink.
void CheckInks(const File& file, std::size_t frame, bool is_told) {
  if (is_told || frame == 0 || NumChannels(file, frame) != 4) return;
  file.Fail(frame + 5,
            "a JPEG of four inks (CMYK) without Adobe's marker of CMYK or YCCK: nothing tells "
            "whether 0 or 255 is "
            "full ink",
            "convert it to RGB");
}

ImageHeader ReadJpeg(const File& file) {
  constexpr std::uint32_t kExif = 0xE1;
  ImageHeader header;
  bool has_exif = false;
  bool tells_of_inks = false;
  std::size_t frame = 0;  // of the first scan; 0: none yet
  for (std::size_t at = 2;;) {
    if (file.BigEndian(at, 1) != 0xFF) file.Fail(at, "a damaged JPEG: a marker is due here");
    const std::uint32_t marker = file.BigEndian(at + 1, 1);
    if (marker == 0xFF) {  // padding
      ++at;
      continue;
    }
    if (marker == 0xD9) {
      if (header.width == 0) file.Fail(at, "a JPEG without a picture");
      header.may_turn = has_exif;
      return header;
    }
    has_exif = has_exif || marker == kExif;
    tells_of_inks = tells_of_inks || TellsOfInks(file, at);
    if (IsStartOfFrame(marker)) {
      frame = at + 4;
      header = ReadFrame(file, frame);
    }
    if (marker == 0xDA) CheckInks(file, frame, tells_of_inks);
    const std::size_t length = file.BigEndian(at + 2, 2);
    if (length < 2) file.Fail(at, "a damaged JPEG: a segment without a length");
    at += 2 + length;
    file.CheckLength(at);
    if (marker == 0xDA) at = SkipScan(file, at);
  }
}

ImageHeader ReadBmp(const File& file) {
  const std::uint32_t header_size = file.LittleEndian(14, 4);
  file.CheckDepth(28, "BMP", 8);
  if (header_size < 40 || header_size > 124) {
    file.Fail(14, "a BMP of an unusual kind or a damaged one", "convert it to PNG");
  }
  const auto width = static_cast<std::int32_t>(file.LittleEndian(18, 4));
  const auto stored_height = static_cast<std::int32_t>(file.LittleEndian(22, 4));
  const std::int64_t height = std::abs(std::int64_t{stored_height});  // < 0: top row first
  const std::uint32_t bits = file.LittleEndian(28, 2);
  file.CheckSize(18, width, height);
  if (file.LittleEndian(30, 4) != 0) file.Fail(30, "a compressed BMP", "convert it to PNG");
  if (bits != 8 && bits != 24 && bits != 32) {
    file.Fail(28,
              "a BMP of " + std::to_string(bits) + " bits a pixel; 8, 24 or 32 are due",
              "convert it to PNG");
  }
  const std::uint64_t row_bytes = (static_cast<std::uint64_t>(width) * bits + 31) / 32 * 4;
  file.CheckLength(file.LittleEndian(10, 4) + row_bytes * static_cast<std::uint64_t>(height));
  // Whether an 8-bit palette is gray is the decoder's to find out: colour is the safe claim.
  return {"BMP", width, static_cast<int>(height), false};
}

// A number of a PGM or PPM header; moves `at` to the byte behind it.
std::int64_t ReadPnmNumber(const File& file, std::size_t& at) {
  const auto is_digit = [](std::uint32_t c) { return c >= '0' && c <= '9'; };
  while (!is_digit(file.BigEndian(at, 1))) {
    const std::uint32_t c = file.BigEndian(at, 1);
    if (c == '#') {
      while (file.BigEndian(at, 1) != '\n') ++at;
    } else if (c != ' ' && c != '\t' && c != '\r' && c != '\n') {
      file.Fail(at, "a PGM or PPM header in which a number is due here");
    }
    ++at;
  }
  std::int64_t value = 0;
  for (; is_digit(file.BigEndian(at, 1)) && value < (std::int64_t{1} << 40); ++at) {
    value = 10 * value + (file.BigEndian(at, 1) - '0');
  }
  return value;
}

ImageHeader ReadPnm(const File& file) {
  const bool gray = file.bytes[1] == '5';
  std::size_t at = 2;
  const std::int64_t width = ReadPnmNumber(file, at);
  const std::int64_t height = ReadPnmNumber(file, at);
  const std::int64_t max_value = ReadPnmNumber(file, at);
  file.CheckSize(2, width, height);
  file.CheckDepth(at, gray ? "PGM" : "PPM", max_value > 255 ? 16 : 8);
  const int due_value = file.due == ChannelBits::k8 ? 255 : 65535;
  if (max_value != due_value) {
    file.Fail(at,
              "a largest value of " + std::to_string(max_value) + "; " + std::to_string(due_value) +
                  " is due");
  }
  const std::int64_t value_bytes = file.due == ChannelBits::k8 ? 1 : 2;
  file.CheckLength(at + 1 +
                   static_cast<std::uint64_t>(width * height * (gray ? 1 : 3) * value_bytes));
  return {gray ? "PGM" : "PPM", static_cast<int>(width), static_cast<int>(height), gray};
}

// Well-known files that are not read, by their first bytes.
std::string_view NameOfOtherFormat(Bytes bytes) {
  struct Signature {
    std::string_view magic, name;
  };
  using std::string_view_literals::operator""sv;
  static constexpr std::array kSignatures = {
      Signature{"II*\0"sv, "a TIFF file"},
      Signature{"MM\0*"sv, "a TIFF file"},
      Signature{"\x76\x2F\x31\x01"sv, "an OpenEXR file (floating point)"},
      Signature{"#?RADIANCE"sv, "a Radiance file (floating point)"},
      Signature{"PF"sv, "a PFM file (floating point)"},
      Signature{"Pf"sv, "a PFM file (floating point)"},
      Signature{"P2"sv, "a PGM file in text form"},
      Signature{"P3"sv, "a PPM file in text form"},
      Signature{"P1"sv, "a PBM file (1 bit)"},
      Signature{"P4"sv, "a PBM file (1 bit)"},
      Signature{"RIFF"sv, "a WebP or other RIFF file"},
      Signature{"GIF8"sv, "a GIF file"},
      Signature{"\0\0\0\x0CjP  "sv, "a JPEG 2000 file"}};
  for (const Signature& signature : kSignatures) {
    if (StartsWith(bytes, signature.magic)) return signature.name;
  }
  return "not a picture";
}

}  // namespace

ImageHeader ReadImageHeader(const std::filesystem::path& path,
                            std::span<const std::uint8_t> bytes,
                            ChannelBits due) {
  const File file{path, bytes, due};
  if (bytes.empty()) throw Error({.path = path.string(), .reason = "the file is empty"});
  if (StartsWith(bytes, "\x89PNG\r\n\x1A\n")) return ReadPng(file);
  if (StartsWith(bytes, "\xFF\xD8\xFF")) return ReadJpeg(file);
  if (StartsWith(bytes, "BM")) return ReadBmp(file);
  if (StartsWith(bytes, "P5") || StartsWith(bytes, "P6")) return ReadPnm(file);
  throw Error({.path = path.string(),
               .reason = std::string(NameOfOtherFormat(bytes)) + "; " +
                         (due == ChannelBits::k8 ? "an 8-bit PNG, JPEG, BMP, PGM or PPM is due"
                                                 : "a 16-bit PNG or PGM is due"),
               .remedy = "convert it, for example to PNG"});
}

}  // namespace handcraft::perception
