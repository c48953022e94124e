// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/urdf.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lib/core/error.h"
#include "lib/structured_text/xml_element.h"

namespace handcraft::robot {
namespace {

// Three numbers between blanks.
Vector3 ReadVector(const XmlElement& element, const std::string& attribute) {
  const std::string text = element.Attribute(attribute);
  Vector3 vector{};
  const char* at = text.data();
  const char* const end = at + text.size();
  std::size_t count = 0;
  while (true) {
    while (at != end && std::string_view(" \t\n\r").find(*at) != std::string_view::npos) ++at;
    if (at == end) break;
    double value = 0.0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value) || count == vector.size()) {
      count = 0;
      break;
    }
    vector[count++] = value;
    at = stop;
  }
  if (count != vector.size()) {
    element.Fail(fmt::format("{} is '{}'; three numbers are due", attribute, text));
  }
  return vector;
}

// The child element of a name, if there is one.
const XmlElement* Find(const std::vector<XmlElement>& children, std::string_view name) {
  const auto found = std::find_if(
      children.begin(), children.end(), [&](const auto& child) { return child.Name() == name; });
  return found == children.end() ? nullptr : &*found;
}

const XmlElement& Need(const XmlElement& joint,
                       const std::vector<XmlElement>& children,
                       std::string_view name) {
  const XmlElement* const child = Find(children, name);
  if (child == nullptr) {
    joint.Fail(fmt::format("joint '{}' has no <{}>", joint.Attribute("name"), name));
  }
  return *child;
}

Pose ReadOrigin(const XmlElement& origin) {
  Pose pose;
  if (origin.Has("xyz")) pose.translation_m = ReadVector(origin, "xyz");
  if (origin.Has("rpy")) pose.rotation = RotationFromRollPitchYaw(ReadVector(origin, "rpy"));
  return pose;
}

UrdfJoint ReadJoint(const XmlElement& element) {
  const std::vector<XmlElement> children = element.Children();
  UrdfJoint joint{.name = element.Attribute("name"),
                  .type = element.Attribute("type"),
                  .parent = Need(element, children, "parent").Attribute("link"),
                  .child = Need(element, children, "child").Attribute("link")};
  if (const XmlElement* const origin = Find(children, "origin")) {
    joint.parent_from_joint = ReadOrigin(*origin);
  }
  if (const XmlElement* const axis = Find(children, "axis")) {
    const Vector3 vector = ReadVector(*axis, "xyz");
    const double length = Norm(vector);
    if (!(length > 1e-9)) axis->Fail("an axis of length 0", "give it a direction, \"0 0 1\"");
    joint.axis = Scale(vector, 1.0 / length);
  }
  if (const XmlElement* const limit = Find(children, "limit")) {
    joint.has_limits = limit->Has("lower") || limit->Has("upper");
    if (limit->Has("lower")) joint.lower = limit->Number("lower");
    if (limit->Has("upper")) joint.upper = limit->Number("upper");
    if (joint.has_limits && joint.lower > joint.upper && joint.type != "continuous") {
      limit->Fail(
          fmt::format(
              "the limits of joint '{}' are the wrong way round: lower {} is above upper {}",
              joint.name,
              joint.lower,
              joint.upper),
          "exchange them");
    }
  }
  joint.is_mimic = Find(children, "mimic") != nullptr;
  return joint;
}

// Throws Error at `element` unless the joint fits what was read before it.
void CheckJoint(const XmlElement& element, const UrdfJoint& joint, const Urdf& urdf) {
  const auto is_link = [&](const std::string& name) {
    return std::find(urdf.links.begin(), urdf.links.end(), name) != urdf.links.end();
  };
  for (const std::string& link : {joint.parent, joint.child}) {
    if (!is_link(link)) {
      element.Fail(
          fmt::format("joint '{}' names the link '{}', which is not there", joint.name, link));
    }
  }
  for (const UrdfJoint& other : urdf.joints) {
    if (other.name == joint.name) {
      element.Fail(fmt::format("a second joint '{}'", joint.name), "names must differ");
    }
    if (other.child == joint.child) {
      element.Fail(fmt::format(
          "link '{}' hangs on two joints, '{}' and '{}'", joint.child, other.name, joint.name));
    }
  }
}

[[noreturn]] void Refuse(const Urdf& urdf, std::string reason, std::string remedy = {}) {
  throw Error(
      {.path = urdf.path.string(), .reason = std::move(reason), .remedy = std::move(remedy)});
}

