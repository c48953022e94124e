// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "lib/core/rng.h"

namespace handcraft::synthetic {

/// Linear red, green, blue; 1 reflects all light.
using Colour = Eigen::Vector3f;

enum class Pattern {
  kPlain,     ///< one colour, faintly uneven
  kSpeckled,  ///< grains of the second colour, as in stoneware and laminate
  kStripes,   ///< bands across z
  kWood,      ///< grain along x
  kChecks,    ///< woven squares in x and y
  kPrint,     ///< lines of blots in x and y, as text and pictures on paper
  kLabel,     ///< bands, emblems and lines of text across z, as on a package that stands
};

/// How a surface looks. Patterns are functions of the point in the object's own frame [m].
struct Material {
  Colour base = Colour::Constant(0.7F);
  Colour second = Colour::Constant(0.3F);
  Pattern pattern = Pattern::kPlain;
  float scale_m = 0.01F;      ///< size of the pattern's elements
  float specular = 0.04F;     ///< share of light mirrored at normal incidence, 0 ... 1
  float shininess = 40.0F;    ///< exponent of the highlight (Blinn and Phong)
  float transmission = 0.0F;  ///< share of what is not mirrored that goes on straight through
  float seed = 0.0F;          ///< shifts the pattern [elements]
};

/// Smooth noise in [0, 1]: random values at whole coordinates, cubic in between. Pure function.
[[nodiscard]] float ValueNoise(const Eigen::Vector3f& at);

/// Σ ValueNoise(2ⁱ at) / 2ⁱ over `octaves`, scaled to [0, 1].
[[nodiscard]] float FractalNoise(const Eigen::Vector3f& at, int octaves);

/// Share of light that the material scatters at a point.
[[nodiscard]] Colour Albedo(const Material& material, const Eigen::Vector3f& p_in_object);

/// A colour of the given hue [turns], saturation and value, each 0 ... 1, made linear.
[[nodiscard]] Colour FromHsv(float hue, float saturation, float value);

/// One colour, as even as paint.
[[nodiscard]] Material Painted(const Colour& colour, float specular);

/// Bare metal, gray.
[[nodiscard]] Material DrawMetal(Rng& rng);

/// Thin clear glass or plastic of this tint: light goes on straight through, but for Fresnel's
/// share and a little that is scattered.
[[nodiscard]] Material Clear(const Colour& tint);

/// Glazed pottery or painted plastic of a random colour.
[[nodiscard]] Material DrawGlaze(Rng& rng);
[[nodiscard]] Material DrawPlastic(Rng& rng);

/// A table top, and what lies under it and behind it.
[[nodiscard]] Material DrawTableTop(Rng& rng);
[[nodiscard]] Material DrawBackground(Rng& rng);

}  // namespace handcraft::synthetic
