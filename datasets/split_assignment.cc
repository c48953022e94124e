// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/split_assignment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/core/rng.h"

namespace handcraft::datasets {
namespace {

// The pictures that stay together.
using Group = std::vector<std::size_t>;

template <class Item>
const std::string& GroupNameOf(const Item& item, SplitGroup group) {
  switch (group) {
    case SplitGroup::kInstance:
      return item.instance;
    case SplitGroup::kClass:
      return item.object_class;
    case SplitGroup::kPicture:
      break;
  }
  return item.image;
}

std::string_view GroupsText(SplitGroup group) {
  switch (group) {
    case SplitGroup::kInstance:
      return "instances";
    case SplitGroup::kClass:
      return "classes";
    case SplitGroup::kPicture:
      break;
  }
  return "pictures";
}

// The groups in the order in which they are given away.
template <class Set>
std::vector<Group> OrderGroups(const Set& set, const SplitOptions& options) {
  std::vector<std::size_t> by_name(set.items.size());
  std::iota(by_name.begin(), by_name.end(), std::size_t{0});
  std::sort(by_name.begin(), by_name.end(), [&](std::size_t a, std::size_t b) {
    return set.items[a].image < set.items[b].image;
  });
  std::map<std::string, Group> groups;
  for (const std::size_t i : by_name) {
    groups[GroupNameOf(set.items[i], options.group)].push_back(i);
  }
  std::map<std::string, std::vector<Group>> by_class;
  for (auto& [name, group] : groups) {
    const std::string& object_class = set.items[group.front()].object_class;
    by_class[options.group == SplitGroup::kClass ? "" : object_class].push_back(std::move(group));
  }
  std::vector<Group> ordered;
  for (auto& [name, of_class] : by_class) {
    Rng rng = Rng::Stream(options.seed, "split of " + name);
    rng.Shuffle(std::span(of_class));
    std::move(of_class.begin(), of_class.end(), std::back_inserter(ordered));
  }
  return ordered;
}

template <class Set>
void Divide(Set& set, const SplitOptions& options) {
  options.Validate();
  const std::size_t num_splits = options.shares.size();
  std::vector<double> given(num_splits, 0.0);
  double walked = 0.0;
  for (const Group& group : OrderGroups(set, options)) {
    const auto size = static_cast<double>(group.size());
    walked += size;
    std::size_t chosen = 0;
    for (std::size_t s = 1; s < num_splits; ++s) {
      const auto behind = [&](std::size_t i) {
        return options.shares[i].share * walked - given[i];
      };
      if (behind(s) > behind(chosen)) chosen = s;
    }
    given[chosen] += size;
    for (const std::size_t i : group) set.items[i].split = options.shares[chosen].name;
  }
  for (std::size_t s = 0; s < num_splits; ++s) {
    if (given[s] > 0.0) continue;
    throw Error({.path = set.root.string(),
                 .reason = fmt::format("too few {} for a share of {}: split '{}' would be empty",
                                       GroupsText(options.group),
                                       options.shares[s].share,
                                       options.shares[s].name),
                 .remedy = "name fewer splits, or give this one a greater share"});
  }
}

}  // namespace

void SplitOptions::Validate() const {
  RequireOption(!shares.empty(), "SplitOptions.shares", shares.size(), "1 or more splits");
  std::set<std::string> names;
  double sum = 0.0;
  for (const auto& [name, share] : shares) {
    if (name.empty() || !names.insert(name).second) {
      throw Error({.kind = Error::Kind::kUsage,
                   .reason = name.empty() ? "a split without a name"
                                          : "the split '" + name + "' is named twice"});
    }
    RequireOption(share > 0.0 && share <= 1.0, "the share of '" + name + "'", share, "in (0, 1]");
    sum += share;
  }
  RequireOption(std::abs(sum - 1.0) <= 1e-6, "the sum of all shares", sum, "1");
}

void AssignSplits(LabelledImageSet& set, const SplitOptions& options) { Divide(set, options); }

void AssignSplits(ViewSet& set, const SplitOptions& options) { Divide(set, options); }

}  // namespace handcraft::datasets
