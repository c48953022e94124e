// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/model_parser.h"

#include <algorithm>
#include <bit>
#include <cinttypes>
#include <cstring>
#include <new>
#include <optional>

#include "lib/runtime/crc32c.h"

namespace handcraft::runtime {
namespace {

static_assert(std::endian::native == std::endian::little, "tensors are read in place");

using format::Dtype;
using MaybeError = std::optional<ModelError>;

std::uint64_t ReadLittleEndian64(const std::uint8_t* bytes) noexcept {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

// § 2.1: neither too short for a header nor too long.
MaybeError CheckFileSize(std::span<const std::uint8_t> bytes) noexcept {
  if (bytes.empty()) {
    return MakeError(HC_ERROR_TRUNCATED, 0, "the file is empty; copy or train the model again");
  }
  if (bytes.size() > format::kMaxFileBytes) {
    return MakeError(HC_ERROR_FORMAT,
                     0,
                     "not a model file: %zu bytes, more than the %zu allowed",
                     bytes.size(),
                     format::kMaxFileBytes);
  }
  if (bytes.size() <= format::kLengthBytes) {
    return MakeError(HC_ERROR_TRUNCATED,
                     bytes.size(),
                     "the file ends after %zu bytes, inside the header; copy it again",
                     bytes.size());
  }
  return std::nullopt;
}

// § 2.1: where the header lies. On success *header is set.
MaybeError FindHeader(std::span<const std::uint8_t> bytes,
                      std::span<const std::uint8_t>* header) noexcept {
  if (const MaybeError error = CheckFileSize(bytes)) return error;
  const std::uint64_t length = ReadLittleEndian64(bytes.data());
  if (bytes[format::kLengthBytes] != '{' || length > format::kMaxHeaderBytes) {
    return MakeError(HC_ERROR_FORMAT,
                     0,
                     "not a model file: it must begin with a header length of at most %zu and '{'",
                     format::kMaxHeaderBytes);
  }
  if (length > bytes.size() - format::kLengthBytes) {
    return MakeError(HC_ERROR_TRUNCATED,
                     bytes.size(),
                     "the file ends after %zu bytes, inside its header of %" PRIu64
                     " bytes; copy it again",
                     bytes.size(),
                     length);
  }
  if ((length + format::kLengthBytes) % format::kDataAlignment != 0) {
    return MakeError(HC_ERROR_FORMAT,
                     0,
                     "the header length %" PRIu64 " does not put the tensors at a multiple of %zu",
                     length,
                     format::kDataAlignment);
  }
  *header = bytes.subspan(format::kLengthBytes, static_cast<std::size_t>(length));
  return std::nullopt;
}

// § 2.4: the last bytes of the file are "C32C" and the CRC-32C of all before them.
bool ChecksumMatches(std::span<const std::uint8_t> bytes) noexcept {
  if (bytes.size() < format::kChecksumBytes) return false;
  const auto covered = bytes.first(bytes.size() - format::kChecksumBytes);
  const std::uint8_t* mark = covered.data() + covered.size();
  std::uint32_t stored = 0;
  std::memcpy(&stored, mark + format::kChecksumMark.size(), sizeof stored);
  return std::memcmp(mark, format::kChecksumMark.data(), format::kChecksumMark.size()) == 0 &&
         stored == Crc32c(covered);
}

// § 2.2, § 2.3: in storage order the tensors follow each other without gap or overlap, the checksum
// last. On success *end is the end of the last one's data.
MaybeError CheckOrder(const ParsedModel& model, std::size_t data_offset, std::uint64_t* end) {
  std::vector<const TensorView*> stored;
  stored.reserve(model.tensors.size());
  for (const TensorView& tensor : model.tensors) stored.push_back(&tensor);
  std::sort(stored.begin(), stored.end(), [](const TensorView* a, const TensorView* b) {
    return format::StoredBefore(a->dtype, a->name, b->dtype, b->name);
  });
  const TensorView* last = stored.empty() ? nullptr : stored.back();
  if (last == nullptr || last->name != format::kChecksumTensor || last->rank != 1 ||
      last->num_bytes != format::kChecksumBytes) {
    return MakeError(HC_ERROR_FORMAT,
                     format::kLengthBytes,
                     "the header lacks the checksum 'zz.crc' of dtype U8 and shape [8]");
  }
  *end = 0;
  for (const TensorView* tensor : stored) {
    if (tensor->begin != *end) {
      return MakeError(HC_ERROR_FORMAT,
                       data_offset + *end,
                       "tensor '%s' begins at offset %" PRIu64 " where %" PRIu64
                       " was expected: tensors follow each other, wide entries first, then by name",
                       tensor->name.c_str(),
                       tensor->begin,
                       *end);
    }
    *end += tensor->num_bytes;
  }
  return std::nullopt;
}

// § 2.2, § 2.3: the tensors lie from the end of the header to the end of the file. Sets where.
MaybeError LayOut(std::span<const std::uint8_t> bytes,
                  std::size_t data_offset,
                  ParsedModel& model) {
  std::uint64_t end = 0;
  if (const MaybeError error = CheckOrder(model, data_offset, &end)) return error;
  const std::uint64_t needed = data_offset + end;
  if (needed > bytes.size()) {
    return MakeError(HC_ERROR_TRUNCATED,
                     bytes.size(),
                     "the file ends after %zu of %" PRIu64 " bytes; copy it again",
                     bytes.size(),
                     needed);
  }
  if (needed < bytes.size()) {
    return MakeError(
        HC_ERROR_FORMAT, needed, "%" PRIu64 " bytes follow the last tensor", bytes.size() - needed);
  }
  for (TensorView& tensor : model.tensors) {
    tensor.byte_offset = data_offset + tensor.begin;
    tensor.bytes = bytes.subspan(static_cast<std::size_t>(tensor.byte_offset),
                                 static_cast<std::size_t>(tensor.num_bytes));
  }
  return std::nullopt;
}

// An IEEE 754 number is finite unless its exponent bits are all ones.
template <class Bits, Bits kExponent>
std::optional<std::size_t> FirstNotFinite(std::span<const std::uint8_t> bytes) noexcept {
  for (std::size_t i = 0; i < bytes.size(); i += sizeof(Bits)) {
    Bits bits = 0;
    std::memcpy(&bits, bytes.data() + i, sizeof bits);
    if ((bits & kExponent) == kExponent) return i / sizeof(Bits);
  }
  return std::nullopt;
}

// § 2.2: no tensor holds a NaN or an infinity.
MaybeError CheckFinite(const ParsedModel& model) noexcept {
  for (const TensorView& tensor : model.tensors) {
    std::optional<std::size_t> index;
    if (tensor.dtype == Dtype::kF32) {
      index = FirstNotFinite<std::uint32_t, 0x7F800000U>(tensor.bytes);
    } else if (tensor.dtype == Dtype::kF64) {
      index = FirstNotFinite<std::uint64_t, 0x7FF0000000000000U>(tensor.bytes);
    }
    if (!index) continue;
    return MakeError(HC_ERROR_FORMAT,
                     tensor.byte_offset + *index * format::BytesOf(tensor.dtype),
                     "entry %zu of tensor '%s' is not a finite number; train the model again",
                     *index,
                     tensor.name.c_str());
  }
  return std::nullopt;
}

Result<ParsedModel> ParseAfterLength(std::span<const std::uint8_t> bytes,
                                     std::span<const std::uint8_t> header) {
  Result<ParsedModel> model = ReadModelHeader(header);
  if (!model) return model;
  MaybeError error = LayOut(bytes, format::kLengthBytes + header.size(), *model);
  if (!error) error = CheckFinite(*model);
  if (error) return *error;
  return model;
}

}  // namespace

Result<ParsedModel> ParseModel(std::span<const std::uint8_t> bytes) noexcept {
  try {
    std::span<const std::uint8_t> header;
    if (const MaybeError error = FindHeader(bytes, &header)) return *error;
    Result<ParsedModel> model = ParseAfterLength(bytes, header);
    const bool truncated = !model && model.error().status == HC_ERROR_TRUNCATED;
    if (truncated || ChecksumMatches(bytes)) return model;
    return MakeError(HC_ERROR_CHECKSUM,
                     model ? bytes.size() - format::kChecksumBytes : model.error().byte_offset,
                     "the file is damaged: its checksum does not match its bytes; copy it again");
  } catch (const std::bad_alloc&) {
    return MakeError(HC_ERROR_MEMORY, kNoOffset, "out of memory while reading the model's header");
  }
}

}  // namespace handcraft::runtime
