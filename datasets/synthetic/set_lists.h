// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/hold_set.h"
#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/view_set.h"
#include "datasets/synthetic/set_folder.h"

/// The lists of made-up sets, which are written last. A list that tells the same already is left
/// alone; one that cannot be read or tells something else is replaced. What is written is counted.
/// Throws Error when it cannot be.
namespace handcraft::synthetic {

/// manifest.csv. One that lists the same pictures and masks is left alone and taken over into the
/// set, with the splits that handcraft data split, and the classes and columns that people gave.
void WriteList(datasets::LabelledImageSet& set, Written& written);

/// views.csv. One that tells the same but for its splits is left alone, and these are taken over.
void WriteList(datasets::ViewSet& set, Written& written);

/// demonstrations.csv, in whatever order.
void WriteList(const datasets::DemonstrationSet& set, Written& written);

/// holds.csv, in whatever order.
void WriteList(const datasets::HoldSet& set, Written& written);

}  // namespace handcraft::synthetic
