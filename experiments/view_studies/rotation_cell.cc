// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/rotation_cell.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "datasets/described_views.h"
#include "lib/core/error.h"
#include "lib/features/object_rotation.h"

namespace handcraft::experiments {
namespace {

constexpr double kFullTurnDeg = 360.0;
constexpr double kHalfTurnDeg = 180.0;
constexpr const char* kHalfTurnName = "half_turn";

// What layer 2 knows of a view, and what is true of it.
struct DescribedView {
  features::ViewDescription description;
  std::string label;
  std::string symmetry;  // as the set has it
  double angle_deg = 0.0;
};

// A set's word for a symmetry as readers of a report know it.
std::string KindOf(const std::string& symmetry) {
  if (symmetry.empty()) return "symmetry unknown";
  return symmetry == "none" ? "asymmetric" : symmetry;
}

// All views that can be asked about, with their descriptions.
std::vector<DescribedView> DescribeAll(const datasets::ViewSet& set, int num_threads) {
  const std::vector<features::ViewDescription> descriptions =
      datasets::DescribeViews(set, num_threads, {});
  std::vector<DescribedView> views;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    const datasets::ObjectView& item = set.items[i];
    if (!item.angle_deg || item.symmetry == "round") continue;
    views.push_back({.description = descriptions[i],
                     .label = item.object_class,
                     .symmetry = item.symmetry,
                     .angle_deg = *item.angle_deg});
  }
  return views;
}

// The learnt views of one class, but one.
struct LearntViews {
  std::vector<double> normals;
  std::vector<double> moments;
  std::vector<double> angles_deg;
  features::HalvesMoments scales = {};

  LearntViews(const std::vector<DescribedView>& views,
              const std::string& label,
              const DescribedView* left_out) {
    for (const DescribedView& view : views) {
      if (view.label != label || &view == left_out) continue;
      const auto& [normal, mean, halves] = view.description;
      normals.insert(normals.end(), normal.begin(), normal.end());
      moments.insert(moments.end(), halves.begin(), halves.end());
      angles_deg.push_back(view.angle_deg);
    }
    if (!angles_deg.empty()) scales = features::MomentScales(moments);
  }

  [[nodiscard]] double AngleOfNearest(const features::ViewDescription& view,
                                      const features::RotationRule& rule) const {
    const features::KnownViews known{.normals = normals, .moments = moments, .scales = scales};
    return angles_deg[features::NearestView(view, known, rule)];
  }
};

AnswerCounts NoAnswers(const std::vector<DescribedView>& asked) {
  AnswerCounts answers{.row_title = "object", .counts = {}};
  std::map<std::string, std::string> symmetries;
  for (const DescribedView& view : asked) {
    if (!symmetries.emplace(view.label, view.symmetry).second) continue;
    answers.rows.push_back(view.label);
    answers.kinds.push_back(KindOf(view.symmetry));
  }
  answers.counts.assign(answers.rows.size(), std::vector<std::size_t>(kNumRotationBins));
  for (std::size_t bin = 0; bin < kNumRotationBins; ++bin) {
    answers.columns.push_back(fmt::format("{}°", kRotationBinDeg * static_cast<double>(bin)));
  }
  for (const std::string& row : answers.rows) {
    std::vector<bool>& is_right = answers.is_right.emplace_back();
    for (std::size_t bin = 0; bin < kNumRotationBins; ++bin) {
      is_right.push_back(
          IsRightRotation(kRotationBinDeg * static_cast<double>(bin), symmetries.at(row)));
    }
  }
  return answers;
}

// The groups of the rows, and of all rows of the same kind.
std::vector<GroupShare> GroupsOf(const AnswerCounts& answers) {
  std::vector<GroupShare> groups;
  std::map<std::string, std::vector<GroupShare>> by_kind;
  for (std::size_t row = 0; row < answers.rows.size(); ++row) {
    groups.push_back(ShareOfRow(answers, row));
    by_kind[answers.kinds[row]].push_back(groups.back());
  }
  for (const auto& [kind, parts] : by_kind) groups.push_back(ShareOfAll(kind, parts));
  return groups;
}

}  // namespace

std::size_t RotationBin(double difference_deg) noexcept {
  const double turned = std::fmod(
      std::fmod(difference_deg, kFullTurnDeg) + kFullTurnDeg + 0.5 * kRotationBinDeg, kFullTurnDeg);
  return static_cast<std::size_t>(turned / kRotationBinDeg) % kNumRotationBins;
}

bool IsRightRotation(double difference_deg, std::string_view symmetry) noexcept {
  const double period = symmetry == kHalfTurnName ? kHalfTurnDeg : kFullTurnDeg;
  const double rest = std::fabs(std::remainder(difference_deg, period));
  constexpr double kRounding = 1e-6;
  return rest <= kRotationBinDeg + kRounding;
}

ViewCellResult FindRotations(const ViewCell& cell,
                             const datasets::ViewSet& train,
                             const datasets::ViewSet* test,
                             int num_threads) {
  const std::vector<DescribedView> learnt = DescribeAll(train, num_threads);
  const std::vector<DescribedView> others =
      test == nullptr ? std::vector<DescribedView>{} : DescribeAll(*test, num_threads);
  const std::vector<DescribedView>& asked = test == nullptr ? learnt : others;
  if (asked.empty()) {
    throw Error({.reason = "no view has an angle and is of an object that is not round"});
  }
  ViewCellResult result{.id = cell.id, .answers = NoAnswers(asked)};
  const auto start = std::chrono::steady_clock::now();
  for (const DescribedView& view : asked) {
    const LearntViews known(learnt, view.label, test == nullptr ? &view : nullptr);
    if (known.angles_deg.empty()) {
      throw Error({.reason = fmt::format("no other view of \"{}\" was learnt", view.label)});
    }
    const double found = known.AngleOfNearest(view.description, cell.settings.rotation);
    const auto row = static_cast<std::size_t>(
        std::find(result.answers.rows.begin(), result.answers.rows.end(), view.label) -
        result.answers.rows.begin());
    ++result.answers.counts[row][RotationBin(found - view.angle_deg)];
  }
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  result.times.push_back({"nearest_view_ms", taken.count() / static_cast<double>(asked.size())});
  result.groups = GroupsOf(result.answers);
  return result;
}

}  // namespace handcraft::experiments
