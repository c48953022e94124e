// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/omissions.h"

#include <algorithm>
#include <utility>

namespace handcraft::datasets {

namespace fs = std::filesystem;

void Omissions::LeaveOut(const fs::path& path, const std::string& why) {
  Add(path, "left out", why);
}

void Omissions::GoWithout(const fs::path& path, const std::string& part, const std::string& why) {
  Add(path, "imported without " + part, why);
}

void Omissions::GoWithoutWhatOthersHave(const std::vector<fs::path>& lacking,
                                        std::size_t num_pictures,
                                        const std::string& part,
                                        const std::string& why) {
  if (lacking.size() == num_pictures) return;
  for (const fs::path& path : lacking) GoWithout(path, part, why);
}

void Omissions::Add(const fs::path& path, const std::string& what, const std::string& why) {
  const auto known = std::find_if(groups_.begin(), groups_.end(), [&](const Group& group) {
    return group.what == what && group.why == why;
  });
  if (known != groups_.end()) {
    ++known->count;
  } else {
    groups_.push_back({.what = what, .why = why, .first = path, .count = 1});
  }
}

std::vector<Fault> Omissions::Notes() const {
  std::vector<Fault> notes;
  notes.reserve(groups_.size());
  for (const Group& group : groups_) {
    std::string reason = group.what;
    if (group.count > 1) reason += ", the first of " + std::to_string(group.count);
    reason += ": " + group.why;
    notes.push_back(
        {.path = group.first.string(), .reason = std::move(reason), .gravity = Gravity::kNote});
  }
  return notes;
}

void Omissions::Conclude(SourceSet& source, Error::Details refusal) const {
  source.notes = Notes();
  if (!source.pictures.empty()) return;
  for (const Fault& note : source.notes) refusal.reason += "; " + note.path + ": " + note.reason;
  throw Error(std::move(refusal));
}

}  // namespace handcraft::datasets
