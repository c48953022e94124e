// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "datasets/formats/labelled_image_set.h"
#include "lib/features/feature_spec.h"
#include "lib/model_io/linear_models.h"
#include "lib/perception/image_io.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::testing {

struct FreeModel {
  void operator()(hc_model* model) const noexcept { hc_model_free(model); }
};
using ModelOwner = std::unique_ptr<hc_model, FreeModel>;

inline ModelOwner LoadModelFile(const model_io::ModelFile& file) {
  const std::vector<std::uint8_t> bytes = model_io::Serialise(file);
  hc_model* model = nullptr;
  hc_error error{};
  if (hc_model_load_memory(bytes.data(), bytes.size(), &model, &error) != HC_OK) {
    throw std::logic_error(error.message);
  }
  return ModelOwner(model);
}

/// One feature, the length of the vertical edge filter's response. On a step from black to white it
/// is 0.5 at the two pixels that touch, 0.25 one pixel farther and 0 beyond, so that with weight 40
/// and intercept −15 the probabilities are 0.9933, 0.0067 and 3e−7.
inline ModelOwner MakeEdgeModel() {
  return LoadModelFile(model_io::MakeGraspPointModel(
      features::ParseFeatureSpec("filters=edge_0,window=1,energy=abs"),
      {.weights = {40.0}, .intercept = -15.0, .feature_mean = {}, .feature_scale = {}},
      {.name = "edge <model>"}));
}

inline constexpr int kEdgeWidth = 40;
inline constexpr int kEdgeHeight = 20;

/// White between columns [first, last), black elsewhere.
inline Image MakeBand(int first, int last) {
  Image image(kEdgeWidth, kEdgeHeight);
  for (int v = 0; v < kEdgeHeight; ++v) {
    for (int u = first; u < last; ++u) image.At(u, v) = 255;
  }
  return image;
}

/// Two columns good from good_first on, two bad from bad_first on, the rest don't care.
inline Image MakeStripes(int good_first, int bad_first) {
  Image mask(kEdgeWidth, kEdgeHeight, 1, datasets::kMaskDontCare);
  for (int v = 0; v < kEdgeHeight; ++v) {
    for (const int u : {0, 1}) {
      mask.At(good_first + u, v) = datasets::kMaskGood;
      mask.At(bad_first + u, v) = datasets::kMaskBad;
    }
  }
  return mask;
}

/// Five pictures whose scores are known; 800 pixels each.
///   right    one edge, labelled good                  15 of 15 best pixels good
///   half     two edges, the left one labelled bad     7 of 15 (row by row: two bad, two good)
///   flat     no edge                                  no pixel above 0.9
///   nocare   one edge, on don't-care ground           15 don't care
///   bad      one edge, everything labelled bad        0 of 15
inline datasets::LabelledImageSet WriteEdgeSet(const std::filesystem::path& root) {
  datasets::LabelledImageSet set{.root = root, .items = {}};
  const auto add = [&](const std::string& name,
                       const std::string& object_class,
                       const Image& image,
                       const Image& mask) {
    perception::WritePng(root / (name + ".png"), image);
    perception::WritePng(root / (name + "_mask.png"), mask);
    set.items.push_back({name + ".png", name + "_mask.png", object_class, name, "test", "CC0-1.0"});
  };
  add("right", "edge", MakeBand(20, 40), MakeStripes(19, 0));
  add("half", "edge", MakeBand(11, 30), MakeStripes(29, 10));
  add("flat", "other", MakeBand(0, 40), MakeStripes(5, 0));
  add("nocare", "other", MakeBand(20, 40), MakeStripes(5, 0));
  add("bad", "other", MakeBand(20, 40), Image(kEdgeWidth, kEdgeHeight, 1, datasets::kMaskBad));
  return set;
}

}  // namespace handcraft::testing
