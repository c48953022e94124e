// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/labelled_pixels.h"

#include <cstdint>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "lib/core/error.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/progress_bar.h"

namespace handcraft::tools {
namespace {

void AddSamplingOptions(CLI::App& command, datasets::SamplingOptions& sampling) {
  const std::string group = "Sampling";
  AddNumber(command,
            "--samples",
            sampling,
            &datasets::SamplingOptions::num_samples,
            "Pixels to draw in all; 0: every one")
      ->group(group);
  AddNumber(command,
            "--bad-per-good",
            sampling,
            &datasets::SamplingOptions::bad_per_good,
            "Bad pixels for each good one")
      ->group(group);
  AddNumber(command,
            "--image-share",
            sampling,
            &datasets::SamplingOptions::image_share,
            "Share of the images to use, (0, 1]")
      ->group(group);
  CLI::Option* share = AddNumber(command,
                                 "--hard-negatives",
                                 sampling,
                                 &datasets::SamplingOptions::hard_negative_share,
                                 "Share of the bad pixels to draw near good ones, [0, 1]");
  share->group(group);
  AddNumber(command,
            "--hard-negative-radius",
            sampling,
            &datasets::SamplingOptions::hard_negative_radius_px,
            "… no farther than this from a good one [px]")
      ->needs(share)
      ->group(group);
}

std::size_t NumImages(const std::vector<datasets::PixelSample>& pixels) {
  std::set<std::uint32_t> images;
  for (const datasets::PixelSample& pixel : pixels) images.insert(pixel.image);
  return images.size();
}

// The images may not have as many good pixels as were asked for; rounding is not worth a word.
void WarnOfFewSamples(const datasets::SamplingOptions& sampling,
                      std::size_t num_samples,
                      const Console& console) {
  if (num_samples >= sampling.num_samples / 100 * 99) return;
  console.Warn(fmt::format(
      "{} samples were asked for; the images give {}", sampling.num_samples, num_samples));
}

}  // namespace

void AddLabelledPixelsOptions(CLI::App& command, LabelledPixelsOptions& options) {
  command.add_option("DATASET", options.dataset, "Folder with manifest.csv")->required();
  command
      .add_option("--features",
                  options.features,
                  "all500, edges150, window180, edges54 or saxena459, then changes such as "
                  "energy=square|abs|log, window=3, filters=edges+laplacian")
      ->type_name("SPEC")
      ->capture_default_str();
  command.add_option("--split", options.split, "Split to take pixels from; '' for all images")
      ->capture_default_str();
  AddSeedOption(command, options.sampling.seed);
  AddThreadsOption(command, options.sampling.num_threads);
  AddSamplingOptions(command, options.sampling);
}

void RefuseUnreadOptions(const CLI::App& command, const LabelledPixelsOptions& options) {
  if (options.sampling.num_samples > 0) return;
  for (const char* name : {"--bad-per-good", "--hard-negatives"}) {
    if (command.count(name) == 0) continue;
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = std::string(name) + " says which pixels to draw: --samples 0 takes all"});
  }
}

LabelledPixels DrawLabelledPixels(const LabelledPixelsOptions& options,
                                  const datasets::LabelledImageSet& whole_set,
                                  const Console& console) {
  LabelledPixels pixels{.spec = features::ParseFeatureSpec(options.features),
                        .set = whole_set.Only(options.split),
                        .num_images = 0,
                        .samples = {}};
  std::vector<std::string> left_out;
  datasets::SamplingOptions sampling = options.sampling;
  sampling.left_out = [&](const std::string& image, std::string_view reason) {
    left_out.push_back(fmt::format("left out: {}, {}", image, reason));
  };
  {
    ProgressBar bar(console);
    sampling.progress = bar.Callback();
    const auto drawn = datasets::DrawSamples(pixels.set, sampling);
    pixels.num_images = NumImages(drawn);
    pixels.samples = datasets::ComputeSampleFeatures(pixels.set, drawn, pixels.spec, sampling);
  }
  for (const std::string& warning : left_out) console.Warn(warning);
  WarnOfFewSamples(sampling, pixels.samples.num_samples(), console);
  return pixels;
}

}  // namespace handcraft::tools
