// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <Eigen/Geometry>

#include "datasets/formats/csv_rows.h"

namespace handcraft::datasets {

/// Where an end-effector is: frame_from_end_effector, as our CSV files keep it.
struct EndEffectorPose {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< unit within kUnitTolerance

  /// As a rigid motion, the quaternion normalised.
  [[nodiscard]] Eigen::Isometry3d ToIsometry() const;

  /// The pose with coordinates rounded to micrometres and quaternion parts to millionths, real
  /// part not negative: what a file needs to hold of a pose that a hand was moved to.
  [[nodiscard]] static EndEffectorPose Rounded(const Eigen::Isometry3d& frame_from_end_effector);
};

/// The columns of a pose: position [m], then the quaternion in the order of ROS messages.
inline constexpr std::array<std::string_view, 7> kPoseColumns = {
    "x_m", "y_m", "z_m", "qx", "qy", "qz", "qw"};

/// The columns that say what a pose is of: the end-effector, in the frame.
inline constexpr std::array<std::string_view, 2> kFrameColumns = {"frame", "end_effector"};

/// The frame of a view set's clouds, and the point between a hand's fingertips with z the approach
/// axis and x the closing axis: the only ones that our files hold.
inline constexpr std::string_view kBaseFrame = "base";
inline constexpr std::string_view kGraspCentre = "grasp_centre";

/// How far from 1 the length of a quaternion may be.
inline constexpr double kUnitTolerance = 1e-3;

/// Greatest coordinate that is taken for metres.
inline constexpr double kFarthestM = 100.0;

/// The pose in the seven columns from `first` on. Throws Error with line and column for what is not
/// a finite number, a position farther than kFarthestM along an axis (millimetres?), a quaternion
/// whose length is not 1.
[[nodiscard]] EndEffectorPose ReadPose(const CsvRows& rows, std::size_t first);

/// Throws Error with the line when the two columns from `first` on name another frame or
/// end-effector.
void CheckFrames(const CsvRows& rows, std::size_t first);

/// The two fields that CheckFrames takes. No comma before or after.
[[nodiscard]] std::string FrameFields();

/// The seven fields, each the shortest text that reads back as the same number. No comma before or
/// after.
[[nodiscard]] std::string PoseFields(const EndEffectorPose& pose);

}  // namespace handcraft::datasets
