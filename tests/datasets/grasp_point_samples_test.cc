// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/grasp_point_samples.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/features/pixel_features.h"
#include "lib/perception/image_io.h"
#include "tests/datasets/small_image_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/turned_jpeg.h"

namespace handcraft::datasets {
namespace {

using testing::AddPicture;
using ::testing::AllOf;
using testing::CountedMask;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::MakeSet;
using testing::MixedMask;
using testing::NoiseImage;
using ::testing::SizeIs;
using testing::TemporaryDirectory;
using testing::WriteTurnedJpeg;

struct Count {
  std::size_t good = 0;
  std::size_t bad = 0;
};
std::map<std::uint32_t, Count> CountByImage(const std::vector<PixelSample>& samples) {
  std::map<std::uint32_t, Count> counts;
  for (const PixelSample& sample : samples) {
    ++(sample.label == 1 ? counts[sample.image].good : counts[sample.image].bad);
  }
  return counts;
}

auto KeyOf(const PixelSample& sample) { return std::tuple(sample.image, sample.v_px, sample.u_px); }

std::vector<PixelSample> OfImage(const std::vector<PixelSample>& samples, std::uint32_t image) {
  std::vector<PixelSample> part;
  for (PixelSample sample : samples) {
    if (sample.image != image) continue;
    sample.image = 0;
    part.push_back(sample);
  }
  return part;
}

TEST(DrawSamples, BalancesImagesAndClasses) {
  const TemporaryDirectory folder;
  const auto counts = CountByImage(DrawSamples(MakeSet(folder.path()), {.num_samples = 200}));
  ASSERT_THAT(counts, SizeIs(3)) << "the image without good pixels is left out";
  EXPECT_EQ(counts.at(0).good, 40U);  // 100 good ones: b has 20, the others share the rest
  EXPECT_EQ(counts.at(1).good, 20U);
  EXPECT_EQ(counts.at(2).good, 40U);
  for (const auto& [image, count] : counts) EXPECT_EQ(count.bad, count.good);
}

// Laws, for many options: sorted, no pixel twice, labels as in the masks.
TEST(DrawSamples, DrawsEachPixelOnceWithItsLabel) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  for (const std::size_t num_samples : {0U, 2U, 77U, 300U, 100000U}) {
    for (const double ratio : {0.5, 1.0, 3.0}) {
      for (const double hard : {0.0, 0.4, 1.0}) {
        const std::vector<PixelSample> samples = DrawSamples(set,
                                                             {.num_samples = num_samples,
                                                              .bad_per_good = ratio,
                                                              .hard_negative_share = hard,
                                                              .hard_negative_radius_px = 2});
        std::map<std::uint32_t, Image> masks;
        for (std::size_t i = 0; i < samples.size(); ++i) {
          const PixelSample& sample = samples[i];
          if (i > 0) {
            EXPECT_LT(KeyOf(samples[i - 1]), KeyOf(sample));
          }
          if (!masks.contains(sample.image)) masks[sample.image] = ReadMask(set, sample.image);
          EXPECT_EQ(masks[sample.image].At(sample.u_px, sample.v_px),
                    sample.label == 1 ? kMaskGood : kMaskBad);
        }
        if (num_samples != 0) {
          EXPECT_LE(samples.size(), num_samples);
        }
      }
    }
  }
}

TEST(DrawSamples, KeepsTheRatio) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  const auto counts = CountByImage(DrawSamples(set, {.num_samples = 200, .bad_per_good = 3.0}));
  std::size_t good = 0;
  std::size_t bad = 0;
  for (const auto& [image, count] : counts) {
    EXPECT_EQ(count.bad, 3 * count.good);
    good += count.good;
    bad += count.bad;
  }
  EXPECT_EQ(good, 50U);
  EXPECT_EQ(bad, 150U);
}

TEST(DrawSamples, TakesEveryLabelledPixelWhenAskedForZero) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  std::size_t expected = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Image mask = ReadMask(set, i);
    expected +=
        mask.values().size() - static_cast<std::size_t>(std::count(
                                   mask.values().begin(), mask.values().end(), kMaskDontCare));
  }
  EXPECT_THAT(DrawSamples(set, {.num_samples = 0}), SizeIs(expected));
}

TEST(DrawSamples, DependsOnTheSeedAndNotOnTheThreads) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  const SamplingOptions options{.num_samples = 150, .hard_negative_share = 0.3, .seed = 7};
  const std::vector<PixelSample> samples = DrawSamples(set, options);
  SamplingOptions threads = options;
  threads.num_threads = 4;
  EXPECT_EQ(DrawSamples(set, threads), samples);
  SamplingOptions seed = options;
  seed.seed = 8;
  EXPECT_NE(DrawSamples(set, seed), samples);
}

