// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "experiments/metrics/binary_metrics.h"

namespace handcraft::experiments {

/// The text with & < > " ' written as entities: safe between tags and inside quoted attributes, in
/// HTML and in SVG. Everything that comes from data goes through here.
[[nodiscard]] std::string EscapeHtml(std::string_view text);

/// The same, and lines may break after each _ and comma, as names of cells need it.
[[nodiscard]] std::string BreakableHtml(std::string_view text);

/// Base 64 with padding (RFC 4648, section 4).
[[nodiscard]] std::string Base64(std::span<const std::uint8_t> bytes);

/// "data:<media type>;base64,…": a picture inside the page.
[[nodiscard]] std::string DataUri(std::string_view media_type, std::span<const std::uint8_t> bytes);

/// Numbers as people read them: 0.8125 → "81.3 %" and "0.813" with three digits, "–" for NaN; the
/// interval alone "[72.0, 88.1]", in percent beside such a value, empty when there is none.
[[nodiscard]] std::string PercentText(double share);
[[nodiscard]] std::string PercentIntervalText(const Estimate& estimate);
[[nodiscard]] std::string DecimalText(double value, int digits);
[[nodiscard]] std::string DecimalIntervalText(const Estimate& estimate, int digits);
/// Value and interval: "0.861 [0.840, 0.880]"; the value alone when there is no interval.
[[nodiscard]] std::string DecimalEstimateText(const Estimate& estimate, int digits);

/// A whole page: document type, style sheet (experiments/evaluation/html_style.h), body. The title
/// is plain text, the body HTML. No script, nothing loaded from outside.
[[nodiscard]] std::string MakeHtmlPage(std::string_view title, std::string_view body);

}  // namespace handcraft::experiments
