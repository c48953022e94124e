// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/closed_form_solver.h"
#include "lib/robot/inverse_kinematics.h"
#include "lib/robot/kdl_solver.h"

namespace handcraft::robot {

std::unique_ptr<InverseKinematics> MakeInverseKinematics(const SerialChain& chain,
                                                         const InverseKinematicsOptions& options) {
  if (FindSphericalArm(chain).arm) return std::make_unique<ClosedFormSolver>(chain, options);
  return std::make_unique<KdlSolver>(chain, options);
}

}  // namespace handcraft::robot