TEST(DrawSamples, DrawsFromAPictureWhateverTheOthersHold) {
  const TemporaryDirectory here;
  const TemporaryDirectory there;
  const SamplingOptions options{.num_samples = 60, .hard_negative_share = 0.5};
  const LabelledImageSet set = MakeSet(here.path());
  LabelledImageSet other{.root = there.path(), .items = {}};
  AddPicture(other, "x", NoiseImage(40, 30, 3, 8), MixedMask(40, 30, 8));
  AddPicture(other, "y", NoiseImage(40, 30, 3, 9), MixedMask(40, 30, 9));
  AddPicture(other, "a", NoiseImage(40, 30, 3, 1), MixedMask(40, 30, 1));
  EXPECT_EQ(OfImage(DrawSamples(set, options), 0), OfImage(DrawSamples(other, options), 2));
}

TEST(DrawSamples, AddsToWhatFewerSamplesHad) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  const auto fewer = DrawSamples(set, {.num_samples = 60});
  const auto more = DrawSamples(set, {.num_samples = 120});
  for (const PixelSample& sample : fewer) {
    EXPECT_NE(std::find(more.begin(), more.end(), sample), more.end());
  }
}

// Uniform: over many seeds each of 20 good pixels is drawn about equally often.
TEST(DrawSamples, PrefersNoPixel) {
  const TemporaryDirectory folder;
  LabelledImageSet set{.root = folder.path(), .items = {}};
  AddPicture(set, "a", NoiseImage(8, 5, 1, 1), CountedMask(8, 5, 20, 20));
  std::map<std::uint16_t, int> times;
  constexpr int kRounds = 400;
  for (int seed = 0; seed < kRounds; ++seed) {
    for (const PixelSample& sample :
         DrawSamples(set, {.num_samples = 10, .seed = static_cast<std::uint64_t>(seed)})) {
      ++times[static_cast<std::uint16_t>(8 * sample.v_px + sample.u_px)];
    }
  }
  ASSERT_THAT(times, SizeIs(40));
  // Binomial(400, 1/4): mean 100, standard deviation 8.7; five of them.
  for (const auto& [pixel, count] : times) EXPECT_NEAR(count, 100, 44) << "pixel " << pixel;
}

TEST(DrawSamples, DrawsHardNegativesNearGoodPixels) {
  const TemporaryDirectory folder;
  LabelledImageSet set{.root = folder.path(), .items = {}};
  Image mask(60, 60, 1, kMaskBad);
  for (int i = 0; i < 20; ++i) mask.At(i, 0) = kMaskGood;  // a row in the corner
  AddPicture(set, "a", NoiseImage(60, 60, 1, 1), mask);
  const auto num_near = [&](double share) {
    std::size_t near = 0;
    for (const PixelSample& sample : DrawSamples(
             set,
             {.num_samples = 40, .hard_negative_share = share, .hard_negative_radius_px = 3})) {
      const double du = std::max(0, sample.u_px - 19);
      near += sample.label == 0 && std::hypot(du, sample.v_px) <= 3.0 ? 1 : 0;
    }
    return near;
  };
  EXPECT_EQ(num_near(1.0), 20U);
  EXPECT_GE(num_near(0.5), 10U);
  EXPECT_LE(num_near(0.0), 5U) << "2 % of the bad pixels are near";
}

TEST(DrawSamples, FillsUpWithOthersWhenTooFewAreNear) {
  const TemporaryDirectory folder;
  LabelledImageSet set{.root = folder.path(), .items = {}};
  Image mask(30, 30, 1, kMaskDontCare);
  for (int i = 0; i < 30; ++i) mask.At(i, 0) = kMaskGood;
  for (int i = 0; i < 30; ++i) mask.At(i, 29) = kMaskBad;
  AddPicture(set, "a", NoiseImage(30, 30, 1, 1), mask);
  EXPECT_THAT(DrawSamples(set, {.num_samples = 40, .hard_negative_share = 1.0}), SizeIs(40));
}

TEST(DrawSamples, UsesAShareOfTheInstances) {
  const TemporaryDirectory folder;
  LabelledImageSet set{.root = folder.path(), .items = {}};
  for (int i = 0; i < 8; ++i) {
    AddPicture(set,
               std::to_string(i),
               NoiseImage(8, 8, 1, static_cast<std::uint64_t>(i)),
               CountedMask(8, 8, 10, 20));
    set.items.back().instance = std::to_string(i / 2);
  }
  const auto used = [&](double share) {
    std::set<std::uint32_t> images;
    for (const PixelSample& sample : DrawSamples(set, {.num_samples = 32, .image_share = share})) {
      images.insert(sample.image);
    }
    return images;
  };
  const std::set<std::uint32_t> half = used(0.5);
  EXPECT_THAT(half, SizeIs(4));
  for (const std::uint32_t image : half) EXPECT_TRUE(half.contains(image ^ 1U)) << "both of a pair";
  EXPECT_THAT(used(1e-9), SizeIs(2)) << "one instance at least";
  EXPECT_THAT(used(1.0), SizeIs(8));
  const std::set<std::uint32_t> more = used(0.75);
  EXPECT_TRUE(std::includes(more.begin(), more.end(), half.begin(), half.end()));
}

