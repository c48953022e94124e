// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "datasets/synthetic/draw.h"
#include "lib/core/check.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

// 32 mixed bits (Wellons' lowbias32) of a lattice point, as a number in [0, 1).
float Lattice(std::int32_t x, std::int32_t y, std::int32_t z) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8da6b343U ^
                    static_cast<std::uint32_t>(y) * 0xd8163841U ^
                    static_cast<std::uint32_t>(z) * 0xcb1ab31fU;
  h = (h ^ (h >> 16U)) * 0x7feb352dU;
  h = (h ^ (h >> 15U)) * 0x846ca68bU;
  h ^= h >> 16U;
  return static_cast<float>(h >> 8U) * 0x1p-24F;
}

float Ease(float t) { return t * t * (3.0F - 2.0F * t); }
float Mix(float a, float b, float t) { return a + t * (b - a); }
Colour Mix(const Colour& a, const Colour& b, float t) { return a + t * (b - a); }

float Step(float low, float high, float value) {
  return Ease(std::clamp((value - low) / (high - low), 0.0F, 1.0F));
}

float Fract(float value) { return value - std::floor(value); }

float WoodTone(const Vector3f& at) {
  const Vector3f along(0.06F * at.x(), at.y(), at.z());
  const float warp = FractalNoise(along, 2);
  const float rings = Fract(0.9F * at.y() + 2.5F * warp);
  const float fibres = ValueNoise({0.4F * at.x(), 14.0F * at.y(), 14.0F * at.z()});
  return 0.65F * std::abs(2.0F * rings - 1.0F) * warp + 0.35F * fibres;
}

float CheckTone(const Vector3f& at) {
  const float columns = Step(0.45F, 0.55F, std::abs(2.0F * Fract(0.5F * at.x()) - 1.0F));
  const float rows = Step(0.45F, 0.55F, std::abs(2.0F * Fract(0.5F * at.y()) - 1.0F));
  const float threads = ValueNoise({16.0F * at.x(), 16.0F * at.y(), 0.0F});
  return 0.4F * (columns + rows) + 0.2F * threads;
}

// Lines of words: blots where both the line and the noise along it say so.
float PrintTone(const Vector3f& at) {
  const float line = std::floor(at.y());
  const float in_line = Step(0.25F, 0.4F, 0.5F - std::abs(Fract(at.y()) - 0.5F));
  const float words = Step(0.35F, 0.45F, ValueNoise({0.45F * at.x(), 7.3F * line, 0.5F}));
  const float letters = Step(0.35F, 0.5F, ValueNoise({2.7F * at.x(), 2.7F * at.y(), 9.5F}));
  const float column = Step(0.3F, 0.32F, ValueNoise({0.03F * at.x(), 0.05F * at.y(), 3.5F}));
  return in_line * words * letters * column;
}

// What is printed round a package. Noise along z divides it into zones: a band, an emblem, text.
float LabelTone(const Vector3f& at) {
  const float along = at.x() - at.y();  // runs round whatever stands about the z axis
  const float zone = ValueNoise({0.5F, 0.5F, 0.16F * at.z()});
  if (zone > 0.66F) return 1.0F;
  const float emblem = ValueNoise({0.22F * along, 5.5F, 0.3F * at.z()});
  if (zone > 0.42F) return 0.85F * Step(0.55F, 0.58F, emblem);
  return PrintTone({along, at.z(), 0.0F});
}

float Tone(Pattern pattern, const Vector3f& at) {
  switch (pattern) {
    case Pattern::kPlain:
      return 0.25F * ValueNoise(at);
    case Pattern::kSpeckled:
      return Step(0.6F, 0.75F, ValueNoise(2.0F * at)) + 0.15F * FractalNoise(0.2F * at, 3);
    case Pattern::kStripes:
      return Step(0.45F, 0.5F, std::abs(2.0F * Fract(0.5F * at.z()) - 1.0F));
    case Pattern::kWood:
      return WoodTone(at);
    case Pattern::kChecks:
      return CheckTone(at);
    case Pattern::kPrint:
      return PrintTone(at);
    case Pattern::kLabel:
      return LabelTone(at);
  }
  HC_CHECK(false, static_cast<int>(pattern));
  return 0.0F;
}

}  // namespace

float ValueNoise(const Vector3f& at) {
  const Vector3f whole = at.array().floor();
  const auto x = static_cast<std::int32_t>(whole.x());
  const auto y = static_cast<std::int32_t>(whole.y());
  const auto z = static_cast<std::int32_t>(whole.z());
  const float tx = Ease(at.x() - whole.x());
  const float ty = Ease(at.y() - whole.y());
  const float tz = Ease(at.z() - whole.z());
  const auto layer = [&](std::int32_t k) {
    return Mix(Mix(Lattice(x, y, k), Lattice(x + 1, y, k), tx),
               Mix(Lattice(x, y + 1, k), Lattice(x + 1, y + 1, k), tx),
               ty);
  };
  return Mix(layer(z), layer(z + 1), tz);
}

