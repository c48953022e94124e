// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

/// Constants of the model file that reader and writer share; § numbers are sections of
/// docs/model_format.md.
namespace handcraft::runtime::format {

// § 2.1 Limits.
inline constexpr std::size_t kMaxFileBytes = std::size_t{256} << 20;
inline constexpr std::size_t kLengthBytes = 8;
inline constexpr std::size_t kMaxHeaderBytes = std::size_t{1} << 20;
inline constexpr std::size_t kMaxTensors = 64;
inline constexpr std::size_t kMaxRank = 4;
inline constexpr std::size_t kMaxNameBytes = 63;
inline constexpr std::size_t kMaxMetadataKeys = 256;
inline constexpr std::size_t kMaxKeyBytes = 127;
inline constexpr std::size_t kMaxValueBytes = std::size_t{16} << 10;
inline constexpr std::uint64_t kMaxInteger = std::uint64_t{1} << 53;
/// § 2.3 The tensor data begin at a multiple of this.
inline constexpr std::size_t kDataAlignment = 64;

// § 2.4 Checksum.
inline constexpr std::string_view kChecksumTensor = "zz.crc";
inline constexpr std::string_view kChecksumMark = "C32C";
inline constexpr std::size_t kChecksumBytes = 8;

// § 3 Versions.
inline constexpr std::uint64_t kMajor = 1;
inline constexpr std::string_view kVersionText = "1.0";

// § 4 Metadata keys the reader looks at.
inline constexpr std::string_view kMetadataName = "__metadata__";
inline constexpr std::string_view kFormatKey = "hc.format";
inline constexpr std::string_view kRequiresKey = "hc.requires";
inline constexpr std::string_view kKindKey = "hc.kind";
inline constexpr std::string_view kKindVersionKey = "hc.kind_version";
inline constexpr std::string_view kFeaturesKey = "hc.features";
inline constexpr std::string_view kFeaturesHashKey = "hc.features.sha256";

inline constexpr std::string_view kGraspPointKind = "grasp_point";
inline constexpr std::string_view kLogisticKind = "logistic";
inline constexpr std::string_view kSvmKind = "svm";
inline constexpr std::string_view kObjectClassKind = "object_class";
inline constexpr std::string_view kGraspLibraryKind = "grasp_library";
inline constexpr std::string_view kKindVersion = "1";

/// § 2.2 Tensors with this prefix are carried along and never looked at.
inline constexpr std::string_view kExtensionPrefix = "x.";

/// § 2.2 Types of tensor entries.
enum class Dtype : std::uint8_t { kF64, kI64, kF32, kI32, kU8 };
struct DtypeName {
  Dtype dtype;
  std::string_view name;
  std::size_t bytes;
};
inline constexpr std::array<DtypeName, 5> kDtypes = {{{Dtype::kF64, "F64", 8},
                                                      {Dtype::kI64, "I64", 8},
                                                      {Dtype::kF32, "F32", 4},
                                                      {Dtype::kI32, "I32", 4},
                                                      {Dtype::kU8, "U8", 1}}};

[[nodiscard]] constexpr std::string_view NameOf(Dtype dtype) noexcept {
  return kDtypes[static_cast<std::size_t>(dtype)].name;
}
[[nodiscard]] constexpr std::size_t BytesOf(Dtype dtype) noexcept {
  return kDtypes[static_cast<std::size_t>(dtype)].bytes;
}

/// § 2.2 Order of the tensors' bytes: wide entries first, so that every tensor is aligned to its
/// own entries without gaps; then by name.
[[nodiscard]] constexpr bool StoredBefore(Dtype a,
                                          std::string_view name_a,
                                          Dtype b,
                                          std::string_view name_b) noexcept {
  return BytesOf(a) != BytesOf(b) ? BytesOf(a) > BytesOf(b) : name_a < name_b;
}

}  // namespace handcraft::runtime::format
