// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_examples.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "experiments/evaluation/loaded_model.h"
#include "experiments/evaluation/report_pictures.h"
#include "experiments/evaluation/runtime_scoring.h"
#include "experiments/runner/object_region.h"
#include "lib/perception/overlay.h"

namespace handcraft::experiments {
namespace {

constexpr int kWidthPx = 320;

std::set<std::string> TestedImages(const CellResult& result) {
  std::set<std::string> names;
  for (const ImageFigures& image : result.images) names.insert(image.image);
  return names;
}

// The pictures of all first repetitions, by name.
std::vector<std::string> SharedImages(const StudyRun& run, const StudySummary& summary) {
  std::set<std::string> shared = TestedImages(run.results[summary.series.front().cells.front()]);
  for (const SeriesSummary& series : summary.series) {
    const std::set<std::string> other = TestedImages(run.results[series.cells.front()]);
    std::set<std::string> both;
    std::set_intersection(
        shared.begin(), shared.end(), other.begin(), other.end(), std::inserter(both, both.end()));
    shared = std::move(both);
  }
  return {shared.begin(), shared.end()};
}

// A picture to test with, and where it comes from.
struct TestPicture {
  const datasets::LabelledImageSet& set;
  std::size_t index;
  Image image;
};

// Scored where the cell looks for best pixels.
RuntimeScores ScoreExample(const hc_model* model,
                           const CellSettings& settings,
                           const TestPicture& picture) {
  const std::string& name = picture.set.items[picture.index].image;
  if (settings.region == TestRegion::kPicture) {
    return ScoreWithRuntime(model, picture.image, name);
  }
  const perception::SearchRegion region =
      FindObjectRegion(picture.set, picture.index, picture.image);
  const Image nowhere(picture.image.width(), picture.image.height());
  return ScoreWithRuntime(model, picture.image, name, region.HasRegion() ? &region.mask : &nowhere);
}

ExampleOverlay MakeOverlay(const StudyRun& run,
                           const SeriesSummary& series,
                           const std::filesystem::path& out,
                           const TestPicture& picture) {
  const std::size_t cell = series.cells.front();
  const LoadedModel model = LoadModel(ModelFileOf(out, run.cells[cell]));
  const RuntimeScores scores = ScoreExample(model.get(), run.cells[cell].settings, picture);
  const EvaluationOptions options;
  std::vector<perception::MarkedPoint> points;
  for (const hc_point& point :
       FindBestPixels(scores.probabilities, options.best_pixels, options.best_min_probability, 0)) {
    points.push_back({point.u, point.v, point.probability});
  }
  ExampleOverlay overlay{
      .label = series.label,
      .best = {},
      .jpeg = EncodeJpeg(perception::DrawGraspPoints(picture.image, scores.probabilities, points),
                         kWidthPx)};
  for (const ImageFigures& figures : run.results[cell].images) {
    if (figures.image == picture.set.items[picture.index].image) overlay.best = figures.best;
  }
  return overlay;
}

}  // namespace

std::vector<Example> MakeExamples(const StudyRun& run,
                                  const StudySummary& summary,
                                  const std::filesystem::path& out,
                                  std::size_t max_count) {
  const std::vector<std::string> shared = SharedImages(run, summary);
  const datasets::LabelledImageSet& set = run.data.test ? *run.data.test : run.data.train;
  std::vector<Example> examples;
  const std::size_t count = std::min(max_count, shared.size());
  for (std::size_t k = 0; k < count; ++k) {
    const std::string& name = shared[k * shared.size() / count];
    const auto item = std::find_if(
        set.items.begin(), set.items.end(), [&](const auto& each) { return each.image == name; });
    const auto index = static_cast<std::size_t>(item - set.items.begin());
    datasets::LabelledPicture labelled = datasets::ReadLabelledPicture(set, index);
    Example example{.image = name,
                    .object_class = set.items[index].object_class,
                    .labels_jpeg = EncodeJpeg(
                        perception::DrawLabelMask(labelled.image, labelled.mask), kWidthPx),
                    .overlays = {}};
    const TestPicture picture{.set = set, .index = index, .image = std::move(labelled.image)};
    for (const SeriesSummary& series : summary.series) {
      example.overlays.push_back(MakeOverlay(run, series, out, picture));
    }
    examples.push_back(std::move(example));
  }
  return examples;
}

}  // namespace handcraft::experiments
