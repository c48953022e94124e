// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/grasp_point_samples.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <utility>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "datasets/parallel_reporting.h"
#include "datasets/sample_quotas.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/memory.h"
#include "lib/core/option_rules.h"
#include "lib/core/rng.h"
#include "lib/features/pixel_features.h"
#include "lib/perception/image_header.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

using PixelIndex = std::uint32_t;  // row · width + column

// The images used, as indices: all those of a share of the instances, drawn by seed. A greater
// share takes the same instances and more.
std::vector<std::size_t> ChooseImages(const LabelledImageSet& set, const SamplingOptions& options) {
  std::set<std::string> distinct;
  for (const LabelledImage& item : set.items) distinct.insert(item.instance);
  std::vector<std::string> instances(distinct.begin(), distinct.end());
  Rng::Stream(options.seed, "instances").Shuffle(std::span(instances));
  const auto wanted = std::lround(options.image_share * static_cast<double>(instances.size()));
  instances.resize(std::min(instances.size(), static_cast<std::size_t>(std::max(wanted, 1L))));
  const std::set<std::string> chosen(instances.begin(), instances.end());

  std::vector<std::size_t> images;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    if (chosen.contains(set.items[i].instance)) images.push_back(i);
  }
  return images;
}

PixelCounts CountPixels(const Image& mask) {
  const auto count = [&](std::uint8_t value) {
    return static_cast<std::size_t>(std::count(mask.values().begin(), mask.values().end(), value));
  };
  return {.good = count(kMaskGood), .bad = count(kMaskBad)};
}

// Throws when the picture's file is at fault or has another size than its mask. The header has the
// size before a rotation tag is applied: a picture that may have one is decoded to be sure.
void CheckPicture(const LabelledImageSet& set, std::size_t index, const Image& mask) {
  const std::filesystem::path path = set.root / set.items[index].image;
  const perception::ImageHeader header = perception::ReadImageHeader(path, ReadFile(path));
  const bool fits = header.width == mask.width() && header.height == mask.height();
  if (fits && !header.may_turn) return;
  static_cast<void>(ReadLabelledPicture(set, index));
}

void TellLeftOut(const LabelledImageSet& set,
                 const std::vector<std::size_t>& images,
                 const std::vector<PixelCounts>& available,
                 const SamplingOptions& options) {
  if (!options.left_out) return;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const auto [good, bad] = available[i];
    if (good > 0 && bad > 0) continue;
    options.left_out(set.items[images[i]].image,
                     good > 0  ? "no bad pixel"
                     : bad > 0 ? "no good pixel"
                               : "no good and no bad pixel");
  }
}

std::vector<PixelIndex> PixelsOf(const Image& mask, std::uint8_t value) {
  std::vector<PixelIndex> pixels;
  for (std::size_t i = 0; i < mask.values().size(); ++i) {
    if (mask.values()[i] == value) pixels.push_back(static_cast<PixelIndex>(i));
  }
  return pixels;
}

