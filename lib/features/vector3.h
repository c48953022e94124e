// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

namespace handcraft::features {

/// A point [m] or a direction: x, y, z.
using Vector3 = std::array<double, 3>;

}  // namespace handcraft::features
