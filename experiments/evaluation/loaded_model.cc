// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/loaded_model.h"

#include <cstdint>
#include <string>
#include <utility>

#include "lib/core/error.h"

namespace handcraft::experiments {
namespace {

Error::Details DetailsOf(const hc_error& error) {
  Error::Details details{.reason = error.message};
  if (error.byte_offset != UINT64_MAX) details.byte = error.byte_offset;
  return details;
}

}  // namespace

LoadedModel LoadModel(const std::filesystem::path& path) {
  hc_model* model = nullptr;
  hc_error error{};
  if (hc_model_load_file(path.c_str(), &model, &error) != HC_OK) {
    Error::Details details = DetailsOf(error);
    details.path = path.string();
    const std::string named_again = ": " + details.path;  // the runtime ends some messages so
    if (details.reason.ends_with(named_again)) {
      details.reason.resize(details.reason.size() - named_again.size());
    }
    throw Error(std::move(details));
  }
  return LoadedModel(model);
}

LoadedModel LoadModel(std::span<const std::uint8_t> bytes) {
  hc_model* model = nullptr;
  hc_error error{};
  if (hc_model_load_memory(bytes.data(), bytes.size(), &model, &error) != HC_OK) {
    throw Error(DetailsOf(error));
  }
  return LoadedModel(model);
}

std::string MetadataOf(const hc_model* model, const char* key) {
  const char* value = hc_model_metadata(model, key);
  return value == nullptr ? "" : value;
}

std::string_view KindName(hc_kind kind) noexcept {
  switch (kind) {
    case HC_KIND_GRASP_POINT:
      return "grasp_point";
    case HC_KIND_LOGISTIC:
      return "logistic";
    case HC_KIND_SVM:
      return "svm";
    case HC_KIND_OBJECT_CLASS:
      return "object_class";
  }
  return "unknown";
}

}  // namespace handcraft::experiments