// Those of `pixels` that are no farther from a good pixel than `radius_px`.
std::vector<PixelIndex> NearGood(const Image& mask,
                                 const std::vector<PixelIndex>& pixels,
                                 int radius_px) {
  cv::Mat not_good(mask.height(), mask.width(), CV_8U);
  for (std::size_t i = 0; i < mask.values().size(); ++i) {
    not_good.data[i] = mask.values()[i] == kMaskGood ? 0 : 1;
  }
  cv::Mat distance_px;
  cv::distanceTransform(not_good, distance_px, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const auto* const distances = distance_px.ptr<float>();
  std::vector<PixelIndex> near;
  std::copy_if(pixels.begin(), pixels.end(), std::back_inserter(near), [&](PixelIndex pixel) {
    return distances[pixel] <= static_cast<float>(radius_px);
  });
  return near;
}

// Moves `count` random entries that are not `taken` yet to the result and marks them: the first of
// a random order that does not depend on `count` (Fisher–Yates, as far as it is needed).
std::vector<PixelIndex> TakeRandom(std::vector<PixelIndex>& pixels,
                                   std::size_t count,
                                   Rng rng,
                                   std::vector<bool>& taken) {
  std::vector<PixelIndex> drawn;
  for (std::size_t i = 0; i < pixels.size() && drawn.size() < count; ++i) {
    std::swap(pixels[i], pixels[i + rng.UniformInt(pixels.size() - i)]);
    if (taken[pixels[i]]) continue;
    taken[pixels[i]] = true;
    drawn.push_back(pixels[i]);
  }
  return drawn;
}

std::vector<PixelIndex> DrawBad(const Image& mask,
                                const std::string& name,
                                std::size_t count,
                                const SamplingOptions& options) {
  std::vector<PixelIndex> bad = PixelsOf(mask, kMaskBad);
  std::vector<bool> taken(mask.values().size());
  std::vector<PixelIndex> drawn;
  if (options.hard_negative_share > 0.0) {
    std::vector<PixelIndex> near = NearGood(mask, bad, options.hard_negative_radius_px);
    const auto num_hard = static_cast<std::size_t>(
        std::llround(options.hard_negative_share * static_cast<double>(count)));
    drawn = TakeRandom(near, num_hard, Rng::Stream(options.seed, "hard negatives " + name), taken);
  }
  const std::vector<PixelIndex> others =
      TakeRandom(bad, count - drawn.size(), Rng::Stream(options.seed, "bad pixels " + name), taken);
  drawn.insert(drawn.end(), others.begin(), others.end());
  return drawn;
}

std::vector<PixelSample> DrawFromImage(const LabelledImageSet& set,
                                       std::size_t index,
                                       const PixelCounts& quota,
                                       const SamplingOptions& options) {
  const Image mask = ReadMask(set, index);
  const std::string& name = set.items[index].image;
  std::vector<PixelIndex> good = PixelsOf(mask, kMaskGood);
  std::vector<bool> taken(mask.values().size());
  std::vector<PixelIndex> pixels =
      TakeRandom(good, quota.good, Rng::Stream(options.seed, "good pixels " + name), taken);
  const std::vector<PixelIndex> bad = DrawBad(mask, name, quota.bad, options);
  pixels.insert(pixels.end(), bad.begin(), bad.end());
  std::sort(pixels.begin(), pixels.end());

  std::vector<PixelSample> samples;
  samples.reserve(pixels.size());
  const auto width = static_cast<PixelIndex>(mask.width());
  for (const PixelIndex pixel : pixels) {
    samples.push_back(
        {.image = static_cast<std::uint32_t>(index),
         .u_px = static_cast<std::uint16_t>(pixel % width),
         .v_px = static_cast<std::uint16_t>(pixel / width),
         .label = mask.values()[pixel] == kMaskGood ? std::uint8_t{1} : std::uint8_t{0}});
  }
  return samples;
}

void CheckQuotas(const LabelledImageSet& set,
                 const std::vector<PixelCounts>& available,
                 const std::vector<PixelCounts>& quotas,
                 const SamplingOptions& options) {
  const bool any = std::any_of(available.begin(), available.end(), [](const PixelCounts& counts) {
    return counts.good > 0 && counts.bad > 0;
  });
  if (!any) {
    throw Error({.path = set.root.string(),
                 .reason = "none of " + std::to_string(available.size()) +
                           " images has both good and bad pixels in its mask",
                 .remedy = "handcraft data check tells which masks are at fault"});
  }
  PixelCounts sum;
  for (const PixelCounts& quota : quotas) sum = {sum.good + quota.good, sum.bad + quota.bad};
  if (sum.good > 0 && sum.bad > 0) return;
  throw Error({.kind = Error::Kind::kUsage,
               .path = set.root.string(),
               .reason = NumberToText(options.num_samples) + " samples with " +
                         NumberToText(options.bad_per_good) +
                         " bad ones for each good one leave no " +
                         (sum.good == 0 ? "good" : "bad") + " pixel",
               .remedy = "ask for more samples or another ratio"});
}

// Before they are allocated: whether so many samples fit into memory.
void RequireMemoryFor(std::size_t num_samples,
                      std::size_t bytes_a_sample,
                      const char* what,
                      const SamplingOptions& options) {
  const auto available = options.memory ? options.memory : AvailableMemory();
  RequireMemory(std::uint64_t{num_samples} * bytes_a_sample,
                available,
                std::string(what) + " of " + NumberToText(num_samples) + " samples",
                "use at most " + NumberToText(available.value_or(0) / bytes_a_sample) +
                    " samples, or fewer features");
}

// The features of the samples of one image, each into its own row.
void GatherRows(const LabelledImageSet& set,
                std::span<const PixelSample> samples,
                const features::FeatureSpec& spec,
                std::span<float> rows) {
  const std::size_t image_index = samples.front().image;
  HC_CHECK(image_index < set.items.size(), image_index, set.items.size());
  const std::filesystem::path path = set.root / set.items[image_index].image;
  const Image image = ReadLabelledPicture(set, image_index).image;  // checks that the mask fits
  if (spec.NeedsColour() && image.channels() == 1) {
    throw Error({.path = path.string(),
                 .reason = "a gray picture, but the features look at colour",
                 .remedy = "leave out the filters cb_LL and cr_LL"});
  }
  const features::PixelFeatures features(perception::RawView(image), spec);
  const std::size_t num_features = rows.size() / samples.size();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const PixelSample& sample = samples[i];
    HC_CHECK(sample.u_px < image.width() && sample.v_px < image.height(),
             sample.u_px,
             sample.v_px,
             path.string());
    features.Gather(sample.u_px, sample.v_px, rows.subspan(i * num_features, num_features));
  }
}

}  // namespace

