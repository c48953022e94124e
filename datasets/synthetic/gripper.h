// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>

#include "datasets/synthetic/oriented_box.h"

namespace handcraft::synthetic {

/// A three-fingered hand made of boxes, with the measures of a BarrettHand whose spread joint
/// stands so that two fingers face the third, the thumb.
///
/// Its frame is the grasp centre: the point between the fingertips, z the approach axis (from the
/// palm outwards), x the closing axis. The two fingers lie on the side of +x, at y = ±finger_apart,
/// the thumb on the side of −x, at y = 0. The hand comes open as far as it goes; each finger closes
/// along x by itself until it touches. A finger is two boxes: its last link, which comes to the
/// contact, and the link between that and the palm, which stands off, because its joint does. How
/// the links turn while they close is left out.
///
/// Source: bounding boxes and joint places of the public model of the BH8 hand (bhand_model.URDF,
/// Johns Hopkins University, BSD); the opening is the one at which the links still curl inwards.
struct Gripper {
  float max_opening_m = 0.12F;       ///< between fingers and thumb, at the grasp centre
  float least_clearance_m = 0.005F;  ///< on either side of what it closes on
  float pad_slack_m = 0.005F;        ///< within which a finger's inside yields and still holds
  float finger_reach_m = 0.085F;     ///< from the palm to the grasp centre
  float tip_m = 0.015F;              ///< of the fingers beyond the grasp centre
  float last_link_m = 0.045F;        ///< its length
  float finger_width_m = 0.023F;
  float finger_thickness_m = 0.0225F;
  float finger_apart_m = 0.025F;  ///< of each of the two fingers from the middle
  float knuckle_m = 0.0375F;      ///< from the middle to the inside of an upright finger's root
  float stand_off_m = 0.008F;     ///< of a finger's root behind its contact, at least
  Eigen::Vector3f palm_m = {0.130F, 0.089F, 0.090F};   ///< along x, y, z
  Eigen::Vector3f wrist_m = {0.100F, 0.100F, 0.110F};  ///< behind the palm: the arm's last links
  float wrist_to_palm_m = 0.150F;  ///< from where the wrist's axes meet to the palm's face

  /// Widest thing it can close on.
  [[nodiscard]] float WidestM() const { return max_opening_m - 2.0F * least_clearance_m; }
  /// From the centre of the wrist, where its three axes meet, to the grasp centre.
  [[nodiscard]] float WristToGraspM() const { return wrist_to_palm_m + finger_reach_m; }

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Where fingers and thumb touch: the places on the closing axis, thumb < fingers.
struct ContactPlaces {
  float thumb_m = 0.0F;
  float fingers_m = 0.0F;

  [[nodiscard]] float WidthM() const { return fingers_m - thumb_m; }
};

inline constexpr std::size_t kNumGripperBoxes = 8;
using GripperBoxes = std::array<OrientedBox, kNumGripperBoxes>;

/// All that the hand passes through while it closes from its full opening to the contacts, but for
/// the last `pad_slack_m`: palm, wrist, and two boxes a finger. Their union is connected; so where
/// it meets no surface of closed objects, all of it is outside them when one point of it is.
[[nodiscard]] GripperBoxes SweptBoxes(const Gripper& gripper,
                                      const ContactPlaces& contacts,
                                      const Eigen::Isometry3f& frame_from_grasp);

/// The hand alone, closed on the contacts.
[[nodiscard]] GripperBoxes ClosedBoxes(const Gripper& gripper,
                                       const ContactPlaces& contacts,
                                       const Eigen::Isometry3f& frame_from_grasp);

/// Whether any box of one hand overlaps any of the other.
[[nodiscard]] bool Collide(const GripperBoxes& a, const GripperBoxes& b);

}  // namespace handcraft::synthetic
