// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/model_header.h"

#include <algorithm>
#include <cinttypes>
#include <optional>

#include "lib/runtime/format_version.h"
#include "lib/runtime/header_cursor.h"

namespace handcraft::runtime {
namespace {

using format::Dtype;

bool IsNameByte(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
}

bool IsTensorName(std::string_view name) noexcept {
  return !name.empty() && name[0] >= 'a' && name[0] <= 'z' &&
         std::all_of(name.begin(), name.end(), IsNameByte);
}

bool IsMetadataKey(std::string_view key) noexcept {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return IsNameByte(c) || (c >= 'A' && c <= 'Z') || c == '-';
  });
}

// § 2.1: keys rise strictly, so that none comes twice and a model has one encoding.
bool CheckOrder(HeaderCursor& cursor,
                std::uint64_t offset,
                std::string_view previous,
                std::string_view key) noexcept {
  if (previous < key) return true;
  return cursor.Fail(MakeError(HC_ERROR_FORMAT,
                               offset,
                               previous == key ? "the header holds the key '%s' twice"
                                               : "the header holds the key '%s' out of order",
                               Printable(key).c_str()));
}

// § 2.1: "__metadata__":{"key":"value",…}
bool ReadMetadata(HeaderCursor& cursor, ParsedModel& model) {
  if (!cursor.Expect("\"__metadata__\":{")) return false;
  std::string key;
  do {
    const std::uint64_t offset = cursor.Offset();
    std::string value;
    if (!cursor.ReadString(format::kMaxKeyBytes, key)) return false;
    if (!IsMetadataKey(key)) {
      return cursor.Fail(MakeError(HC_ERROR_FORMAT,
                                   offset,
                                   "the metadata key '%s' breaks the rule [A-Za-z0-9_.-]{1,%zu}",
                                   Printable(key).c_str(),
                                   format::kMaxKeyBytes));
    }
    if (!model.metadata.empty() && !CheckOrder(cursor, offset, model.metadata.back().first, key)) {
      return false;
    }
    if (model.metadata.size() == format::kMaxMetadataKeys) {
      return cursor.Fail(MakeError(
          HC_ERROR_FORMAT, offset, "more than %zu metadata keys", format::kMaxMetadataKeys));
    }
    if (!cursor.Expect(":") || !cursor.ReadString(format::kMaxValueBytes, value)) return false;
    model.metadata.emplace_back(key, std::move(value));
  } while (cursor.TakeIf(','));
  return cursor.Expect("}");
}

bool ReadDtype(HeaderCursor& cursor, Dtype& dtype) {
  const std::uint64_t offset = cursor.Offset();
  std::string text;
  if (!cursor.ReadString(format::kMaxNameBytes, text)) return false;
  for (const format::DtypeName& known : format::kDtypes) {
    if (known.name != text) continue;
    dtype = known.dtype;
    return true;
  }
  return cursor.Fail(MakeError(HC_ERROR_FORMAT,
                               offset,
                               "the dtype '%s' is not one of F64, I64, F32, I32, U8",
                               Printable(text).c_str()));
}

// § 2.2: one to four dimensions of at least 1; *num_entries is their product.
bool ReadShape(HeaderCursor& cursor, TensorView& tensor, std::uint64_t& num_entries) noexcept {
  num_entries = 1;
  if (!cursor.Expect("[")) return false;
  do {
    const std::uint64_t offset = cursor.Offset();
    std::uint64_t dimension = 0;
    if (!cursor.ReadInteger(dimension)) return false;
    if (tensor.rank == format::kMaxRank || dimension == 0 ||
        dimension > format::kMaxFileBytes / num_entries) {
      return cursor.Fail(MakeError(HC_ERROR_FORMAT,
                                   offset,
                                   "the shape of tensor '%s' must have 1 to %zu dimensions of at "
                                   "least 1 and fit into a file",
                                   tensor.name.c_str(),
                                   format::kMaxRank));
    }
    tensor.shape[tensor.rank++] = dimension;
    num_entries *= dimension;
  } while (cursor.TakeIf(','));
  return cursor.Expect("]");
}

