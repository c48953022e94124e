// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/tools/support/generated_data.h"

#include <cmath>
#include <iterator>

#include <gtest/gtest.h>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "tests/datasets/small_image_set.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools::testing {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;

// Distance from the object's middle: a bar is long in u, a disc is round.
double DistanceFromObject(bool is_bar, double du, double dv) {
  return std::hypot(is_bar ? du / 3.0 : du, dv);
}

datasets::LabelledPicture DrawPicture(int index, int channels) {
  Rng rng = Rng::Stream(1, "tools test picture", static_cast<std::uint64_t>(index));
  const double centre_u = 20.0 + 24.0 * rng.Uniform();
  const double centre_v = 16.0 + 16.0 * rng.Uniform();
  datasets::LabelledPicture picture{Image(kWidth, kHeight, channels), Image(kWidth, kHeight)};
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const double distance = DistanceFromObject(index % 2 == 0, u - centre_u, v - centre_v);
      const double brightness = distance < 6.0 ? 180.0 : 90.0;
      for (int channel = 0; channel < channels; ++channel) {
        picture.image.At(u, v, channel) =
            static_cast<std::uint8_t>(brightness + 10.0 * channel + 40.0 * rng.Uniform());
      }
      picture.mask.At(u, v) = distance < 3.0   ? datasets::kMaskGood
                              : distance < 6.0 ? datasets::kMaskDontCare
                                               : datasets::kMaskBad;
    }
  }
  return picture;
}

}  // namespace

void WriteImageSet(const std::filesystem::path& folder, int channels) {
  std::filesystem::create_directories(folder);
  datasets::LabelledImageSet set{.root = folder, .items = {}};
  for (int i = 0; i < 6; ++i) {
    const datasets::LabelledPicture picture = DrawPicture(i, channels);
    const std::string name = "p" + std::to_string(i);
    handcraft::testing::AddPicture(
        set, name, picture.image, picture.mask, i < 4 ? "train" : "test");
    set.items.back().object_class = i % 2 == 0 ? "bar" : "disc";
  }
  datasets::WriteManifest(set);
}

void WriteTable(const std::filesystem::path& path) {
  Rng rng(7);
  std::string text = "x1,x2,class\n";
  for (int i = 0; i < 60; ++i) {
    const double x1 = rng.Normal();
    const double x2 = rng.Normal();
    const bool yes = x1 - 0.5 * x2 + rng.Normal() > 0.0;
    text += NumberToText(x1) + "," + NumberToText(x2) + (yes ? ",yes\n" : ",no\n");
  }
  WriteFileAtomically(path, text);
}

void TrainGraspPoints(const std::filesystem::path& dataset,
                      const std::filesystem::path& model,
                      const std::string& features) {
  const Outcome outcome = RunArgs({"train",
                                   "grasp-points",
                                   dataset.string(),
                                   "--out",
                                   model.string(),
                                   "--features",
                                   features,
                                   "--samples",
                                   "400",
                                   "--ridge",
                                   "1"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
}

void TrainLogistic(const std::filesystem::path& table, const std::filesystem::path& model) {
  const Outcome outcome =
      RunArgs({"train", "logistic", table.string(), "--label", "class", "--out", model.string()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
}

std::size_t NumEntries(const std::filesystem::path& folder) {
  using Iterator = std::filesystem::directory_iterator;
  return static_cast<std::size_t>(std::distance(Iterator(folder), Iterator()));
}

}  // namespace handcraft::tools::testing