// The joints from base to tip, in this order.
std::vector<const UrdfJoint*> PathBetween(const Urdf& urdf,
                                          const std::string& base,
                                          const std::string& tip) {
  for (const auto& [what, link] : {std::pair{"base", &base}, std::pair{"tip", &tip}}) {
    if (std::find(urdf.links.begin(), urdf.links.end(), *link) == urdf.links.end()) {
      Refuse(urdf,
             fmt::format("the {} '{}' is no link of the robot '{}'", what, *link, urdf.robot),
             fmt::format("there are: {}", fmt::join(urdf.links, ", ")));
    }
  }
  std::vector<const UrdfJoint*> path;
  std::string link = tip;
  while (link != base) {
    const auto above = std::find_if(urdf.joints.begin(), urdf.joints.end(), [&](const auto& joint) {
      return joint.child == link;
    });
    if (above == urdf.joints.end() || path.size() > urdf.joints.size()) {
      Refuse(urdf,
             fmt::format("the tip '{}' does not hang on the base '{}'", tip, base),
             "name a link between the root and the tip as base");
    }
    path.push_back(&*above);
    link = above->parent;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

// The joint as one of a chain; throws for a type or limits that it cannot have.
Joint MovingJoint(const Urdf& urdf, const UrdfJoint& joint, const Pose& parent_from_joint) {
  const bool is_continuous = joint.type == "continuous";
  if (joint.is_mimic) {
    Refuse(urdf, fmt::format("joint '{}' follows another joint (mimic)", joint.name), "lock it");
  }
  if (!is_continuous && joint.type != "revolute" && joint.type != "prismatic") {
    Refuse(urdf,
           fmt::format("joint '{}' is of type '{}'; a chain takes revolute, continuous, prismatic "
                       "and fixed joints",
                       joint.name,
                       joint.type));
  }
  if (!is_continuous && !(joint.has_limits && joint.lower < joint.upper)) {
    Refuse(urdf,
           fmt::format("joint '{}' has no room between its limits, {} and {}",
                       joint.name,
                       joint.lower,
                       joint.upper),
           "give it limits, or lock it");
  }
  return {.name = joint.name,
          .type = joint.type == "prismatic" ? JointType::kPrismatic : JointType::kRevolute,
          .parent_from_joint = parent_from_joint,
          .axis = joint.axis,
          .lower = is_continuous ? -std::numbers::pi : joint.lower,
          .upper = is_continuous ? std::numbers::pi : joint.upper};
}

Pose LockedMotion(const UrdfJoint& joint, double value) {
  if (joint.type == "prismatic") return {kIdentity3, Scale(joint.axis, value)};
  return {AxisRotation(joint.axis, value), {}};
}

}  // namespace

Urdf ReadUrdf(const std::filesystem::path& path) {
  const XmlElement root = XmlElement::ReadFile(path);
  if (root.Name() != "robot") root.Fail("this is no URDF", "its outermost element is <robot>");
  Urdf urdf{.path = path, .robot = root.Attribute("name")};
  std::set<std::string> links;
  for (const XmlElement& element : root.Children("link")) {
    const std::string name = element.Attribute("name");
    if (!links.insert(name).second)
      element.Fail("a second link '" + name + "'", "names must differ");
    urdf.links.push_back(name);
  }
  for (const XmlElement& element : root.Children("joint")) {
    UrdfJoint joint = ReadJoint(element);
    CheckJoint(element, joint, urdf);
    urdf.joints.push_back(std::move(joint));
  }
  return urdf;
}

SerialChain ChainBetween(const Urdf& urdf,
                         const std::string& base,
                         const std::string& tip,
                         const std::map<std::string, double>& locked) {
  SerialChain chain{.base = base, .tip = tip};
  Pose last_from_here;
  std::set<std::string> found;
  for (const UrdfJoint* const joint : PathBetween(urdf, base, tip)) {
    last_from_here = last_from_here * joint->parent_from_joint;
    if (const auto lock = locked.find(joint->name); lock != locked.end()) {
      last_from_here = last_from_here * LockedMotion(*joint, lock->second);
      found.insert(joint->name);
    } else if (joint->type != "fixed") {
      chain.joints.push_back(MovingJoint(urdf, *joint, last_from_here));
      last_from_here = {};
    }
  }
  chain.last_from_tip = last_from_here;
  for (const auto& [name, value] : locked) {
    if (!found.contains(name)) {
      Refuse(urdf,
             fmt::format("the locked joint '{}' is not between '{}' and '{}'", name, base, tip),
             fmt::format("there are: {}", chain.JointNames()));
    }
  }
  if (chain.joints.empty() || chain.size() > kMaxJoints) {
    Refuse(urdf,
           fmt::format("{} joints move '{}' against '{}'; from 1 to {} are taken",
                       chain.size(),
                       tip,
                       base,
                       kMaxJoints));
  }
  return chain;
}

}  // namespace handcraft::robot
