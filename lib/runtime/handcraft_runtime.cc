// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/handcraft_runtime.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lib/runtime/aligned_buffer.h"
#include "lib/runtime/grasp_library_model.h"
#include "lib/runtime/grasp_point_model.h"
#include "lib/runtime/logistic_model.h"
#include "lib/runtime/model_file.h"
#include "lib/runtime/model_handle.h"
#include "lib/runtime/model_parser.h"
#include "lib/runtime/object_class_model.h"
#include "lib/runtime/svm_loader.h"
#include "lib/runtime/top_k.h"

namespace {

using handcraft::features::PixelScorer;
using handcraft::runtime::AlignedBuffer;
using handcraft::runtime::GraspLibraryModel;
using handcraft::runtime::kNoOffset;
using handcraft::runtime::LogisticModel;
using handcraft::runtime::MakeError;
using handcraft::runtime::ModelError;
using handcraft::runtime::ParsedModel;
using handcraft::runtime::Printable;
using handcraft::runtime::Result;
namespace format = handcraft::runtime::format;

/// Largest side of an image or map [px], so that sizes in bytes never overflow.
constexpr std::int32_t kMaxSide = 1 << 20;

using ModelPointer = std::unique_ptr<hc_model>;

std::string ValueOf(const ParsedModel& parsed, std::string_view key) {
  const std::string* value = parsed.FindMetadata(key);
  return value == nullptr ? std::string() : *value;
}

template <class Predictor>
Result<ModelPointer> Wrap(Result<Predictor> predictor, ParsedModel& parsed) {
  if (!predictor) return predictor.error();
  return ModelPointer(new hc_model{std::move(*predictor), std::move(parsed.metadata)});
}

// docs/model_format.md § 3.3: what the file is, and whether this library knows it.
Result<ModelPointer> BuildModel(ParsedModel& parsed) {
  const std::string kind = ValueOf(parsed, format::kKindKey);
  if (kind != format::kGraspPointKind && kind != format::kLogisticKind &&
      kind != format::kSvmKind && kind != format::kObjectClassKind &&
      kind != format::kGraspLibraryKind) {
    return MakeError(
        HC_ERROR_KIND,
        format::kLengthBytes,
        "the model is of kind '%s' and Handcraft %s reads grasp_point, grasp_library, logistic, "
        "object_class and svm; install a newer Handcraft runtime or give another model",
        Printable(kind).c_str(),
        hc_version());
  }
  const std::string version = ValueOf(parsed, format::kKindVersionKey);
  if (version != format::kKindVersion) {
    return MakeError(HC_ERROR_VERSION,
                     format::kLengthBytes,
                     "the model has version '%s' of kind %s and Handcraft %s reads version %s; "
                     "install a newer Handcraft runtime or train the model again",
                     Printable(version).c_str(),
                     kind.c_str(),
                     hc_version(),
                     format::kKindVersion.data());
  }
  if (kind == format::kGraspPointKind) {
    return Wrap(handcraft::runtime::LoadGraspPointScorer(parsed), parsed);
  }
  if (kind == format::kGraspLibraryKind) {
    return Wrap(handcraft::runtime::LoadGraspLibrary(parsed), parsed);
  }
  if (kind == format::kSvmKind) return Wrap(handcraft::runtime::LoadSvmModel(parsed), parsed);
  if (kind == format::kObjectClassKind) {
    return Wrap(handcraft::runtime::LoadObjectClassModel(parsed), parsed);
  }
  return Wrap(handcraft::runtime::LoadLogisticModel(parsed), parsed);
}

Result<ModelPointer> Load(std::span<const std::uint8_t> bytes) noexcept {
  try {
    Result<ParsedModel> parsed = handcraft::runtime::ParseModel(bytes);
    if (!parsed) return parsed.error();
    return BuildModel(*parsed);
  } catch (const std::bad_alloc&) {
    return MakeError(HC_ERROR_MEMORY, kNoOffset, "out of memory while loading the model");
  } catch (...) {
    return MakeError(HC_ERROR_CONTENT,
                     kNoOffset,
                     "the model's contents contradict each other; train the model again");
  }
}

hc_status Report(const ModelError& found, hc_error* error) noexcept {
  if (error != nullptr) *error = found;
  return found.status;
}

hc_status Deliver(Result<ModelPointer> loaded, hc_model** model, hc_error* error) noexcept {
  if (!loaded) return Report(loaded.error(), error);
  *model = loaded->release();
  return Report({HC_OK, kNoOffset, {}}, error);
}

hc_status ReportNullArgument(hc_error* error) noexcept {
  return Report(MakeError(HC_ERROR_ARGUMENT, kNoOffset, "a null pointer was passed"), error);
}

bool IsSide(std::int32_t size) noexcept { return size >= 1 && size <= kMaxSide; }

// Whether rows of `row_length` units, `stride` apart (downwards if positive), do not overlap.
bool FitsStride(std::int64_t row_length, std::int64_t stride) noexcept {
  return stride >= row_length || stride <= -row_length;
}

bool IsFormat(hc_pixel_format pixel_format) noexcept {
  return pixel_format == HC_GRAY8 || pixel_format == HC_BGR8 || pixel_format == HC_RGB8;
}

// A picture that a model can score in a workspace.
struct ScoringTask {
  const PixelScorer* scorer = nullptr;
  handcraft::features::RawImage image;
};

// What the functions that score a picture have in common.
hc_status PrepareScoring(const hc_model* model,
                         hc_workspace* workspace,
                         const hc_image* image,
                         ScoringTask& task) noexcept {
  if (model == nullptr || workspace == nullptr || image == nullptr || image->data == nullptr ||
      !IsFormat(image->format)) {
    return HC_ERROR_ARGUMENT;
  }
  task.scorer = std::get_if<PixelScorer>(&model->predictor);
  if (task.scorer == nullptr) return HC_ERROR_KIND;
  task.image = {.data = image->data,
                .width = image->width,
                .height = image->height,
                .stride_bytes = static_cast<std::ptrdiff_t>(image->stride_bytes),
                .format = static_cast<handcraft::features::PixelFormat>(image->format)};
  const handcraft::features::RawImage& raw = task.image;
  const int num_channels = handcraft::features::NumChannels(raw.format);
  if (raw.width < 1 || raw.height < 1 || raw.width > workspace->max_width ||
      raw.height > workspace->max_height ||
      (task.scorer->spec().NeedsColour() && num_channels == 1)) {
    return HC_ERROR_IMAGE;
  }
  // The workspace may have been made for another model.
  if (!FitsStride(std::int64_t{raw.width} * num_channels, raw.stride_bytes) ||
      task.scorer->WorkspaceBytes(raw.width, raw.height) > workspace->buffer.Bytes().size()) {
    return HC_ERROR_ARGUMENT;
  }
  return HC_OK;
}

}  // namespace

