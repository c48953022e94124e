// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/object_classes/novel_views.h"

#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "datasets/object_clouds.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"

namespace handcraft::experiments {
namespace {

// By its bytes, wherever it lies; empty: the view has none.
std::string CloudDigest(const datasets::ViewSet& set, const datasets::ObjectView& view) {
  return view.cloud.empty() ? "" : Sha256Hex(ReadFile(set.root / view.cloud));
}

[[noreturn]] void RefuseKnown(const datasets::ViewSet& novel,
                              const datasets::ObjectView& view,
                              const std::string& reason) {
  throw Error({.path = (novel.root / view.image).string(),
               .reason = "this view is not novel: " + reason,
               .remedy = "give views of objects that are none of the classes and that no view to "
                         "train on shows"});
}

}  // namespace

void RequireNovel(const datasets::ViewSet& novel,
                  const datasets::ViewSet& known,
                  const std::vector<std::string>& classes) {
  const std::set<std::string> to_tell(classes.begin(), classes.end());
  std::set<std::string> instances;
  std::set<std::string> clouds;
  for (const datasets::ObjectView& view : known.items) {
    if (!to_tell.contains(view.object_class)) continue;
    instances.insert(view.instance);
    if (std::string digest = CloudDigest(known, view); !digest.empty()) {
      clouds.insert(std::move(digest));
    }
  }
  for (const datasets::ObjectView& view : novel.items) {
    if (to_tell.contains(view.object_class)) {
      RefuseKnown(novel, view, "its class '" + view.object_class + "' is one to tell");
    }
    if (instances.contains(view.instance)) {
      RefuseKnown(novel, view, "the instance '" + view.instance + "' is trained on");
    }
    if (clouds.contains(CloudDigest(novel, view))) {
      RefuseKnown(novel, view, "its cloud is trained on");
    }
  }
}

svm::Calibration RejectNovelViews(const datasets::ViewSet& novel,
                                  double max_false_rejection,
                                  int num_threads,
                                  ObjectClassTraining& training) {
  if (training.margins.empty()) {
    throw Error({.kind = Error::Kind::kUsage,
                 .path = novel.root.string(),
                 .reason = "novel views are told from known ones that were held out, and there are "
                           "none",
                 .remedy = "give --folds 2 or more, and with --add-class views of every class"});
  }
  const model_io::ObjectClassModel& model = training.model;
  const datasets::CloudFeatures features =
      datasets::DescribeViews(novel,
                              model.descriptor,
                              {.frame = model.descriptor.frame, .outlier_step = model.outlier_step},
                              num_threads,
                              training.svm.progress);
  return svm::RejectNovel(
      training.margins, features.Matrix(), max_false_rejection, num_threads, training.model.svm);
}

}  // namespace handcraft::experiments
