// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "datasets/formats/organised_cloud.h"
#include "datasets/formats/view_set.h"
#include "lib/core/design_matrix.h"
#include "lib/core/image.h"
#include "lib/core/progress.h"
#include "lib/features/cloud_descriptor.h"
#include "lib/perception/table_removal.h"

namespace handcraft::datasets {

/// How an object's points are taken out of a cloud.
struct ObjectCloudOptions {
  features::CloudFrame frame = features::CloudFrame::kBase;  ///< they are given in
  /// Step of the outlier fences, in interquartile ranges (perception::CloudOutlierOptions); 0: all
  /// points are kept.
  double outlier_step = 1.5;

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("frame", features::NameOf(frame));
    visit("outlier_step", outlier_step);
  }
};

/// A cloud, and which of its pixels are the object's (255, the others 0).
struct MaskedCloud {
  OrganisedCloud cloud;
  Image mask;

  /// As descriptors take it; this object must outlive the view.
  [[nodiscard]] features::ObjectCloud View() const noexcept;
};

/// The smallest box of a cloud that holds all pixels of a mask of its size (not 0), with the mask
/// there: as good as the whole to descriptors, and less to go through. Empty with an empty mask.
[[nodiscard]] MaskedCloud CropToMask(const OrganisedCloud& cloud, const Image& mask);

/// The object of a view: the points under its object mask without outliers (dissertation, section
/// 3.2.2), in the wanted frame. Throws Error when a file cannot be read, the mask is of another
/// size, or the view has no cloud.
[[nodiscard]] MaskedCloud ReadObjectCloud(const ViewSet& set,
                                          std::size_t index,
                                          const ObjectCloudOptions& options = {});

/// The object of a cloud in the base frame under a mask of its size, without outliers, in the
/// wanted frame.
[[nodiscard]] MaskedCloud TakeObjectCloud(OrganisedCloud cloud,
                                          Image mask,
                                          const ObjectCloudOptions& options = {});

/// The object of a cloud without a mask: its points off the table, without outliers, in the wanted
/// frame; `table.up` is in the cloud's own. The mask is 0 everywhere when nothing is left.
[[nodiscard]] MaskedCloud FindObjectCloud(OrganisedCloud cloud,
                                          const perception::TableRemovalOptions& table,
                                          const ObjectCloudOptions& options = {});

/// Takes the points of a cloud in the base frame into this one.
void ChangeFrame(features::CloudFrame frame, OrganisedCloud& cloud);

/// The descriptor's numbers of an object. Throws Error(kBadInput) when fewer than
/// features::kMinObjectPoints of its points were measured.
void DescribeObject(const MaskedCloud& object,
                    const features::CloudDescriptor& descriptor,
                    std::span<float> row);

/// Calls `work` and gives an Error of it the path of the view's cloud when it has none.
void NamingCloud(const ViewSet& set, std::size_t index, const std::function<void()>& work);

/// A feature vector a view, row after row.
struct CloudFeatures {
  std::vector<float> values;
  std::size_t num_views = 0;
  std::size_t num_features = 0;

  [[nodiscard]] DesignMatrix<float> Matrix() const noexcept {
    return {values.data(), num_views, num_features, num_features};
  }
};

/// Describes every view of a set with what the robot computes. The number of threads changes no
/// byte. Throws Error as ReadObjectCloud does, and naming the cloud of a view with fewer than
/// features::kMinObjectPoints measured points.
[[nodiscard]] CloudFeatures DescribeViews(const ViewSet& set,
                                          const features::CloudDescriptor& descriptor,
                                          const ObjectCloudOptions& options = {},
                                          int num_threads = 1,
                                          const Progress& progress = {});

}  // namespace handcraft::datasets