hc_status hc_model_load_memory(const void* bytes, size_t size, hc_model** model, hc_error* error) {
  if (model == nullptr || (bytes == nullptr && size > 0)) return ReportNullArgument(error);
  *model = nullptr;
  return Deliver(Load({static_cast<const std::uint8_t*>(bytes), size}), model, error);
}

hc_status hc_model_load_file(const char* path, hc_model** model, hc_error* error) {
  if (model == nullptr || path == nullptr) return ReportNullArgument(error);
  *model = nullptr;
  const auto bytes = handcraft::runtime::ReadModelFile(path, format::kMaxFileBytes);
  if (!bytes) return Report(bytes.error(), error);
  return Deliver(Load(*bytes), model, error);
}

void hc_model_free(hc_model* model) { delete model; }

hc_kind hc_model_kind(const hc_model* model) {
  if (model == nullptr) return static_cast<hc_kind>(0);
  // In the order of the variant's alternatives.
  constexpr hc_kind kKinds[] = {HC_KIND_GRASP_POINT,
                                HC_KIND_LOGISTIC,
                                HC_KIND_SVM,
                                HC_KIND_OBJECT_CLASS,
                                HC_KIND_GRASP_LIBRARY};
  static_assert(std::size(kKinds) == std::variant_size_v<decltype(model->predictor)>);
  return kKinds[model->predictor.index()];
}

