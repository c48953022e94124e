// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "lib/features/object_cloud.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::runtime {

/// Whether the pointers, sizes and strides of a caller's cloud can be read.
[[nodiscard]] bool IsCloud(const hc_cloud& cloud) noexcept;

/// The cloud as features take it.
[[nodiscard]] features::ObjectCloud ViewOf(const hc_cloud& cloud) noexcept;

}  // namespace handcraft::runtime
