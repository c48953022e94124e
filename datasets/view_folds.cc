// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/view_folds.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>

#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::datasets {
namespace {

// The number of each view's instance among those of its class; the smallest number of instances.
struct Instances {
  std::vector<std::size_t> numbers;
  std::size_t fewest = 0;
};

Instances InstancesOf(const ViewSet& set) {
  std::map<std::string, std::vector<std::string>> by_class;
  Instances instances;
  for (const ObjectView& view : set.items) {
    std::vector<std::string>& known = by_class[view.object_class];
    const auto found = std::find(known.begin(), known.end(), view.instance);
    instances.numbers.push_back(static_cast<std::size_t>(found - known.begin()));
    if (found == known.end()) known.push_back(view.instance);
  }
  instances.fewest = set.items.size();
  for (const auto& entry : by_class) {
    instances.fewest = std::min(instances.fewest, entry.second.size());
  }
  return instances;
}

}  // namespace

ViewSet OnlySplit(const ViewSet& set, std::string_view split) {
  if (split.empty()) return set;
  ViewSet only{.root = set.root, .items = {}};
  std::set<std::string> others;
  for (const ObjectView& view : set.items) {
    if (view.split == split) only.items.push_back(view);
    others.insert(view.split);
  }
  if (!only.items.empty()) return only;
  std::string list;
  for (const std::string& other : others) {
    list += list.empty() ? "" : ", ";
    list += other;
  }
  throw Error({.path = set.root.string(),
               .reason = "no view is in the split '" + std::string(split) + "'; there are: " + list,
               .remedy = "give --split, '' for all views"});
}

ViewClasses ClassesOf(const ViewSet& set) {
  ViewClasses classes;
  for (const ObjectView& view : set.items) {
    const auto found = std::find(classes.names.begin(), classes.names.end(), view.object_class);
    classes.values.push_back(static_cast<std::uint32_t>(found - classes.names.begin()));
    if (found == classes.names.end()) classes.names.push_back(view.object_class);
  }
  return classes;
}

std::vector<std::uint32_t> GroupedFolds(const ViewSet& set, int num_folds) {
  RequireOption(num_folds >= 2, "the number of folds", num_folds, "at least 2");
  const auto count = static_cast<std::size_t>(num_folds);
  const Instances instances = InstancesOf(set);
  std::map<std::string, std::size_t> dealt;  // views of a class without an angle
  std::vector<std::uint32_t> folds;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    const ObjectView& view = set.items[i];
    std::size_t fold = 0;
    if (instances.fewest > 1) {
      fold = instances.numbers[i] % std::min(count, instances.fewest);
    } else if (view.angle_deg) {
      fold = static_cast<std::size_t>(*view.angle_deg / 360.0 * num_folds);
    } else {
      fold = dealt[view.object_class]++ % count;
    }
    folds.push_back(static_cast<std::uint32_t>(fold));
  }
  return folds;
}

}  // namespace handcraft::datasets
