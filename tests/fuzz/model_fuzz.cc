// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Model files from anywhere: loading refuses or accepts them, and never reads outside them, leaks,
// hangs or crashes. What is accepted can be used, and has one encoding.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "lib/model_io/model_writer.h"
#include "lib/runtime/crc32c.h"
#include "lib/runtime/format.h"
#include "lib/runtime/handcraft_runtime.h"
#include "lib/runtime/model_parser.h"

namespace {

using Bytes = std::vector<std::uint8_t>;

void Require(bool condition) {
  if (!condition) __builtin_trap();
}

void ScoreAPicture(const hc_model* model) {
  constexpr std::int32_t kWidth = 17;
  constexpr std::int32_t kHeight = 13;
  std::uint8_t pixels[kWidth * kHeight * 3];
  for (std::size_t i = 0; i < sizeof pixels; ++i) pixels[i] = static_cast<std::uint8_t>(i * i);
  float probabilities[kWidth * kHeight];
  const hc_image image{pixels, kWidth, kHeight, kWidth * 3, HC_BGR8};
  hc_workspace* workspace = nullptr;
  Require(hc_workspace_create(model, kWidth, kHeight, &workspace) == HC_OK);
  Require(hc_score_image(model, workspace, &image, probabilities, kWidth) == HC_OK);
  hc_workspace_free(workspace);
}

void PredictARow(const hc_model* model) {
  const std::vector<double> row(hc_model_num_features(model), 0.5);
  double probability = 0.0;
  Require(hc_predict_row(model, row.data(), row.size(), &probability) == HC_OK);
}

void ClassifyARow(const hc_model* model) {
  const std::vector<double> row(hc_model_num_features(model), 0.5);
  hc_workspace* workspace = nullptr;
  Require(hc_row_workspace_create(model, &workspace) == HC_OK);
  hc_class_prediction prediction{};
  Require(hc_classify_row(model, workspace, row.data(), row.size(), &prediction) == HC_OK);
  Require(hc_model_class_name(model, static_cast<std::size_t>(prediction.number)) != nullptr);
  hc_workspace_free(workspace);
}

void ClassifyACloud(const hc_model* model) {
  constexpr std::int32_t kSide = 9;
  float points[kSide * kSide * 3];
  for (std::size_t i = 0; i < std::size(points); ++i) points[i] = static_cast<float>(i * i % 31);
  const hc_cloud cloud{points, kSide, kSide, 3 * kSide, 3, nullptr, 0};
  hc_workspace* workspace = nullptr;
  Require(hc_row_workspace_create(model, &workspace) == HC_OK);
  std::vector<double> values(hc_model_num_machines(model));
  hc_class_prediction prediction{};
  Require(hc_classify_cloud(model, workspace, &cloud, &prediction, values.data()) == HC_OK);
  Require(hc_model_class_name(model, static_cast<std::size_t>(prediction.number)) != nullptr);
  hc_workspace_free(workspace);
}

void FindAGrasp(const hc_model* model) {
  constexpr std::int32_t kSide = 5;
  float points[kSide * kSide * 3];
  std::uint8_t mask[kSide * kSide];
  for (std::size_t i = 0; i < sizeof mask; ++i) {
    points[3 * i] = 0.01F * static_cast<float>(i % kSide);
    const std::size_t row = i / kSide;
    points[3 * i + 1] = 0.01F * static_cast<float>(row);
    points[3 * i + 2] = 0.001F * static_cast<float>(i * i % 7);
    mask[i] = 1;
  }
  const hc_cloud cloud{points, kSide, kSide, std::int64_t{3} * kSide, 3, mask, kSide};
  hc_workspace* workspace = nullptr;
  Require(hc_workspace_create(model, kSide, kSide, &workspace) == HC_OK);
  const auto num_classes = static_cast<std::int32_t>(hc_model_num_classes(model));
  for (std::int32_t c = 0; c < num_classes; ++c) {
    const hc_grasp_request request{c, 32, {0.02, 0.02, 0.0}};
    hc_grasp grasp{};
    Require(hc_find_grasp(model, workspace, &cloud, &request, &grasp) == HC_OK);
    for (const double part : grasp.quaternion_xyzw) Require(part >= -1.001 && part <= 1.001);
  }
  hc_workspace_free(workspace);
}

void Use(const hc_model* model) {
  switch (hc_model_kind(model)) {
    case HC_KIND_GRASP_POINT:
      return ScoreAPicture(model);
    case HC_KIND_LOGISTIC:
      return PredictARow(model);
    case HC_KIND_SVM:
      return ClassifyARow(model);
    case HC_KIND_OBJECT_CLASS:
      return ClassifyACloud(model);
    case HC_KIND_GRASP_LIBRARY:
      return FindAGrasp(model);
    default:
      return;
  }
}

void Load(const Bytes& bytes) {
  hc_model* model = nullptr;
  hc_error error{};
  const hc_status status = hc_model_load_memory(bytes.data(), bytes.size(), &model, &error);
  Require((status == HC_OK) == (model != nullptr));
  Require(std::memchr(error.message, '\0', sizeof error.message) != nullptr);
  if (status != HC_OK) {
    Require(error.message[0] != '\0' && error.status == status);
    Require(error.byte_offset == UINT64_MAX || error.byte_offset <= bytes.size());
    return;
  }
  Use(model);
  hc_model_free(model);
}

// docs/model_format.md § 1: what the reader accepts, the writer writes the same.
void RequireOneEncoding(const Bytes& bytes) {
  const auto parsed = handcraft::runtime::ParseModel(bytes);
  if (!parsed || *parsed->FindMetadata("hc.format") != "1.0") return;
  Require(handcraft::model_io::Serialise(handcraft::model_io::Parse(bytes, "fuzz")) == bytes);
}

// Puts the right checksum at the end, so that the rules behind it are reached.
void Seal(Bytes& bytes) {
  using handcraft::runtime::format::kChecksumMark;
  if (bytes.size() < handcraft::runtime::format::kChecksumBytes) return;
  bytes.resize(bytes.size() - handcraft::runtime::format::kChecksumBytes);
  const std::uint32_t checksum = handcraft::runtime::Crc32c(bytes);
  bytes.insert(bytes.end(), kChecksumMark.begin(), kChecksumMark.end());
  bytes.resize(bytes.size() + sizeof checksum);
  std::memcpy(bytes.data() + bytes.size() - sizeof checksum, &checksum, sizeof checksum);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, data + size);
  Load(bytes);
  Seal(bytes);
  Load(bytes);
  RequireOneEncoding(bytes);
  return 0;
}
