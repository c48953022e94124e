// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/fault_search.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

namespace handcraft::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

// The least that a set needs to have.
struct Listed {
  std::string image;
  std::string split;
};
struct List {
  std::vector<Listed> items;
};

TEST(FindPictureFaults, JoinsFindingsInOrderAndNamesTwins) {
  const List list{{{"a", "train"}, {"b", "train"}, {"c", "test"}, {"d", "train"}, {"e", "train"}}};
  const auto examine = [](std::size_t i) {
    PictureFindings findings{.faults = {}, .image_digest = i == 1 ? "other" : "same"};
    if (i == 2) findings.faults.push_back({"c_mask", "gray"});
    if (i == 3) findings = {.faults = {{"d", "gone"}}, .image_digest = ""};
    return findings;
  };
  for (const int num_threads : {1, 3}) {
    std::vector<std::pair<std::string, std::string>> found;
    for (const Fault& fault : FindPictureFaults(list, num_threads, {}, examine))
      found.emplace_back(fault.path, fault.reason);
    EXPECT_THAT(found,
                ElementsAre(Pair("c_mask", "gray"),
                            Pair("c", "the same picture as a, which is in another split"),
                            Pair("d", "gone"),
                            Pair("e", "the same picture as a")));
  }
}

TEST(FindPictureFaults, FindsNothingInNothing) {
  EXPECT_THAT(FindPictureFaults(List{}, 2, {}, [](std::size_t) { return PictureFindings{}; }),
              IsEmpty());
}

}  // namespace
}  // namespace handcraft::datasets
