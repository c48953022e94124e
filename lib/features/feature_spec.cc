// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/feature_spec.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <utility>

#include "lib/core/check.h"
#include "lib/core/error.h"

namespace handcraft::features {
namespace {

constexpr std::array<std::string_view, 3> kEnergyNames = {"square", "abs", "log"};

struct Preset {
  std::string_view name;
  std::string_view text;
};
constexpr std::array<Preset, 5> kPresets = {{
    {"all500", "filters=all,window=5"},
    {"edges150", "filters=edges,window=5"},
    {"window180", "filters=all,window=3"},
    {"edges54", "filters=edges,window=3"},
    {"saxena459", "filters=laws+edges+chroma,window=5,scales=3+9"},
}};

// A group of filters is a range of their numbers.
struct Group {
  std::string_view name;
  int first;
  int last;
};
constexpr std::array<Group, 5> kGroups = {{
    {"all", 0, kNumIntensityFilters - 1},
    {"laws", static_cast<int>(Filter::kLawsLL), static_cast<int>(Filter::kLawsSS)},
    {"edges", static_cast<int>(Filter::kEdge0), static_cast<int>(Filter::kEdge150)},
    {"sobel", static_cast<int>(Filter::kSobelFirst5), static_cast<int>(Filter::kSobelSecond7)},
    {"chroma", static_cast<int>(Filter::kChromaBlueLL), static_cast<int>(Filter::kChromaRedLL)},
}};

[[noreturn]] void Refuse(std::string_view spec,
                         const std::string& reason,
                         const std::string& remedy) {
  throw Error({.kind = Error::Kind::kUsage,
               .reason = "feature specification '" + std::string(spec) + "': " + reason,
               .remedy = remedy});
}

// Takes the text up to the separator off the front of `text`.
std::string_view TakeWord(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

std::string FilterChoices() {
  std::string text = "filters are all, laws, edges, sobel, chroma";
  for (int i = 0; i < kNumFilters; ++i) text += ", " + std::string(NameOf(static_cast<Filter>(i)));
  return text;
}

void AddFilters(std::string_view spec, std::string_view word, std::vector<Filter>& filters) {
  for (const Group& group : kGroups) {
    if (group.name != word) continue;
    for (int i = group.first; i <= group.last; ++i) filters.push_back(static_cast<Filter>(i));
    return;
  }
  const std::optional<Filter> filter = FilterNamed(word);
  if (!filter) Refuse(spec, "unknown filter '" + std::string(word) + "'", FilterChoices());
  filters.push_back(*filter);
}

int ParseNumber(std::string_view spec, std::string_view word) {
  int value = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (fault != std::errc() || end != word.data() + word.size()) {
    Refuse(spec, "'" + std::string(word) + "' is not a whole number", "for example window=5");
  }
  return value;
}

Energy ParseEnergy(std::string_view spec, std::string_view word) {
  const auto* const found = std::find(kEnergyNames.begin(), kEnergyNames.end(), word);
  if (found == kEnergyNames.end()) {
    Refuse(spec, "unknown energy '" + std::string(word) + "'", "energies are square, abs, log");
  }
  return static_cast<Energy>(found - kEnergyNames.begin());
}

void ApplyPair(std::string_view whole,
               std::string_view key,
               std::string_view value,
               FeatureSpec& spec) {
  if (key == "filters") {
    spec.filters.clear();
    while (!value.empty()) AddFilters(whole, TakeWord(value, '+'), spec.filters);
  } else if (key == "window") {
    spec.window = ParseNumber(whole, value);
  } else if (key == "energy") {
    spec.energy = ParseEnergy(whole, value);
  } else if (key == "scales") {
    spec.scales.clear();
    if (value == "none") return;
    while (!value.empty()) spec.scales.push_back(ParseNumber(whole, TakeWord(value, '+')));
  } else {
    Refuse(whole,
           "unknown key '" + std::string(key) + "'",
           "keys are filters, window, energy, scales");
  }
}

void ApplyText(std::string_view whole, std::string_view text, FeatureSpec& spec) {
  while (!text.empty()) {
    std::string_view value = TakeWord(text, ',');
    if (value.find('=') == std::string_view::npos) {
      const auto* const preset = std::find_if(
          kPresets.begin(), kPresets.end(), [&](const Preset& p) { return p.name == value; });
      if (preset == kPresets.end()) {
        Refuse(whole,
               "unknown preset '" + std::string(value) + "'",
               "presets are all500, edges150, window180, edges54, saxena459");
      }
      ApplyText(whole, preset->text, spec);
    } else {
      const std::string_view key = TakeWord(value, '=');
      ApplyPair(whole, key, value, spec);
    }
  }
}

}  // namespace

bool FeatureSpec::NeedsColour() const noexcept {
  return std::any_of(filters.begin(), filters.end(), [](Filter filter) {
    return static_cast<int>(filter) >= kNumIntensityFilters;
  });
}

FeatureSpec ParseFeatureSpec(std::string_view text) {
  FeatureSpec spec;
  ApplyText(text, text, spec);
  const std::string_view fault = FaultOf(spec);
  if (!fault.empty()) {
    Refuse(text, std::string(fault), "for example all500 or filters=edges+laplacian,window=3");
  }
  return spec;
}

std::string ToString(const FeatureSpec& spec) {
  std::string text = "filters=";
  const char* separator = "";
  for (const Filter filter : spec.filters) {
    text += std::exchange(separator, "+") + std::string(NameOf(filter));
  }
  text += ",window=" + std::to_string(spec.window);
  text += ",energy=" + std::string(NameOf(spec.energy));
  text += ",scales=";
  if (spec.scales.empty()) text += "none";
  separator = "";
  for (const int scale : spec.scales) text += std::exchange(separator, "+") + std::to_string(scale);
  return text;
}

std::string_view FaultOf(const FeatureSpec& spec) noexcept {
  if (spec.filters.empty()) return "no filters";
  if (spec.filters.size() > kNumFilters) return "a filter is named twice";
  std::array<bool, kNumFilters> seen{};
  for (const Filter filter : spec.filters) {
    const auto index = static_cast<std::size_t>(filter);
    if (index >= seen.size()) return "unknown filter number";
    if (std::exchange(seen[index], true)) return "a filter is named twice";
  }
  if (spec.window != 1 && spec.window != 3 && spec.window != 5) return "window must be 1, 3 or 5";
  if (static_cast<std::size_t>(spec.energy) >= kEnergyNames.size()) return "unknown energy number";
  int previous = 1;
  for (const int scale : spec.scales) {
    if (scale <= previous || scale > 16) return "scales must be ascending numbers from 2 to 16";
    previous = scale;
  }
  return {};
}

std::string_view NameOf(Energy energy) noexcept {
  return kEnergyNames[static_cast<std::size_t>(energy)];
}

std::string FeatureName(const FeatureSpec& spec, int index) {
  HC_CHECK(index >= 0 && index < spec.NumFeatures(), index, spec.NumFeatures());
  const int filter_index = index % spec.NumFilters();
  const int position = index / spec.NumFilters();
  const std::string name(NameOf(spec.filters[static_cast<std::size_t>(filter_index)]));
  const int num_window = spec.window * spec.window;
  if (position >= num_window) {
    const int scale = spec.scales[static_cast<std::size_t>(position - num_window)];
    return name + "@1/" + std::to_string(scale);
  }
  const int radius = spec.window / 2;
  return name + "@(" + std::to_string(position % spec.window - radius) + "," +
         std::to_string(position / spec.window - radius) + ")";
}

}  // namespace handcraft::features