TEST(DrawSamples, SaysWhyThereAreNone) {
  const TemporaryDirectory folder;
  LabelledImageSet set{.root = folder.path(), .items = {}};
  AddPicture(set, "a", NoiseImage(4, 4, 1, 1), CountedMask(4, 4, 16, 0));
  AddPicture(set, "b", NoiseImage(4, 4, 1, 2), CountedMask(4, 4, 0, 3));
  EXPECT_THROWS_MESSAGE(
      DrawSamples(set, {}), Error, HasSubstr("none of 2 images has both good and bad pixels"));
  AddPicture(set, "c", NoiseImage(4, 4, 1, 3), CountedMask(4, 4, 3, 3));
  EXPECT_THROWS_MESSAGE(DrawSamples(set, {.num_samples = 1}), Error, HasSubstr("leave no bad"));
  EXPECT_THROWS_MESSAGE(DrawSamples(set, {.num_samples = 4, .bad_per_good = 99.0}),
                        Error,
                        AllOf(HasSubstr("4 samples with 99 bad ones"), HasSubstr("no good pixel")));
}

TEST(DrawSamples, TellsWhatIsLeftOut) {
  const TemporaryDirectory folder;
  LabelledImageSet set = MakeSet(folder.path());
  AddPicture(set, "e", NoiseImage(8, 8, 3, 5), CountedMask(8, 8, 4, 0));
  AddPicture(set, "f", NoiseImage(8, 8, 3, 6), CountedMask(8, 8, 0, 0));
  std::vector<std::string> told;
  SamplingOptions options{.num_samples = 200, .num_threads = 2};
  options.left_out = [&](const std::string& image, std::string_view reason) {
    told.push_back(image + ": " + std::string(reason));
  };
  static_cast<void>(DrawSamples(set, options));
  EXPECT_THAT(
      told,
      ElementsAre(
          "d.png: no good pixel", "e.png: no bad pixel", "f.png: no good and no bad pixel"));
}

// "d" gives no sample; a fault in it must not pass for that.
TEST(DrawSamples, RefusesAFaultyPictureEvenIfNothingIsDrawnFromIt) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  perception::WritePng(folder / "d_mask.png", Image(20, 30, 1, kMaskBad));
  EXPECT_THROWS_MESSAGE(DrawSamples(set, {}),
                        Error,
                        HasSubstr("d_mask.png: the mask is 20x30 pixels, its picture 40x30"));
  perception::WritePng(folder / "d_mask.png", Image(40, 30, 1, kMaskBad));
  WriteFileAtomically(folder / "d.png", "no picture");
  EXPECT_THROWS_MESSAGE(DrawSamples(set, {}), Error, HasSubstr("d.png"));
}

// Its header has the size before the turn, which is not the mask's.
TEST(DrawSamples, LeavesOutATurnedPictureOfOneClass) {
  const TemporaryDirectory folder;
  LabelledImageSet set = MakeSet(folder.path());
  AddPicture(set, "turned", Image(1, 1), Image(16, 32, 1, kMaskBad));
  set.items.back().image = "turned.jpg";
  WriteTurnedJpeg(folder / "turned.jpg", 32, 16);
  EXPECT_THAT(DrawSamples(set, {.num_samples = 100}), SizeIs(100));
  perception::WritePng(folder / "turned_mask.png", Image(32, 16, 1, kMaskBad));
  EXPECT_THROWS_MESSAGE(DrawSamples(set, {}),
                        Error,
                        HasSubstr("turned_mask.png: the mask is 32x16 pixels, its picture 16x32"));
}

TEST(DrawSamples, SaysBeforehandThatThePixelsDoNotFitIntoMemory) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  EXPECT_THAT(DrawSamples(set, {.num_samples = 100, .memory = 2400}), SizeIs(100));
  EXPECT_THROWS_MESSAGE(DrawSamples(set, {.num_samples = 100, .memory = 2399}),
                        Error,
                        HasSubstr("drawing the pixels of 100 samples needs 1 MB of memory"));
}

