// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/python_peer.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

TEST(PythonPeer, GetsItsArgumentsAndThreads) {
  const testing::TemporaryDirectory scratch;
  const auto json = RunPythonPeer(
      "import json, os, sys\n"
      "print(json.dumps({'words': sys.argv[1:], 'threads': os.environ['OMP_NUM_THREADS']}))\n",
      {"it's here", "b"},
      scratch.path(),
      2);
  ASSERT_TRUE(json.has_value());
  EXPECT_EQ((*json)["words"], (nlohmann::json{"it's here", "b"}));
  EXPECT_EQ((*json)["threads"], "2");
}

TEST(PythonPeer, IsNothingWhenItFailsOrPrintsNoJson) {
  const testing::TemporaryDirectory scratch;
  EXPECT_FALSE(RunPythonPeer("import no_such_module\n", {}, scratch.path(), 1).has_value());
  EXPECT_FALSE(RunPythonPeer("print('words')\n", {}, scratch.path(), 1).has_value());
}

}  // namespace
}  // namespace handcraft::experiments
