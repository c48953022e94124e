// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "lib/core/image.h"
#include "lib/core/rng.h"

namespace handcraft::synthetic {

/// What turns light into numbers.
struct SensorModel {
  float mean_exposure = 0.2F;  ///< mean linear value of the picture, full scale is 1
  float read_noise = 1.0F;     ///< standard deviation in the dark [8-bit steps]
  float shot_noise = 0.01F;    ///< variance that a step of signal adds [8-bit steps]
  float blur_px = 0.5F;        ///< standard deviation of the lens's and the mosaic's blur; 0: none
};

/// The picture that a sensor gives of linear red, green and blue: blurred, exposed so that its mean
/// is as asked, highlights above 0.7 compressed, coded as sRGB (IEC 61966-2-1), with independent
/// normal noise on every value. 8 bits; blue, green, red.
[[nodiscard]] Image Develop(const FloatImage& light, const SensorModel& sensor, Rng& rng);

}  // namespace handcraft::synthetic
