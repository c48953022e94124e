// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/grasp_point_model.h"

#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>

#include "lib/core/sha256.h"
#include "lib/features/filter_bank.h"
#include "lib/runtime/aligned_buffer.h"
#include "lib/runtime/content_reader.h"

namespace handcraft::runtime {
namespace {

using features::FeatureSpec;
using features::FilterKernels;

bool ReadFilters(ContentReader& reader, FeatureSpec& spec) {
  std::vector<std::int32_t> ids;
  if (!reader.Read("filter_ids", {kAnyLength}, ids)) return false;
  for (const std::int32_t id : ids) {
    if (id < 0 || id >= features::kNumFilters) {
      return reader.Fail(MakeError(HC_ERROR_CONTENT,
                                   reader.OffsetOf("filter_ids"),
                                   "the tensor 'filter_ids' holds %d; this library has the filters "
                                   "0 to %d",
                                   id,
                                   features::kNumFilters - 1));
    }
    spec.filters.push_back(static_cast<features::Filter>(id));
  }
  return true;
}

// § 5.1: the numbers that describe a pixel.
bool ReadSpec(ContentReader& reader, FeatureSpec& spec) {
  std::int32_t energy = 0;
  if (!ReadFilters(reader, spec) || !reader.ReadOne("window", spec.window) ||
      !reader.ReadOne("energy", energy)) {
    return false;
  }
  if (reader.Find("scales") != nullptr && !reader.Read("scales", {kAnyLength}, spec.scales)) {
    return false;
  }
  if (energy < 0 || energy > static_cast<std::int32_t>(features::Energy::kLog)) {
    return reader.Fail(MakeError(HC_ERROR_CONTENT,
                                 reader.OffsetOf("energy"),
                                 "the tensor 'energy' holds %d; 0, 1 or 2 was expected",
                                 energy));
  }
  spec.energy = static_cast<features::Energy>(energy);
  const std::string_view fault = features::FaultOf(spec);
  if (fault.empty()) return true;
  return reader.Fail(MakeError(HC_ERROR_CONTENT,
                               reader.OffsetOf("filter_ids"),
                               "the feature specification is invalid: %.*s",
                               static_cast<int>(fault.size()),
                               fault.data()));
}

// § 5.2: the filters the model was trained with are, bit for bit, the ones it will be run with.
bool CheckFilters(ContentReader& reader, const FeatureSpec& spec) {
  std::vector<float> stored;
  float offset = 0.0F;
  constexpr std::uint64_t kSide = features::kKernelSize;
  if (!reader.Read("filters", {spec.filters.size(), 2, kSide, kSide}, stored) ||
      !reader.ReadOne("energy_offset", offset)) {
    return false;
  }
  constexpr std::size_t kNumbers = 2 * kSide * kSide;
  for (std::size_t f = 0; f < spec.filters.size(); ++f) {
    const FilterKernels kernels = features::KernelsOf(spec.filters[f]);
    static_assert(sizeof kernels.components == kNumbers * sizeof(float));
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bits are what is compared.
    if (std::memcmp(&stored[f * kNumbers], &kernels.components, sizeof kernels.components) == 0) {
      continue;
    }
    return reader.Fail(
        MakeError(HC_ERROR_CONTENT,
                  reader.OffsetOf("filters") + f * sizeof kernels.components,
                  "filter '%s' of the model differs from that of Handcraft %s; train "
                  "the model again or install the runtime it was made with",
                  Printable(features::NameOf(spec.filters[f])).c_str(),
                  hc_version()));
  }
  if (offset == features::kLogEnergyOffset) return true;
  return reader.Fail(MakeError(HC_ERROR_CONTENT,
                               reader.OffsetOf("energy_offset"),
                               "the tensor 'energy_offset' holds %g; this library has %g",
                               static_cast<double>(offset),
                               static_cast<double>(features::kLogEnergyOffset)));
}

bool CheckFeatureText(ContentReader& reader, const FeatureSpec& spec) {
  const std::string text = features::ToString(spec);
  Sha256 hash;
  hash.Update(text);
  return reader.ExpectMetadata(format::kFeaturesKey, text) &&
         reader.ExpectMetadata(format::kFeaturesHashKey, hash.HexDigest());
}

// § 5.3: a picture and its probabilities.
struct SelfTest {
  std::vector<std::uint8_t> picture;  // blue, green, red
  std::vector<float> expected;
  float tolerance = 0.0F;
  std::uint64_t width = 0;
  std::uint64_t height = 0;
};

bool ReadSelfTest(ContentReader& reader, SelfTest& test) {
  if (!reader.Read("selftest.input", {kAnyLength, kAnyLength, 3}, test.picture)) return false;
  const TensorView& picture = *reader.Find("selftest.input");
  test.height = picture.shape[0];
  test.width = picture.shape[1];
  if (test.height > kMaxSelfTestSide || test.width > kMaxSelfTestSide) {
    return reader.Fail(MakeError(HC_ERROR_CONTENT,
                                 picture.byte_offset,
                                 "the self-test picture is larger than %d pixels a side",
                                 static_cast<int>(kMaxSelfTestSide)));
  }
  if (!reader.Read("selftest.output", {test.height, test.width}, test.expected) ||
      !reader.ReadOne("selftest.tolerance", test.tolerance)) {
    return false;
  }
  if (test.tolerance > 0.0F && test.tolerance <= kMaxSelfTestTolerance) return true;
  return reader.Fail(MakeError(HC_ERROR_CONTENT,
                               reader.OffsetOf("selftest.tolerance"),
                               "the tensor 'selftest.tolerance' holds %g; above 0 and at most %g "
                               "was expected",
                               static_cast<double>(test.tolerance),
                               static_cast<double>(kMaxSelfTestTolerance)));
}

std::optional<ModelError> RunSelfTest(const features::PixelScorer& scorer, const SelfTest& test) {
  const int width = static_cast<int>(test.width);
  const int height = static_cast<int>(test.height);
  const AlignedBuffer workspace(scorer.WorkspaceBytes(width, height));
  std::vector<float> found(test.expected.size());
  const features::RawImage picture{.data = test.picture.data(),
                                   .width = width,
                                   .height = height,
                                   .stride_bytes = std::ptrdiff_t{3} * width,
                                   .format = features::PixelFormat::kBgr8};
  scorer.Score(picture, workspace.Bytes(), found.data(), width);
  for (std::size_t i = 0; i < found.size(); ++i) {
    // Negated, so that a NaN fails as well.
    if (std::fabs(found[i] - test.expected[i]) <= test.tolerance) continue;
    return MakeError(HC_ERROR_SELF_TEST,
                     kNoOffset,
                     "the self-test gives %.7g at pixel (%zu, %zu) where the model stores %.7g; it "
                     "was made by another version: train it again or install that version",
                     static_cast<double>(found[i]),
                     i % test.width,
                     i / test.width,
                     static_cast<double>(test.expected[i]));
  }
  return std::nullopt;
}

}  // namespace

Result<features::PixelScorer> LoadGraspPointScorer(const ParsedModel& model) {
  ContentReader reader(model);
  FeatureSpec spec;
  std::vector<float> weights;
  double intercept = 0.0;
  SelfTest test;
  const bool complete =
      ReadSpec(reader, spec) && CheckFilters(reader, spec) && CheckFeatureText(reader, spec) &&
      reader.Read("weights", {static_cast<std::uint64_t>(spec.NumFeatures())}, weights) &&
      reader.ReadOne("intercept", intercept) &&
      reader.CheckNormaliser(static_cast<std::uint64_t>(spec.NumFeatures())) &&
      ReadSelfTest(reader, test) && reader.RefuseUnknownTensors();
  if (!complete) return reader.error();
  features::PixelScorer scorer(std::move(spec), weights, intercept);
  if (const std::optional<ModelError> error = RunSelfTest(scorer, test)) return *error;
  return scorer;
}

}  // namespace handcraft::runtime
