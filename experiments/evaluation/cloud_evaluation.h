// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/formats/view_set.h"
#include "datasets/object_clouds.h"
#include "experiments/metrics/binary_metrics.h"
#include "lib/core/progress.h"
#include "lib/runtime/handcraft_runtime.h"
#include "trainers/svm/rejection.h"

namespace handcraft::experiments {

/// How a model of object classes wants its clouds, from the file.
[[nodiscard]] datasets::ObjectCloudOptions ReadCloudOptions(const std::filesystem::path& model);

/// The margin below which a model of classes says that it is none of them; −∞ for a model that
/// rejects nothing, for other kinds and for null.
[[nodiscard]] double RejectionThreshold(const hc_model* model) noexcept;

/// What the runtime says about an object's cloud.
struct CloudClass {
  bool has_points = false;  ///< else nothing below is set: too few were measured
  std::size_t number = 0;
  bool is_rejected = false;  ///< none of the classes; `number` is the nearest one
  double margin = 0.0;
  std::vector<double> decision_values = {};  ///< one a machine
};

/// Classifies clouds with a model of kind object_class (hc_classify_cloud), one at a time. Throws
/// Error(kUsage) for a model of another kind.
class CloudClassifier {
 public:
  /// `model` outlives this object.
  explicit CloudClassifier(const hc_model* model);

  [[nodiscard]] CloudClass Classify(const datasets::MaskedCloud& object);

 private:
  struct FreeWorkspace {
    void operator()(hc_workspace* workspace) const noexcept { hc_workspace_free(workspace); }
  };

  const hc_model* model_;
  std::unique_ptr<hc_workspace, FreeWorkspace> workspace_;
};

/// What is right when an object is none of the model's classes, and what such an answer is called.
inline constexpr std::string_view kNoneOfThese = "none of these";

/// Which of the model's classes is right for a class that it does not know: "other mug" is a mug,
/// a box is kNoneOfThese. Several may be.
using CountsAs = std::multimap<std::string, std::string>;

/// What was said of one view.
struct CloudAnswer {
  std::size_t truth = 0;   ///< of CloudEvaluation.truths
  std::size_t answer = 0;  ///< of CloudEvaluation.classes, or their number for kNoneOfThese
  double margin = 0.0;     ///< of a view of which enough was measured
  bool has_points = false;
  bool is_right = false;
};

struct CloudEvaluation {
  std::size_t num_views = 0;
  std::vector<std::string> truths = {};   ///< classes of the set, in the order of the views
  std::vector<std::string> classes = {};  ///< of the model
  /// A row a truth; a column a class, and a last one for kNoneOfThese.
  std::vector<std::vector<std::size_t>> confusion = {};
  std::vector<CloudAnswer> answers = {};  ///< one a view
  std::size_t num_correct = 0;
  std::size_t num_rejected = 0;  ///< with those of which too little was measured
  /// The model's threshold (−∞: none) and what was rejected of the known views and of the novel
  /// ones, for which nothing but kNoneOfThese is right.
  svm::Rejection rejection = {};
  Estimate accuracy = {};  ///< Wilson over views
};

/// Classifies every view. Throws Error(kBadInput) naming a class of the set, or of `counts_as`,
/// that the model does not know, and as datasets::ReadObjectCloud does.
[[nodiscard]] CloudEvaluation EvaluateClouds(const hc_model* model,
                                             const datasets::ViewSet& set,
                                             const datasets::ObjectCloudOptions& options,
                                             const CountsAs& counts_as = {},
                                             const Progress& progress = {});

/// JSON text with stable keys ("accuracy", "confusion", …); two runs give the same bytes.
[[nodiscard]] std::string ToJson(const CloudEvaluation& evaluation);

}  // namespace handcraft::experiments
