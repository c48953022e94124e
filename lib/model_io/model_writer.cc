// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/model_writer.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/runtime/crc32c.h"
#include "lib/runtime/format.h"
#include "lib/runtime/model_parser.h"

namespace handcraft::model_io {
namespace {

namespace format = runtime::format;
using Bytes = std::vector<std::uint8_t>;

static_assert(std::endian::native == std::endian::little, "tensors are written as they lie");

template <class T>
constexpr format::Dtype DtypeOf() {
  if constexpr (std::is_same_v<T, double>) return format::Dtype::kF64;
  if constexpr (std::is_same_v<T, std::int64_t>) return format::Dtype::kI64;
  if constexpr (std::is_same_v<T, float>) return format::Dtype::kF32;
  if constexpr (std::is_same_v<T, std::int32_t>) return format::Dtype::kI32;
  return format::Dtype::kU8;
}

format::Dtype DtypeOf(const Tensor& tensor) {
  return std::visit([]<class T>(const std::vector<T>&) { return DtypeOf<T>(); }, tensor.values);
}

std::size_t NumBytes(const Tensor& tensor) {
  return std::visit([]<class T>(const std::vector<T>& values) { return values.size() * sizeof(T); },
                    tensor.values);
}

void CheckShape(const std::string& name, const Tensor& tensor) {
  std::int64_t num_entries = 1;
  for (const std::int64_t dimension : tensor.shape) num_entries *= dimension;
  const std::size_t num_values = NumBytes(tensor) / format::BytesOf(DtypeOf(tensor));
  HC_CHECK(static_cast<std::size_t>(num_entries) == num_values, name, num_entries, num_values);
}

// § 2.1: quotes, backslashes, newlines and tabs are escaped; the rest stands as it is.
void AppendString(std::string_view text, std::string& json) {
  json += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    if (c == '\n') {
      json += "\\n";
    } else if (c == '\t') {
      json += "\\t";
    } else {
      json += c;
    }
  }
  json += '"';
}

void AppendMetadata(const std::map<std::string, std::string>& metadata, std::string& json) {
  json += "\"__metadata__\":{";
  const char* separator = "";
  for (const auto& [key, value] : metadata) {
    json += separator;
    AppendString(key, json);
    json += ':';
    AppendString(value, json);
    separator = ",";
  }
  json += '}';
}

void AppendTensor(const std::string& name,
                  const Tensor& tensor,
                  std::size_t begin,
                  std::string& json) {
  json += ',';
  AppendString(name, json);
  json += ":{\"dtype\":\"";
  json += format::NameOf(DtypeOf(tensor));
  json += "\",\"shape\":[";
  const char* separator = "";
  for (const std::int64_t dimension : tensor.shape) {
    json += separator + std::to_string(dimension);
    separator = ",";
  }
  json += "],\"data_offsets\":[" + std::to_string(begin) + "," +
          std::to_string(begin + NumBytes(tensor)) + "]}";
}

using Entry = std::map<std::string, Tensor>::value_type;

// § 2.2: the order of the tensors' bytes.
std::vector<const Entry*> InStorageOrder(const std::map<std::string, Tensor>& tensors) {
  std::vector<const Entry*> stored;
  stored.reserve(tensors.size());
  for (const Entry& entry : tensors) stored.push_back(&entry);
  std::sort(stored.begin(), stored.end(), [](const Entry* a, const Entry* b) {
    return format::StoredBefore(DtypeOf(a->second), a->first, DtypeOf(b->second), b->first);
  });
  return stored;
}

// § 2.1: the header, padded so that the data begin at a multiple of 64 (§ 2.3).
std::string MakeHeader(const ModelFile& model, const std::vector<const Entry*>& stored) {
  std::map<std::string_view, std::size_t> begins;
  std::size_t end = 0;
  for (const Entry* entry : stored) {
    begins[entry->first] = end;
    end += NumBytes(entry->second);
  }
  std::string json = "{";
  AppendMetadata(model.metadata, json);
  for (const auto& [name, tensor] : model.tensors) {
    AppendTensor(name, tensor, begins[name], json);
  }
  json += '}';
  while ((format::kLengthBytes + json.size()) % format::kDataAlignment != 0) json += ' ';
  return json;
}

template <class T>
void AppendBytes(const T* values, std::size_t num_bytes, Bytes& bytes) {
  const auto* begin = reinterpret_cast<const std::uint8_t*>(values);
  bytes.insert(bytes.end(), begin, begin + num_bytes);
}

// § 2.4: over everything before it.
void AppendChecksum(Bytes& bytes) {
  const std::uint32_t checksum = runtime::Crc32c(bytes);
  AppendBytes(format::kChecksumMark.data(), format::kChecksumMark.size(), bytes);
  AppendBytes(&checksum, sizeof checksum, bytes);
}

template <class T>
std::vector<T> CopyValues(std::span<const std::uint8_t> bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

Tensor CopyTensor(const runtime::TensorView& view) {
  Tensor tensor;
  tensor.shape.assign(view.shape.begin(),
                      view.shape.begin() + static_cast<std::ptrdiff_t>(view.rank));
  switch (view.dtype) {
    case format::Dtype::kF64:
      tensor.values = CopyValues<double>(view.bytes);
      break;
    case format::Dtype::kI64:
      tensor.values = CopyValues<std::int64_t>(view.bytes);
      break;
    case format::Dtype::kF32:
      tensor.values = CopyValues<float>(view.bytes);
      break;
    case format::Dtype::kI32:
      tensor.values = CopyValues<std::int32_t>(view.bytes);
      break;
    case format::Dtype::kU8:
      tensor.values = CopyValues<std::uint8_t>(view.bytes);
      break;
  }
  return tensor;
}

}  // namespace

Bytes Serialise(const ModelFile& model) {
  for (const auto& [name, tensor] : model.tensors) CheckShape(name, tensor);
  ModelFile complete = model;
  complete.metadata[std::string(format::kFormatKey)] = format::kVersionText;
  complete.tensors[std::string(format::kChecksumTensor)] =
      Tensor{std::vector<std::uint8_t>(format::kChecksumBytes), {format::kChecksumBytes}};

  const std::vector<const Entry*> stored = InStorageOrder(complete.tensors);
  const std::string header = MakeHeader(complete, stored);
  const std::uint64_t header_bytes = header.size();
  Bytes bytes;
  AppendBytes(&header_bytes, sizeof header_bytes, bytes);
  AppendBytes(header.data(), header.size(), bytes);
  for (const Entry* entry : stored) {
    if (entry->first == format::kChecksumTensor) break;
    std::visit(
        [&](const auto& values) { AppendBytes(values.data(), NumBytes(entry->second), bytes); },
        entry->second.values);
  }
  AppendChecksum(bytes);
  // The reader knows every rule of the format; what it refuses is not written.
  const runtime::Result<runtime::ParsedModel> check = runtime::ParseModel(bytes);
  if (!check) {
    throw Error({.reason = std::string("the model cannot be written: ") + check.error().message});
  }
  return bytes;
}

ModelFile Parse(std::span<const std::uint8_t> bytes, const std::string& path) {
  const runtime::Result<runtime::ParsedModel> parsed = runtime::ParseModel(bytes);
  if (!parsed) {
    Error::Details details{.path = path, .reason = parsed.error().message};
    if (parsed.error().byte_offset != runtime::kNoOffset) details.byte = parsed.error().byte_offset;
    throw Error(std::move(details));
  }
  ModelFile model;
  for (const runtime::TensorView& view : parsed->tensors) {
    if (view.name != format::kChecksumTensor) model.tensors[view.name] = CopyTensor(view);
  }
  model.metadata.insert(parsed->metadata.begin(), parsed->metadata.end());
  return model;
}

}  // namespace handcraft::model_io