void SamplingOptions::Validate() const {
  RequireOption(bad_per_good > 0.0 && std::isfinite(bad_per_good),
                "SamplingOptions.bad_per_good",
                bad_per_good,
                "greater than 0");
  RequireOption(image_share > 0.0 && image_share <= 1.0,
                "SamplingOptions.image_share",
                image_share,
                "in (0, 1]");
  RequireOption(hard_negative_share >= 0.0 && hard_negative_share <= 1.0,
                "SamplingOptions.hard_negative_share",
                hard_negative_share,
                "in [0, 1]");
  RequireOption(hard_negative_radius_px >= 1,
                "SamplingOptions.hard_negative_radius_px",
                hard_negative_radius_px,
                "1 or more");
  RequireOption(num_threads >= 1, "SamplingOptions.num_threads", num_threads, "1 or more");
}

std::vector<PixelSample> DrawSamples(const LabelledImageSet& set, const SamplingOptions& options) {
  options.Validate();
  const std::vector<std::size_t> images = ChooseImages(set, options);
  const auto for_each_image = [&](const char* stage, const auto& task) {
    ParallelForReporting(images.size(), options.num_threads, options.progress, stage, task);
  };
  std::vector<PixelCounts> available(images.size());
  for_each_image("counting labelled pixels", [&](std::size_t i) {
    const Image mask = ReadMask(set, images[i]);
    CheckPicture(set, images[i], mask);
    available[i] = CountPixels(mask);
  });
  const std::vector<PixelCounts> quotas =
      ShareSamples(available, options.num_samples, options.bad_per_good);
  CheckQuotas(set, available, quotas, options);
  TellLeftOut(set, images, available, options);
  std::size_t num_samples = 0;
  for (const PixelCounts& quota : quotas) num_samples += quota.good + quota.bad;
  constexpr std::size_t kCopies = 2;  // by image, then in one list
  RequireMemoryFor(num_samples, kCopies * sizeof(PixelSample), "drawing the pixels", options);

  std::vector<std::vector<PixelSample>> drawn(images.size());
  for_each_image("drawing pixels", [&](std::size_t i) {
    if (quotas[i].good + quotas[i].bad > 0) {
      drawn[i] = DrawFromImage(set, images[i], quotas[i], options);
    }
  });
  std::vector<PixelSample> samples;
  for (const std::vector<PixelSample>& part : drawn) {
    samples.insert(samples.end(), part.begin(), part.end());
  }
  return samples;
}

GraspPointSamples ComputeSampleFeatures(const LabelledImageSet& set,
                                        const std::vector<PixelSample>& samples,
                                        const features::FeatureSpec& spec,
                                        const SamplingOptions& options) {
  std::vector<std::size_t> begins;  // where the samples of each image begin, and the end
  for (std::size_t i = 0; i < samples.size(); ++i) {
    HC_CHECK(i == 0 || samples[i - 1].image <= samples[i].image, i);
    if (i == 0 || samples[i - 1].image != samples[i].image) begins.push_back(i);
  }
  const std::size_t num_images = begins.size();
  begins.push_back(samples.size());

  GraspPointSamples result;
  result.num_features = static_cast<std::size_t>(spec.NumFeatures());
  RequireMemoryFor(samples.size(),
                   result.num_features * sizeof(float) + sizeof(std::uint8_t),
                   "computing the features",
                   options);
  for (const PixelSample& sample : samples) result.labels.push_back(sample.label);
  result.features.resize(samples.size() * result.num_features);
  const auto gather = [&](std::size_t image) {
    const std::size_t begin = begins[image];
    const std::size_t count = begins[image + 1] - begin;
    GatherRows(set,
               std::span(samples).subspan(begin, count),
               spec,
               std::span(result.features)
                   .subspan(begin * result.num_features, count * result.num_features));
  };
  ParallelForReporting(
      num_images, options.num_threads, options.progress, "computing features", gather);
  return result;
}

}  // namespace handcraft::datasets
