// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/model_io/model_writer.h"
#include "lib/runtime/model_parser.h"

namespace handcraft::testing {

/// What a loader makes of a model's bytes.
template <auto kLoad>
auto LoadStored(const model_io::ModelFile& model) {
  const std::vector<std::uint8_t> bytes = model_io::Serialise(model);
  return kLoad(*runtime::ParseModel(bytes));
}

/// The values of a tensor of the model, to be changed.
template <class T>
std::vector<T>& In(model_io::ModelFile& model, const std::string& name) {
  return std::get<std::vector<T>>(model.tensors.at(name).values);
}

/// Expects a loader to refuse a model that was changed, with this status and message.
template <auto kLoad>
void ExpectRefusal(model_io::ModelFile model,
                   const std::function<void(model_io::ModelFile&)>& change,
                   const std::string& message,
                   hc_status status) {
  change(model);
  const auto loaded = LoadStored<kLoad>(model);
  ASSERT_FALSE(loaded) << message;
  EXPECT_EQ(loaded.error().status, status) << loaded.error().message;
  EXPECT_THAT(loaded.error().message, ::testing::HasSubstr(message));
}

}  // namespace handcraft::testing
