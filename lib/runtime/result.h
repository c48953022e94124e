// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <utility>
#include <variant>

#include "lib/runtime/model_error.h"

namespace handcraft::runtime {

/// A value, or the reason why there is none. Stands in for std::expected (C++23), with its member
/// names, and never throws: value() and error() must be asked for the one that is there.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) noexcept  // NOLINT(google-explicit-constructor): `return value;`
      : state_(std::in_place_index<0>, std::move(value)) {}
  Result(const ModelError& error) noexcept  // NOLINT(google-explicit-constructor): `return error;`
      : state_(std::in_place_index<1>, error) {}

  [[nodiscard]] bool has_value() const noexcept { return state_.index() == 0; }
  [[nodiscard]] explicit operator bool() const noexcept { return has_value(); }

  [[nodiscard]] T& value() & noexcept { return *std::get_if<0>(&state_); }
  [[nodiscard]] const T& value() const& noexcept { return *std::get_if<0>(&state_); }
  [[nodiscard]] T&& value() && noexcept { return std::move(*std::get_if<0>(&state_)); }
  [[nodiscard]] T& operator*() noexcept { return value(); }
  [[nodiscard]] const T& operator*() const noexcept { return value(); }
  [[nodiscard]] T* operator->() noexcept { return &value(); }
  [[nodiscard]] const T* operator->() const noexcept { return &value(); }

  [[nodiscard]] const ModelError& error() const noexcept { return *std::get_if<1>(&state_); }

 private:
  std::variant<T, ModelError> state_;
};

}  // namespace handcraft::runtime
