// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/image.h"
#include "lib/model_io/model_writer.h"
#include "lib/runtime/handcraft_runtime.h"

/// The C interface with owners that free, for tests.
namespace handcraft::testing {

struct Deleter {
  void operator()(hc_model* model) const { hc_model_free(model); }
  void operator()(hc_workspace* workspace) const { hc_workspace_free(workspace); }
};
using Model = std::unique_ptr<hc_model, Deleter>;
using Workspace = std::unique_ptr<hc_workspace, Deleter>;

/// Expects the model to load.
inline Model Load(const std::vector<std::uint8_t>& bytes) {
  hc_model* model = nullptr;
  hc_error error{};
  const hc_status status = hc_model_load_memory(bytes.data(), bytes.size(), &model, &error);
  EXPECT_EQ(status, HC_OK) << error.message;
  EXPECT_EQ(error.status, status);
  return Model(model);
}

inline Model Load(const model_io::ModelFile& model) { return Load(model_io::Serialise(model)); }

inline Workspace MakeWorkspace(const Model& model, std::int32_t width, std::int32_t height) {
  hc_workspace* workspace = nullptr;
  EXPECT_EQ(hc_workspace_create(model.get(), width, height, &workspace), HC_OK);
  return Workspace(workspace);
}

inline hc_image View(const Image& picture) {
  return {picture.values().data(),
          picture.width(),
          picture.height(),
          std::int64_t{picture.width()} * picture.channels(),
          picture.channels() == 1 ? HC_GRAY8 : HC_BGR8};
}

}  // namespace handcraft::testing