// § 2.2: "data_offsets":[0,24], counted from the first byte after the header.
bool ReadOffsets(HeaderCursor& cursor, std::uint64_t num_entries, TensorView& tensor) noexcept {
  const std::uint64_t offset = cursor.Offset();
  std::uint64_t end = 0;
  if (!cursor.Expect("[") || !cursor.ReadInteger(tensor.begin) || !cursor.Expect(",") ||
      !cursor.ReadInteger(end) || !cursor.Expect("]")) {
    return false;
  }
  tensor.num_bytes = num_entries * format::BytesOf(tensor.dtype);
  if (tensor.begin <= end && end - tensor.begin == tensor.num_bytes) return true;
  return cursor.Fail(MakeError(HC_ERROR_FORMAT,
                               offset,
                               "tensor '%s' spans the offsets %" PRIu64 " to %" PRIu64
                               ", but its shape takes %" PRIu64 " bytes",
                               tensor.name.c_str(),
                               tensor.begin,
                               end,
                               tensor.num_bytes));
}

// § 2.2: "name":{"dtype":"F32","shape":[2,3],"data_offsets":[0,24]}
bool ReadTensor(HeaderCursor& cursor, TensorView& tensor) {
  const std::uint64_t name_offset = cursor.Offset();
  if (!cursor.ReadString(format::kMaxNameBytes, tensor.name)) return false;
  if (!IsTensorName(tensor.name) || tensor.name > format::kChecksumTensor) {
    return cursor.Fail(MakeError(HC_ERROR_FORMAT,
                                 name_offset,
                                 "the tensor name '%s' breaks the rule [a-z][a-z0-9_.]{0,%zu} or "
                                 "sorts after '%s'",
                                 Printable(tensor.name).c_str(),
                                 format::kMaxNameBytes - 1,
                                 format::kChecksumTensor.data()));
  }
  std::uint64_t num_entries = 0;
  return cursor.Expect(":{\"dtype\":") && ReadDtype(cursor, tensor.dtype) &&
         cursor.Expect(",\"shape\":") && ReadShape(cursor, tensor, num_entries) &&
         cursor.Expect(",\"data_offsets\":") && ReadOffsets(cursor, num_entries, tensor) &&
         cursor.Expect("}");
}

// § 2.1: ,"name":{…} for every tensor, names rising.
bool ReadTensors(HeaderCursor& cursor, ParsedModel& model) {
  while (cursor.TakeIf(',')) {
    const std::uint64_t offset = cursor.Offset();
    TensorView tensor;
    if (!ReadTensor(cursor, tensor)) return false;
    if (!model.tensors.empty() &&
        !CheckOrder(cursor, offset, model.tensors.back().name, tensor.name)) {
      return false;
    }
    if (model.tensors.size() == format::kMaxTensors) {
      return cursor.Fail(
          MakeError(HC_ERROR_FORMAT, offset, "more than %zu tensors", format::kMaxTensors));
    }
    model.tensors.push_back(std::move(tensor));
  }
  return !cursor.Failed();
}

// § 3, before the tensors: a later format may describe them in ways unknown here.
bool CheckVersion(HeaderCursor& cursor, const ParsedModel& model) noexcept {
  const std::string* version = model.FindMetadata(format::kFormatKey);
  const std::string* needs = model.FindMetadata(format::kRequiresKey);
  const std::optional<ModelError> error =
      CheckFormatVersion(version == nullptr ? std::string_view() : *version,
                         needs == nullptr ? std::string_view() : *needs);
  return !error || cursor.Fail(*error);
}

}  // namespace

const TensorView* ParsedModel::FindTensor(std::string_view name) const noexcept {
  for (const TensorView& tensor : tensors) {
    if (tensor.name == name) return &tensor;
  }
  return nullptr;
}

const std::string* ParsedModel::FindMetadata(std::string_view key) const noexcept {
  for (const auto& [known, value] : metadata) {
    if (known == key) return &value;
  }
  return nullptr;
}

Result<ParsedModel> ReadModelHeader(std::span<const std::uint8_t> header) {
  HeaderCursor cursor(header, format::kLengthBytes);
  ParsedModel model;
  const bool complete = cursor.Expect("{") && ReadMetadata(cursor, model) &&
                        CheckVersion(cursor, model) && ReadTensors(cursor, model) &&
                        cursor.Expect("}") && cursor.ExpectPaddingToEnd();
  if (!complete) return cursor.error();
  return model;
}

}  // namespace handcraft::runtime