TEST(ComputeSampleFeatures, SaysBeforehandThatTheyDoNotFitIntoMemory) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  const auto compute = [&](std::uint64_t memory) {
    const auto samples = DrawSamples(set, {.num_samples = 100});
    const features::FeatureSpec spec = features::ParseFeatureSpec("edges54");
    return ComputeSampleFeatures(set, samples, spec, {.memory = memory}).num_samples();
  };
  EXPECT_EQ(compute(21700), 100U);
  EXPECT_THROWS_MESSAGE(
      compute(21699), Error, HasSubstr("(use at most 99 samples, or fewer features)"));
}

TEST(SamplingOptions, NamesTheFieldAtFault) {
  const std::map<std::string, SamplingOptions> cases = {
      {"bad_per_good is 0; it must be greater than 0", {.bad_per_good = 0.0}},
      {"bad_per_good is inf", {.bad_per_good = HUGE_VAL}},
      {"image_share is 0; it must be in (0, 1]", {.image_share = 0.0}},
      {"image_share is 1.5", {.image_share = 1.5}},
      {"hard_negative_share is nan", {.hard_negative_share = NAN}},
      {"hard_negative_radius_px is 0; it must be 1 or more", {.hard_negative_radius_px = 0}},
      {"num_threads is 0", {.num_threads = 0}}};
  for (const auto& [message, options] : cases) {
    EXPECT_THROWS_MESSAGE((options.Validate(), 0), Error, HasSubstr("SamplingOptions." + message));
  }
}

TEST(ComputeSampleFeatures, GathersWhatPixelFeaturesHolds) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  const features::FeatureSpec spec = features::ParseFeatureSpec("edges54");
  SamplingOptions options{.num_samples = 100};
  const std::vector<PixelSample> samples = DrawSamples(set, options);
  const GraspPointSamples result = ComputeSampleFeatures(set, samples, spec, options);
  ASSERT_EQ(result.num_features, 54U);
  ASSERT_EQ(result.num_samples(), samples.size());
  ASSERT_THAT(result.features, SizeIs(54 * samples.size()));
  for (std::size_t i = 0; i < samples.size(); i += 7) {
    const Image image = perception::ReadImage(set.root / set.items[samples[i].image].image);
    const features::PixelFeatures features(perception::RawView(image), spec);
    std::vector<float> expected(54);
    features.Gather(samples[i].u_px, samples[i].v_px, expected);
    const auto row = result.features.begin() + static_cast<std::ptrdiff_t>(54 * i);
    EXPECT_EQ(std::vector<float>(row, row + 54), expected) << "sample " << i;
    EXPECT_EQ(result.labels[i], samples[i].label);
  }
  options.num_threads = 3;
  EXPECT_EQ(ComputeSampleFeatures(set, samples, spec, options).features, result.features);
}

TEST(ComputeSampleFeatures, NamesThePictureAtFault) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  const std::vector<PixelSample> samples = DrawSamples(set, {.num_samples = 100});
  EXPECT_THROWS_MESSAGE(
      ComputeSampleFeatures(set, samples, features::ParseFeatureSpec("saxena459"), {}),
      Error,
      HasSubstr("b.png: a gray picture, but the features look at colour"));
  perception::WritePng(folder / "a.png", NoiseImage(20, 30, 3, 1));
  EXPECT_THROWS_MESSAGE(
      ComputeSampleFeatures(set, samples, features::ParseFeatureSpec("edges54"), {}),
      Error,
      HasSubstr("a_mask.png: the mask is 40x30 pixels, its picture 20x30"));
}

TEST(ComputeSampleFeatures, RefusesSamplesThatAreNone) {
  const TemporaryDirectory folder;
  const LabelledImageSet set = MakeSet(folder.path());
  const features::FeatureSpec spec = features::ParseFeatureSpec("edges54");
  EXPECT_EQ(ComputeSampleFeatures(set, {}, spec, {}).num_samples(), 0U);
  const auto compute = [&](const std::vector<PixelSample>& samples) {
    return ComputeSampleFeatures(set, samples, spec, {}).num_samples();
  };
  EXPECT_THROW(compute({{.image = 9}}), std::logic_error);
  EXPECT_THROW(compute({{.image = 0, .u_px = 40}}), std::logic_error);
  EXPECT_THROW(compute({{.image = 1}, {.image = 0}}), std::logic_error);
}

TEST(DrawSamples, ReportsProgressToTheEnd) {
  const TemporaryDirectory folder;
  std::map<std::string, std::size_t> last;
  SamplingOptions options{.num_samples = 20, .num_threads = 2};
  options.progress = [&](std::string_view stage, std::size_t done, std::size_t total) {
    EXPECT_LE(done, total);
    last[std::string(stage)] = done;
  };
  static_cast<void>(DrawSamples(MakeSet(folder.path()), options));
  EXPECT_EQ(last["counting labelled pixels"], 4U);
  EXPECT_EQ(last["drawing pixels"], 4U);
}

}  // namespace
}  // namespace handcraft::datasets
