// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/demonstrations.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "datasets/parallel_reporting.h"
#include "datasets/synthetic/set_folder.h"
#include "datasets/synthetic/set_lists.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;

constexpr int kSmallPosesPerView = 40;
constexpr int kOtherPosesPerView = 333;  // 23948 poses of 6 classes in 12 views

// Dissertation, Table 4.1.
struct TaughtCount {
  std::string_view object_class;
  int num_poses;
};
constexpr std::array<TaughtCount, 6> kTaughtCounts = {{{"coffee_can", 5607},
                                                       {"drill", 3623},
                                                       {"mouthwash_bottle", 3619},
                                                       {"mug", 1795},
                                                       {"detergent_bottle", 4419},
                                                       {"plastic_bottle", 4885}}};

int NumPosesOfClass(const ObjectClass& kind, const DemonstrationOptions& options) {
  const int num_views = options.views.num_views;
  if (options.poses_per_view > 0) return num_views * options.poses_per_view;
  if (options.quota == PoseQuota::kSmall) return num_views * kSmallPosesPerView;
  const auto taught =
      std::find_if(kTaughtCounts.begin(), kTaughtCounts.end(), [&](const TaughtCount& count) {
        return kind.family == Family::kTaught && count.object_class == kind.name;
      });
  return taught == kTaughtCounts.end() ? num_views * kOtherPosesPerView : taught->num_poses;
}

std::string ToToml(const DemonstrationOptions& options) {
  const std::string quota = options.quota == PoseQuota::kFull ? "full" : "small";
  return ViewSetToToml("demonstrations", options.views) +
         fmt::format("\n[demonstrations]\nposes_per_view = {}\n",
                     options.poses_per_view > 0 ? std::to_string(options.poses_per_view)
                                                : "\"" + quota + "\"");
}

// Adds the width between the contacts of one more pose.
void AddWidth(ClassReport& report, float width_m) {
  const auto count = static_cast<float>(report.num_poses);
  report.least_width_m = report.num_poses == 0 ? width_m : std::min(report.least_width_m, width_m);
  report.greatest_width_m = std::max(report.greatest_width_m, width_m);
  report.mean_width_m = (count * report.mean_width_m + width_m) / (count + 1.0F);
  ++report.num_poses;
}

// All poses of one class, view after view.
class ClassShow {
 public:
  ClassShow(const ObjectClass& kind, const DemonstrationOptions& options)
      : kind_(kind),
        options_(options),
        check_(DrawInstance(kind, options.views.seed, 0).mesh, options.gripper, options.rules) {
    report_.object_class = std::string(kind.name);
    Rng rng = Rng::Stream(options.views.seed, report_.object_class + " grasps");
    grasps_ = SampleGrasps(check_, options.sampler, rng, report_.sampled);
    RequireGrasps(grasps_, kind.name, report_.sampled);
  }

  // The poses of the class's view of this number, which is `view` in views.csv.
  void ShowView(int number, const datasets::ObjectView& view) {
    const auto angle_deg = static_cast<float>(view.angle_deg.value());
    const PlacedBeforeArm place{.base_from_object = TurntablePose(angle_deg),
                                .arm_in_base = RightArm()};
    const std::string stream = fmt::format("{} shown {}", kind_.name, number);
    Rng favourites = Rng::Stream(options_.views.seed, stream + " favourites");
    const Demonstrator demonstrator(check_, grasps_, place, options_.demonstrator, favourites);
    for (int i = 0; i < NumPoses(kind_, number, options_); ++i) {
      Rng rng = Rng::Stream(options_.views.seed, stream, static_cast<std::uint64_t>(i));
      const ShownGrasp shown = demonstrator.Show(rng, report_.shown);
      AddWidth(report_, shown.contacts.WidthM());
      items_.push_back({.object_class = view.object_class,
                        .instance = view.instance,
                        .view = view.image,
                        .angle_deg = view.angle_deg,
                        .pose = shown.base_from_grasp});
    }
  }

  [[nodiscard]] const ClassReport& report() const noexcept { return report_; }
  [[nodiscard]] const std::vector<datasets::Demonstration>& items() const noexcept {
    return items_;
  }

 private:
  const ObjectClass& kind_;
  const DemonstrationOptions& options_;
  GraspCheck check_;
  ClassReport report_;
  std::vector<Grasp> grasps_;
  std::vector<datasets::Demonstration> items_;
};

// What one class gave, in its place.
struct Shown {
  ClassReport report;
  std::vector<datasets::Demonstration> items;
};

Shown ShowClass(const ObjectClass& kind,
                std::span<const datasets::ObjectView> views,
                const DemonstrationOptions& options) {
  ClassShow show(kind, options);
  for (std::size_t number = 0; number < views.size(); ++number) {
    try {
      show.ShowView(static_cast<int>(number), views[number]);
    } catch (const Error& error) {
      throw Error({.kind = error.details().kind,
                   .path = views[number].image,
                   .reason = fmt::format("{}: {}", kind.name, error.details().reason),
                   .remedy = error.details().remedy});
    }
  }
  return {show.report(), show.items()};
}

}  // namespace

void DemonstrationOptions::Validate() const {
  views.Validate();
  RequireOption(poses_per_view >= 0 && poses_per_view <= kMaxPosesPerView,
                "DemonstrationOptions.poses_per_view",
                poses_per_view,
                fmt::format("from 0 to {}", kMaxPosesPerView));
  gripper.Validate();
  rules.Validate();
  sampler.Validate();
  demonstrator.Validate();
}

int NumPoses(const ObjectClass& kind, int view, const DemonstrationOptions& options) {
  const int all = NumPosesOfClass(kind, options);
  const int num_views = options.views.num_views;
  return all / num_views + (view < all % num_views ? 1 : 0);
}

MadeDemonstrations MakeDemonstrations(const fs::path& out, const DemonstrationOptions& options) {
  options.Validate();
  PrepareSetFolder(out, ToToml(options), kViewFolders);
  ViewSetOptions turntable = options.views;
  turntable.kind = ViewSetKind::kTurntable;
  MadeViews views = MakeViews(out, turntable);
  WriteList(views.set, views.written);

  const std::span<const ObjectClass> classes = ClassesOf(turntable.family);
  const auto num_views = static_cast<std::size_t>(turntable.num_views);
  std::vector<Shown> shown(classes.size());
  datasets::ParallelForReporting(classes.size(),
                                 turntable.num_threads,
                                 turntable.progress,
                                 "showing poses",
                                 [&](std::size_t i) {
                                   const auto own =
                                       std::span(views.set.items).subspan(i * num_views, num_views);
                                   shown[i] = ShowClass(classes[i], own, options);
                                 });
  MadeDemonstrations made{.set = {.root = out, .items = {}},
                          .reports = {},
                          .num_views = views.set.items.size(),
                          .written = views.written};
  for (Shown& one : shown) {
    made.reports.push_back(std::move(one.report));
    made.set.items.insert(made.set.items.end(), one.items.begin(), one.items.end());
  }
  WriteList(made.set, made.written);
  return made;
}

}  // namespace handcraft::synthetic