const char* hc_model_metadata(const hc_model* model, const char* key) {
  if (model == nullptr || key == nullptr) return nullptr;
  for (const auto& [known, value] : model->metadata) {
    if (known == key) return value.c_str();
  }
  return nullptr;
}

size_t hc_model_num_features(const hc_model* model) {
  if (model == nullptr) return 0;
  if (const auto* scorer = std::get_if<PixelScorer>(&model->predictor)) {
    return static_cast<size_t>(scorer->spec().NumFeatures());
  }
  if (const auto* svm = model->Svm()) return svm->NumFeatures();
  const auto* logistic = std::get_if<LogisticModel>(&model->predictor);
  return logistic == nullptr ? 0 : logistic->weights.size();
}

int hc_model_needs_colour(const hc_model* model) {
  if (model == nullptr) return 0;
  const auto* scorer = std::get_if<PixelScorer>(&model->predictor);
  return scorer != nullptr && scorer->spec().NeedsColour() ? 1 : 0;
}

hc_status hc_workspace_create(const hc_model* model,
                              int32_t max_width,
                              int32_t max_height,
                              hc_workspace** workspace) {
  if (model == nullptr || workspace == nullptr) return HC_ERROR_ARGUMENT;
  *workspace = nullptr;
  if (!IsSide(max_width) || !IsSide(max_height)) return HC_ERROR_ARGUMENT;
  const auto* scorer = std::get_if<PixelScorer>(&model->predictor);
  if (scorer == nullptr && !std::holds_alternative<GraspLibraryModel>(model->predictor)) {
    return HC_ERROR_KIND;
  }
  try {
    AlignedBuffer buffer(scorer != nullptr
                             ? scorer->WorkspaceBytes(max_width, max_height)
                             : sizeof(float) *
                                   handcraft::features::ObjectPlaneScratch(max_width, max_height));
    *workspace = new hc_workspace{std::move(buffer), max_width, max_height};
  } catch (const std::bad_alloc&) {
    return HC_ERROR_MEMORY;
  }
  return HC_OK;
}

void hc_workspace_free(hc_workspace* workspace) { delete workspace; }

hc_status hc_score_image(const hc_model* model,
                         hc_workspace* workspace,
                         const hc_image* image,
                         float* probabilities,
                         int64_t stride) {
  ScoringTask task;
  const hc_status status = PrepareScoring(model, workspace, image, task);
  if (status != HC_OK) return status;
  if (probabilities == nullptr || !FitsStride(task.image.width, stride)) return HC_ERROR_ARGUMENT;
  task.scorer->Score(
      task.image, workspace->buffer.Bytes(), probabilities, static_cast<std::ptrdiff_t>(stride));
  return HC_OK;
}

hc_status hc_score_mask(const hc_model* model,
                        hc_workspace* workspace,
                        const hc_image* image,
                        const uint8_t* mask,
                        int64_t mask_stride,
                        float* probabilities,
                        int64_t stride) {
  ScoringTask task;
  const hc_status status = PrepareScoring(model, workspace, image, task);
  if (status != HC_OK) return status;
  const handcraft::features::RawImage& raw = task.image;
  if (mask == nullptr || !FitsStride(raw.width, mask_stride) || probabilities == nullptr ||
      !FitsStride(raw.width, stride)) {
    return HC_ERROR_ARGUMENT;
  }
  const handcraft::features::PixelMask wanted{mask, static_cast<std::ptrdiff_t>(mask_stride)};
  task.scorer->ScoreMask(raw,
                         wanted,
                         task.scorer->CheaperWay(raw.width, raw.height, wanted),
                         workspace->buffer.Bytes(),
                         probabilities,
                         static_cast<std::ptrdiff_t>(stride));
  return HC_OK;
}