float FractalNoise(const Vector3f& at, int octaves) {
  float sum = 0.0F;
  float weight = 1.0F;
  float weights = 0.0F;
  float frequency = 1.0F;
  for (int i = 0; i < octaves; ++i) {
    sum += weight * ValueNoise(frequency * at);
    weights += weight;
    weight *= 0.5F;
    frequency *= 2.0F;
  }
  return sum / weights;
}

Colour Albedo(const Material& material, const Vector3f& p_in_object) {
  const Vector3f at = p_in_object / material.scale_m + Vector3f::Constant(material.seed);
  return Mix(material.base, material.second, std::min(Tone(material.pattern, at), 1.0F));
}

Colour FromHsv(float hue, float saturation, float value) {
  const auto channel = [&](float shift) {
    const float ramp = std::abs(6.0F * Fract(hue + shift) - 3.0F) - 1.0F;
    return value * Mix(1.0F, std::clamp(ramp, 0.0F, 1.0F), saturation);
  };
  const Colour coded(channel(0.0F), channel(2.0F / 3.0F), channel(1.0F / 3.0F));
  return coded.array().pow(2.2F);
}

Material Painted(const Colour& colour, float specular) {
  Material material;
  material.base = colour;
  material.second = 0.92F * colour;
  material.specular = specular;
  return material;
}

Material Clear(const Colour& tint) {
  Material clear = Painted(tint, 0.04F);
  clear.transmission = 0.97F;
  clear.shininess = 500.0F;
  return clear;
}

Material DrawMetal(Rng& rng) {
  Material metal = Painted(Colour::Constant(Between(rng, 0.15F, 0.35F)), 0.35F);
  metal.shininess = Between(rng, 20.0F, 80.0F);
  return metal;
}

Material DrawGlaze(Rng& rng) {
  constexpr std::array<Pattern, 4> kPatterns = {
      Pattern::kPlain, Pattern::kPlain, Pattern::kSpeckled, Pattern::kStripes};
  Material glaze;
  const bool is_white = Chance(rng, 0.35);
  glaze.base = FromHsv(Between(rng, 0.0F, 1.0F),
                       is_white ? Between(rng, 0.0F, 0.1F) : Between(rng, 0.3F, 0.9F),
                       is_white ? Between(rng, 0.82F, 0.95F) : Between(rng, 0.3F, 0.9F));
  glaze.second =
      FromHsv(Between(rng, 0.0F, 1.0F), Between(rng, 0.1F, 0.8F), Between(rng, 0.2F, 0.9F));
  glaze.pattern = kPatterns[rng.UniformInt(kPatterns.size())];
  if (glaze.pattern == Pattern::kPlain) glaze.second = 0.8F * glaze.base;
  glaze.scale_m = glaze.pattern == Pattern::kStripes ? Between(rng, 0.008F, 0.03F)
                                                     : Between(rng, 0.002F, 0.006F);
  glaze.specular = Between(rng, 0.03F, 0.06F);
  glaze.shininess = Between(rng, 60.0F, 600.0F);
  glaze.seed = Between(rng, 0.0F, 500.0F);
  return glaze;
}

Material DrawPlastic(Rng& rng) {
  Material plastic = DrawGlaze(rng);
  plastic.pattern = Pattern::kPlain;
  plastic.second = 0.85F * plastic.base;
  plastic.specular = Between(rng, 0.02F, 0.05F);
  plastic.shininess = Between(rng, 15.0F, 90.0F);
  return plastic;
}

Material DrawTableTop(Rng& rng) {
  constexpr std::array<Pattern, 5> kPatterns = {
      Pattern::kWood, Pattern::kWood, Pattern::kSpeckled, Pattern::kChecks, Pattern::kPlain};
  Material table;
  table.pattern = kPatterns[rng.UniformInt(kPatterns.size())];
  const bool is_wood = table.pattern == Pattern::kWood;
  const float hue = is_wood ? Between(rng, 0.05F, 0.1F) : Between(rng, 0.0F, 1.0F);
  const float saturation = is_wood ? Between(rng, 0.3F, 0.65F) : Between(rng, 0.02F, 0.3F);
  const float value = Between(rng, 0.4F, 0.85F);
  table.base = FromHsv(hue, saturation, value);
  table.second = FromHsv(hue, saturation, value * Between(rng, 0.45F, 0.8F));
  const bool is_woven = table.pattern == Pattern::kChecks;
  table.scale_m = is_wood || is_woven ? Between(rng, 0.012F, 0.035F) : Between(rng, 0.002F, 0.005F);
  table.specular = is_woven ? 0.0F : Between(rng, 0.005F, 0.04F);
  table.shininess = Between(rng, 10.0F, 60.0F);
  table.seed = Between(rng, 0.0F, 500.0F);
  return table;
}

Material DrawBackground(Rng& rng) {
  Material background;
  background.pattern = Pattern::kSpeckled;
  background.base =
      FromHsv(Between(rng, 0.0F, 1.0F), Between(rng, 0.0F, 0.3F), Between(rng, 0.25F, 0.8F));
  background.second = Between(rng, 0.85F, 0.97F) * background.base;
  background.scale_m = Between(rng, 0.02F, 0.2F);
  background.specular = 0.0F;
  background.seed = Between(rng, 0.0F, 500.0F);
  return background;
}

}  // namespace handcraft::synthetic
