// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/html_text.h"

#include <cmath>

#include <fmt/format.h>

#include "experiments/evaluation/html_style.h"

namespace handcraft::experiments {

std::string EscapeHtml(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string BreakableHtml(std::string_view text) {
  std::string broken;
  for (const char c : EscapeHtml(text)) {  // no entity has a _ or a comma
    broken += c;
    if (c == '_' || c == ',') broken += "<wbr>";
  }
  return broken;
}

std::string Base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

std::string DataUri(std::string_view media_type, std::span<const std::uint8_t> bytes) {
  return fmt::format("data:{};base64,{}", media_type, Base64(bytes));
}

std::string PercentText(double share) {
  return std::isnan(share) ? "–" : fmt::format("{:.1f} %", 100.0 * share);
}

std::string PercentIntervalText(const Estimate& estimate) {
  if (std::isnan(estimate.low) || std::isnan(estimate.high)) return "";
  return fmt::format("[{:.1f}, {:.1f}]", 100.0 * estimate.low, 100.0 * estimate.high);
}

std::string DecimalText(double value, int digits) {
  return std::isnan(value) ? "–" : fmt::format("{:.{}f}", value, digits);
}

std::string DecimalIntervalText(const Estimate& estimate, int digits) {
  if (std::isnan(estimate.low) || std::isnan(estimate.high)) return "";
  return fmt::format("[{:.{}f}, {:.{}f}]", estimate.low, digits, estimate.high, digits);
}

std::string DecimalEstimateText(const Estimate& estimate, int digits) {
  const std::string interval = DecimalIntervalText(estimate, digits);
  return DecimalText(estimate.value, digits) + (interval.empty() ? "" : " " + interval);
}

std::string MakeHtmlPage(std::string_view title, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n{}</main>\n</body>\n"
      "</html>\n",
      EscapeHtml(title),
      kHtmlStyle,
      body);
}

}  // namespace handcraft::experiments
