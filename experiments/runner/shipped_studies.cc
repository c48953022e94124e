// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/shipped_studies.h"

#include "experiments/runner/shipped_study_texts.h"

namespace handcraft::experiments {

std::span<const ShippedStudy> ShippedStudies() { return kShippedStudies; }

const ShippedStudy* FindShippedStudy(std::string_view name) {
  for (const ShippedStudy& study : ShippedStudies()) {
    if (study.name == name) return &study;
  }
  return nullptr;
}

}  // namespace handcraft::experiments
