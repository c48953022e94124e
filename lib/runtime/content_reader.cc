// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/content_reader.h"

#include <algorithm>
#include <cinttypes>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstring>

#include "lib/core/utf8.h"

namespace handcraft::runtime {
namespace {

using format::Dtype;

template <class T>
constexpr Dtype kDtypeOf = Dtype::kU8;
template <>
constexpr Dtype kDtypeOf<float> = Dtype::kF32;
template <>
constexpr Dtype kDtypeOf<double> = Dtype::kF64;
template <>
constexpr Dtype kDtypeOf<std::int32_t> = Dtype::kI32;

// "F32[24,?]", for messages.
class ShapeText {
 public:
  ShapeText(Dtype dtype, const std::uint64_t* shape, std::size_t rank) noexcept {
    Append("%s", format::NameOf(dtype).data());
    for (std::size_t i = 0; i < rank; ++i) {
      const char* separator = i == 0 ? "[" : ",";
      if (shape[i] == kAnyLength) {
        Append("%s?", separator);
      } else {
        Append("%s%" PRIu64, separator, shape[i]);
      }
    }
    Append("]");
  }
  [[nodiscard]] const char* c_str() const noexcept { return buffer_.data(); }

 private:
  __attribute__((format(printf, 2, 3))) void Append(const char* format, ...) noexcept {
    va_list arguments;
    va_start(arguments, format);
    const int length =
        std::vsnprintf(buffer_.data() + used_, buffer_.size() - used_, format, arguments);
    va_end(arguments);
    used_ = std::min(used_ + static_cast<std::size_t>(std::max(length, 0)), buffer_.size() - 1);
  }

  std::array<char, 64> buffer_{};
  std::size_t used_ = 0;
};

}  // namespace

bool ContentReader::Fail(const ModelError& error) noexcept {
  if (!error_) error_ = error;
  return false;
}

const TensorView* ContentReader::Find(std::string_view name) noexcept {
  const TensorView* tensor = model_.FindTensor(name);
  if (tensor != nullptr) known_[static_cast<std::size_t>(tensor - model_.tensors.data())] = true;
  return tensor;
}

std::uint64_t ContentReader::OffsetOf(std::string_view name) const noexcept {
  const TensorView* tensor = model_.FindTensor(name);
  return tensor == nullptr ? kNoOffset : tensor->byte_offset;
}

const TensorView* ContentReader::FindWithShape(
    std::string_view name, Dtype dtype, std::initializer_list<std::uint64_t> shape) noexcept {
  if (error_) return nullptr;
  const ShapeText wanted(dtype, shape.begin(), shape.size());
  const TensorView* tensor = Find(name);
  if (tensor == nullptr) {
    Fail(MakeError(HC_ERROR_CONTENT,
                   kNoOffset,
                   "the tensor '%s' %s is missing",
                   Printable(name).c_str(),
                   wanted.c_str()));
    return nullptr;
  }
  const bool fits = tensor->dtype == dtype && tensor->rank == shape.size() &&
                    std::equal(shape.begin(),
                               shape.end(),
                               tensor->shape.begin(),
                               [](std::uint64_t expected, std::uint64_t found) {
                                 return expected == kAnyLength || expected == found;
                               });
  if (fits) return tensor;
  Fail(MakeError(HC_ERROR_CONTENT,
                 tensor->byte_offset,
                 "the tensor '%s' is %s where %s was expected",
                 Printable(name).c_str(),
                 ShapeText(tensor->dtype, tensor->shape.data(), tensor->rank).c_str(),
                 wanted.c_str()));
  return nullptr;
}

template <class T>
bool ContentReader::Read(std::string_view name,
                         std::initializer_list<std::uint64_t> shape,
                         std::vector<T>& values) {
  const TensorView* tensor = FindWithShape(name, kDtypeOf<T>, shape);
  if (tensor == nullptr) return false;
  values.resize(tensor->bytes.size() / sizeof(T));
  std::memcpy(values.data(), tensor->bytes.data(), tensor->bytes.size());
  return true;
}

template bool ContentReader::Read(std::string_view,
                                  std::initializer_list<std::uint64_t>,
                                  std::vector<float>&);
template bool ContentReader::Read(std::string_view,
                                  std::initializer_list<std::uint64_t>,
                                  std::vector<double>&);
template bool ContentReader::Read(std::string_view,
                                  std::initializer_list<std::uint64_t>,
                                  std::vector<std::int32_t>&);
template bool ContentReader::Read(std::string_view,
                                  std::initializer_list<std::uint64_t>,
                                  std::vector<std::uint8_t>&);

bool ContentReader::ReadNames(std::string_view name,
                              std::size_t count,
                              const char* counted,
                              std::vector<std::string>& names) {
  std::vector<std::uint8_t> bytes;
  if (!Read(name, {kAnyLength}, bytes)) return false;
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (const std::size_t good = Utf8PrefixLength(text); good < text.size()) {
    return Fail(MakeError(HC_ERROR_CONTENT,
                          OffsetOf(name) + good,
                          "the tensor '%s' is not UTF-8 here",
                          Printable(name).c_str()));
  }
  names.assign(1, {});
  for (const char c : text) {
    if (c == '\n') {
      names.emplace_back();
    } else {
      names.back() += c;
    }
  }
  if (names.size() == count) return true;
  return Fail(MakeError(HC_ERROR_CONTENT,
                        OffsetOf(name),
                        "the tensor '%s' holds %zu names for %zu %s",
                        Printable(name).c_str(),
                        names.size(),
                        count,
                        counted));
}

bool ContentReader::CheckNormaliser(std::uint64_t num_features) {
  std::vector<double> mean;
  std::vector<double> scale;
  if (!Read("feature_mean", {num_features}, mean) ||
      !Read("feature_scale", {num_features}, scale)) {
    return false;
  }
  for (std::size_t i = 0; i < scale.size(); ++i) {
    if (scale[i] > 0.0) continue;
    return Fail(MakeError(HC_ERROR_CONTENT,
                          OffsetOf("feature_scale") + i * sizeof(double),
                          "entry %zu of the tensor 'feature_scale' is %g where a positive number "
                          "was expected",
                          i,
                          scale[i]));
  }
  return true;
}

bool ContentReader::RefuseUnknownTensors() noexcept {
  if (error_) return false;
  for (std::size_t i = 0; i < model_.tensors.size(); ++i) {
    const TensorView& tensor = model_.tensors[i];
    if (known_[i] || tensor.name == format::kChecksumTensor ||
        tensor.name.starts_with(format::kExtensionPrefix)) {
      continue;
    }
    return Fail(MakeError(HC_ERROR_CONTENT,
                          tensor.byte_offset,
                          "the tensor '%s' is unknown to this kind of model; install a newer "
                          "Handcraft runtime, or name it x.%s",
                          Printable(tensor.name).c_str(),
                          Printable(tensor.name).c_str()));
  }
  return true;
}

bool ContentReader::ExpectMetadata(std::string_view key, std::string_view expected) noexcept {
  if (error_) return false;
  const std::string* found = model_.FindMetadata(key);
  if (found != nullptr && *found == expected) return true;
  return Fail(MakeError(HC_ERROR_CONTENT,
                        format::kLengthBytes,
                        "the metadata key %s holds '%s', but the tensors say '%s'",
                        Printable(key).c_str(),
                        found == nullptr ? "" : Printable(*found).c_str(),
                        Printable(expected).c_str()));
}

}  // namespace handcraft::runtime
