// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// The functions of handcraft_runtime.h that say how to hold an object.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

#include "lib/runtime/cloud_view.h"
#include "lib/runtime/grasp_library_model.h"
#include "lib/runtime/handcraft_runtime.h"
#include "lib/runtime/model_handle.h"

namespace {

using handcraft::features::kMaxCoordinate_m;
using handcraft::runtime::GraspLibraryModel;

bool IsPlace(const double* point_m) noexcept {
  return std::all_of(
      point_m, point_m + 3, [](double x) { return std::fabs(x) <= kMaxCoordinate_m; });  // no NaN
}

bool IsRequest(const GraspLibraryModel& model, const hc_grasp_request& request) noexcept {
  return request.class_number >= 0 &&
         static_cast<std::size_t>(request.class_number) < model.class_names.size() &&
         request.num_neighbours >= 1 &&
         request.num_neighbours <=
             static_cast<std::int32_t>(handcraft::features::kMaxGraspNeighbours) &&
         IsPlace(request.point_m);
}

hc_grasp ToGrasp(const GraspLibraryModel::Answer& answer) noexcept {
  const handcraft::features::FoundGrasp& found = answer.grasp;
  hc_grasp grasp{.position_m = {},
                 .quaternion_xyzw = {},
                 .object_angle_rad = found.object_angle_rad,
                 .turn_rad = found.turn_rad,
                 .distance_m = found.distance_m,
                 .view = static_cast<int32_t>(found.view),
                 .demonstration = found.number,
                 .rejected = answer.is_rejected ? 1 : 0};
  std::copy(found.position_m.begin(), found.position_m.end(), grasp.position_m);
  std::copy(found.rotation.begin(), found.rotation.end(), grasp.quaternion_xyzw);
  return grasp;
}

}  // namespace

hc_status hc_find_grasp(const hc_model* model,
                        hc_workspace* workspace,
                        const hc_cloud* cloud,
                        const hc_grasp_request* request,
                        hc_grasp* grasp) {
  if (model == nullptr || workspace == nullptr || cloud == nullptr || request == nullptr ||
      grasp == nullptr) {
    return HC_ERROR_ARGUMENT;
  }
  const auto* library = std::get_if<GraspLibraryModel>(&model->predictor);
  if (library == nullptr) return HC_ERROR_KIND;
  if (cloud->mask == nullptr || !handcraft::runtime::IsCloud(*cloud) ||
      !IsRequest(*library, *request))
    return HC_ERROR_ARGUMENT;
  const std::span<std::byte> bytes = workspace->buffer.Bytes();
  const std::span<float> scratch(reinterpret_cast<float*>(bytes.data()),
                                 bytes.size() / sizeof(float));
  if (cloud->width > workspace->max_width || cloud->height > workspace->max_height ||
      handcraft::features::ObjectPlaneScratch(cloud->width, cloud->height) > scratch.size()) {
    return HC_ERROR_ARGUMENT;
  }
  const GraspLibraryModel::Answer answer =
      library->Find(static_cast<std::size_t>(request->class_number),
                    handcraft::runtime::ViewOf(*cloud),
                    {.point_m = {request->point_m[0], request->point_m[1], request->point_m[2]},
                     .num_neighbours = static_cast<std::size_t>(request->num_neighbours)},
                    scratch);
  if (answer.fault != handcraft::features::CloudFault::kNone) return HC_ERROR_CLOUD;
  *grasp = ToGrasp(answer);
  return HC_OK;
}