hc_status hc_score_pixels(const hc_model* model,
                          hc_workspace* workspace,
                          const hc_image* image,
                          const hc_pixel* pixels,
                          size_t count,
                          float* probabilities) {
  ScoringTask task;
  const hc_status status = PrepareScoring(model, workspace, image, task);
  if (status != HC_OK) return status;
  if (count == 0) return HC_OK;
  if (pixels == nullptr || probabilities == nullptr) return HC_ERROR_ARGUMENT;
  for (size_t i = 0; i < count; ++i) {
    const hc_pixel& pixel = pixels[i];
    if (pixel.u < 0 || pixel.v < 0 || pixel.u >= task.image.width || pixel.v >= task.image.height ||
        (i > 0 && pixel.v < pixels[i - 1].v)) {
      return HC_ERROR_ARGUMENT;
    }
  }
  using handcraft::features::PixelPosition;
  static_assert(sizeof(hc_pixel) == sizeof(PixelPosition) &&
                offsetof(hc_pixel, v) == offsetof(PixelPosition, v));
  task.scorer->ScorePixels(task.image,
                           {reinterpret_cast<const PixelPosition*>(pixels), count},
                           workspace->buffer.Bytes(),
                           probabilities);
  return HC_OK;
}

hc_status hc_top_k(const float* probabilities,
                   int32_t width,
                   int32_t height,
                   int64_t stride,
                   float min_probability,
                   int32_t suppression_radius_px,
                   hc_point* points,
                   size_t* count) {
  if (probabilities == nullptr || count == nullptr || (points == nullptr && *count > 0) ||
      !IsSide(width) || !IsSide(height) || !FitsStride(width, stride) ||
      std::isnan(min_probability) || suppression_radius_px < 0) {
    return HC_ERROR_ARGUMENT;
  }
  const handcraft::runtime::ProbabilityMap map{
      probabilities, width, height, static_cast<std::ptrdiff_t>(stride)};
  const std::span<hc_point> places(points, *count);
  *count = suppression_radius_px == 0 ? handcraft::runtime::FindBest(map, min_probability, places)
                                      : handcraft::runtime::FindBestApart(
                                            map, min_probability, suppression_radius_px, places);
  return HC_OK;
}

const char* hc_status_message(hc_status status) {
  switch (status) {
    case HC_OK:
      return "The call succeeded.";
    case HC_ERROR_ARGUMENT:
      return "A pointer is null, a size is wrong or a number is out of range.";
    case HC_ERROR_FILE:
      return "The file cannot be opened or read.";
    case HC_ERROR_MEMORY:
      return "There is not enough memory.";
    case HC_ERROR_TRUNCATED:
      return "The file ends too early; copy it again.";
    case HC_ERROR_FORMAT:
      return "The file is not a Handcraft model.";
    case HC_ERROR_CHECKSUM:
      return "The file is damaged; copy it again.";
    case HC_ERROR_VERSION:
      return "The model needs another version of the Handcraft runtime.";
    case HC_ERROR_KIND:
      return "The model is of a kind this call cannot use.";
    case HC_ERROR_CONTENT:
      return "The model's contents are incomplete or wrong; train it again.";
    case HC_ERROR_SELF_TEST:
      return "The model's self-test gives another answer here than where it was made.";
    case HC_ERROR_IMAGE:
      return "The image is empty, larger than the workspace, or gray where colour is needed.";
    case HC_ERROR_CLOUD:
      return "The object's cloud has too few points, or no plane that fits it best; look again.";
  }
  return "Unknown status.";
}

const char* hc_version(void) { return HANDCRAFT_VERSION; }
