// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Descriptions of robots from anywhere: a reader makes a robot whose joints join its links, and a
// chain of joints between two of them, or throws handcraft::Error, and does nothing else.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lib/core/error.h"
#include "lib/robot/spherical_arm.h"
#include "lib/robot/urdf.h"
#include "tests/fuzz/fuzzed_file.h"

namespace handcraft::robot {
namespace {

using testing::FuzzedFile;
using testing::Require;

void RequireWhole(const Urdf& urdf) {
  const auto is_link = [&](const std::string& name) {
    return std::find(urdf.links.begin(), urdf.links.end(), name) != urdf.links.end();
  };
  for (const UrdfJoint& joint : urdf.joints) {
    Require(is_link(joint.parent) && is_link(joint.child));
    Require(joint.type == "continuous" || joint.lower <= joint.upper);
  }
}

void ReadRobot(std::string_view bytes) {
  static const FuzzedFile kFile;
  kFile.Fill(bytes);
  const Urdf urdf = ReadUrdf(kFile.path());
  RequireWhole(urdf);
  if (urdf.links.empty()) return;
  const SerialChain chain = ChainBetween(urdf, urdf.links.front(), urdf.links.back());
  Require(!chain.joints.empty() && chain.size() <= kMaxJoints);
  for (const Joint& joint : chain.joints) Require(joint.lower < joint.upper);
  const SphericalArmSearch search = FindSphericalArm(chain);
  Require(search.arm.has_value() == search.reason.empty());
}

}  // namespace
}  // namespace handcraft::robot

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    handcraft::robot::ReadRobot({reinterpret_cast<const char*>(data), size});
  } catch (const handcraft::Error& error) {
    handcraft::testing::Require(error.what()[0] != '\0');
  }
  return 0;
}
