// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string_view>

#include "datasets/formats/organised_cloud.h"
#include "datasets/synthetic/renderer.h"
#include "lib/core/image.h"

namespace handcraft::synthetic {

/// What measures the cloud that belongs to a picture.
enum class CloudSensor {
  kStereo,               ///< two cameras, semi-global matching: StereoOptions as they are
  kStereoBlockMatching,  ///< two cameras, block matching
  kStereoActive,         ///< as kStereo, with a projector of dots
  kDepthCamera,          ///< DepthCameraOptions as they are
  kPerfect,              ///< every pixel's true depth
};

/// Its name on the command line and in dataset.toml: stereo, stereo-bm, stereo-active,
/// depth-camera, perfect.
[[nodiscard]] std::string_view NameOf(CloudSensor sensor);

/// A scene as its camera takes it, with all that is known about it.
struct MeasuredView {
  View view;
  Image image;
  datasets::OrganisedCloud cloud;
};

/// Takes the scene's picture and measures its cloud. `baseline_m`, in (0, 1], is that of the stereo
/// sensors. Noise is drawn from streams of (seed, name): same arguments, same bytes; uses one
/// thread.
[[nodiscard]] MeasuredView MeasureView(const Scene& scene,
                                       CloudSensor sensor,
                                       float baseline_m,
                                       std::uint64_t seed,
                                       std::string_view name);

}  // namespace handcraft::synthetic
