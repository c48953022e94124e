// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/format_version.h"

#include <charconv>
#include <cstdint>
#include <system_error>

#include "lib/runtime/format.h"

namespace handcraft::runtime {
namespace {

// Digits without sign or leading zero, at most nine; nothing else.
std::optional<std::uint64_t> ParseNumber(std::string_view text) noexcept {
  if (text.empty() || text.size() > 9 || (text[0] == '0' && text.size() > 1)) return std::nullopt;
  std::uint64_t value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// The major number of "MAJOR.MINOR".
std::optional<std::uint64_t> ParseMajor(std::string_view version) noexcept {
  const std::size_t dot = version.find('.');
  if (dot == std::string_view::npos || !ParseNumber(version.substr(dot + 1))) return std::nullopt;
  return ParseNumber(version.substr(0, dot));
}

}  // namespace

std::optional<ModelError> CheckFormatVersion(std::string_view version,
                                             std::string_view needed) noexcept {
  const std::optional<std::uint64_t> major = ParseMajor(version);
  if (!major) {
    return MakeError(HC_ERROR_FORMAT,
                     format::kLengthBytes,
                     "the metadata key hc.format holds '%s' where a version such as %s was "
                     "expected; this is not a Handcraft model",
                     Printable(version).c_str(),
                     format::kVersionText.data());
  }
  if (*major != format::kMajor) {
    return MakeError(
        HC_ERROR_VERSION,
        format::kLengthBytes,
        "the model has format %s and Handcraft %s reads format %s; %s",
        Printable(version).c_str(),
        hc_version(),
        format::kVersionText.data(),
        *major > format::kMajor ? "install a newer Handcraft runtime" : "train the model again");
  }
  // Format 1.0 knows no feature by name, so that any that is asked for is unknown.
  const std::size_t start = needed.find_first_not_of(' ');
  if (start == std::string_view::npos) return std::nullopt;
  needed.remove_prefix(start);
  return MakeError(HC_ERROR_VERSION,
                   format::kLengthBytes,
                   "the model requires '%s', which Handcraft %s does not know; install a newer "
                   "Handcraft runtime",
                   Printable(needed.substr(0, needed.find(' '))).c_str(),
                   hc_version());
}

}  // namespace handcraft::runtime
