// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "datasets/formats/fault.h"
#include "datasets/formats/labelled_image_set.h"
#include "lib/core/image.h"
#include "lib/core/progress.h"

namespace handcraft::datasets {

/// What is worth knowing about a label mask: that it has no good or no bad pixel.
[[nodiscard]] std::vector<Fault> NotesOnMask(const std::string& path, const Image& mask);

/// What `handcraft data check` prints: opens every file of a labelled image set and names each
/// fault, in the order of the manifest; nothing when all is well. Pictures that cannot be read;
/// masks that do not fit or hold other values; pictures that are there twice; companions that are
/// missing or do not fit the picture. A mask without good or without bad pixels is a note. Same
/// set, same faults for any number of threads.
[[nodiscard]] std::vector<Fault> FindFaults(const LabelledImageSet& set,
                                            int num_threads = 1,
                                            const Progress& progress = {});

}  // namespace handcraft::datasets
