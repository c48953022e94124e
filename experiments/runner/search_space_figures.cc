// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/search_space_figures.h"

#include <algorithm>
#include <string_view>

namespace handcraft::experiments {
namespace {

SearchStageFigures& StageNamed(std::vector<SearchStageFigures>& stages, std::string_view name) {
  const auto found = std::find_if(
      stages.begin(), stages.end(), [&](const auto& stage) { return stage.stage == name; });
  if (found != stages.end()) return *found;
  return stages.emplace_back(SearchStageFigures{.stage = std::string(name)});
}

void DivideBy(std::size_t count, SearchSpaceFigures& sums) {
  for (SearchStageFigures& stage : sums.stages) {
    stage.num_pixels /= static_cast<double>(count);
    stage.time_ms /= static_cast<double>(count);
  }
}

}  // namespace

SearchSpaceFigures SearchSpaceOf(std::span<const ImageScore> images) {
  SearchSpaceFigures figures;
  for (const ImageScore& image : images) {
    if (!image.search) continue;
    figures.num_images_without_region += image.search->has_region ? 0 : 1;
    for (const perception::SearchStage& stage : image.search->stages) {
      SearchStageFigures& sum = StageNamed(figures.stages, stage.name);
      sum.num_pixels += static_cast<double>(stage.num_pixels);
      sum.time_ms += stage.time_ms;
    }
  }
  DivideBy(images.size(), figures);
  return figures;
}

SearchSpaceFigures Pooled(std::span<const SearchSpaceFigures> repetitions) {
  SearchSpaceFigures pooled;
  for (const SearchSpaceFigures& repetition : repetitions) {
    pooled.num_images_without_region += repetition.num_images_without_region;
    for (const SearchStageFigures& stage : repetition.stages) {
      SearchStageFigures& sum = StageNamed(pooled.stages, stage.stage);
      sum.num_pixels += stage.num_pixels;
      sum.time_ms += stage.time_ms;
    }
  }
  DivideBy(repetitions.size(), pooled);
  return pooled;
}

}  // namespace handcraft::experiments
