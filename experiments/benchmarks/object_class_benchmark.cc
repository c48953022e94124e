// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/object_class_benchmark.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/core/version.hpp>
#include <opencv2/ml.hpp>

#include "datasets/object_clouds.h"
#include "experiments/evaluation/loaded_model.h"
#include "lib/core/check.h"
#include "lib/core/rng.h"
#include "lib/features/cloud_descriptor.h"
#include "lib/model_io/object_class_models.h"
#include "trainers/svm/cross_validation.h"
#include "trainers/svm/gram_matrix.h"
#include "trainers/svm/svm.h"

namespace handcraft::experiments {
namespace {

constexpr int kWidth_px = 640;
constexpr int kHeight_px = 480;

struct ClassOfShape {
  double bend;   // of the surface across [1 / m]
  double slope;  // along
};

// The cloud of a view of a class in the middle of a picture; 5 % of the object is not measured.
datasets::MaskedCloud DrawObject(int number, int view, const ObjectClassBenchmarkSize& size) {
  Rng rng =
      Rng::Stream(1, "object class benchmark", static_cast<std::uint64_t>(number * 10000 + view));
  const ClassOfShape shape{.bend = 4.0 * number, .slope = 0.3 * (number % 3)};
  const double turn = 2.0 * rng.Uniform() - 1.0;
  datasets::MaskedCloud object{.cloud = {.width = kWidth_px, .height = kHeight_px},
                               .mask = Image(kWidth_px, kHeight_px)};
  object.cloud.points.assign(std::size_t{kWidth_px} * kHeight_px,
                             Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  const int half = size.object_px / 2;
  constexpr int kMiddleU = kWidth_px / 2;
  constexpr int kMiddleV = kHeight_px / 2;
  for (int v = kMiddleV - half; v < kMiddleV + half; ++v) {
    for (int u = kMiddleU - half; u < kMiddleU + half; ++u) {
      const double y = 0.12 * (u - kMiddleU) / size.object_px;
      const double z = -0.12 * (v - kMiddleV) / size.object_px;
      const double depth =
          0.6 + shape.bend * y * y + shape.slope * z + 0.3 * turn * y + 0.004 * rng.Normal();
      object.mask.At(u, v) = 255;
      if (rng.UniformInt(20) == 0) continue;
      object.cloud.points[static_cast<std::size_t>(v) * kWidth_px + static_cast<std::size_t>(u)] = {
          static_cast<float>(depth), static_cast<float>(y), static_cast<float>(z)};
    }
  }
  return object;
}

struct Drawn {
  features::CloudDescriptor descriptor = {};
  std::vector<float> values = {};
  std::vector<std::uint32_t> classes = {};
  svm::Options svm = {};

  [[nodiscard]] DesignMatrix<float> Matrix() const {
    const std::size_t p = descriptor.NumFeatures();
    return {values.data(), classes.size(), p, p};
  }
};

Drawn Draw(const ObjectClassBenchmarkSize& size) {
  Drawn drawn{.descriptor = {.grid_size = size.grid_size}};
  const std::size_t p = drawn.descriptor.NumFeatures();
  std::vector<std::byte> workspace(drawn.descriptor.WorkspaceBytes());
  for (int c = 0; c < size.num_classes; ++c) {
    for (int view = 0; view < size.views_per_class; ++view) {
      const datasets::MaskedCloud object = DrawObject(c, view, size);
      drawn.values.resize(drawn.values.size() + p);
      const bool done =
          drawn.descriptor.Compute(object.View(), workspace, std::span(drawn.values).last(p));
      HC_CHECK(done);
      drawn.classes.push_back(static_cast<std::uint32_t>(c));
    }
  }
  double squares = 0.0;
  for (const float value : drawn.values) {
    squares += static_cast<double>(value) * static_cast<double>(value);
  }
  drawn.svm.degree = 3;
  drawn.svm.coef0 = 1.0;
  drawn.svm.gamma = static_cast<double>(drawn.classes.size()) / squares;
  drawn.svm.penalty = 10.0;
  return drawn;
}

cv::Mat MatOf(const Drawn& drawn) {
  return {static_cast<int>(drawn.classes.size()),
          static_cast<int>(drawn.descriptor.NumFeatures()),
          CV_32F,
          const_cast<float*>(drawn.values.data())};
}

// OpenCV's machine trained on all rows but one (-1: on all).
cv::Ptr<cv::ml::SVM> TrainPeer(const Drawn& drawn, int left_out) {
  const cv::Ptr<cv::ml::SVM> peer = cv::ml::SVM::create();
  peer->setType(cv::ml::SVM::C_SVC);
  peer->setKernel(cv::ml::SVM::POLY);
  peer->setDegree(drawn.svm.degree);
  peer->setGamma(drawn.svm.gamma);
  peer->setCoef0(drawn.svm.coef0);
  peer->setC(drawn.svm.penalty);
  peer->setTermCriteria(
      {cv::TermCriteria::EPS + cv::TermCriteria::MAX_ITER, 10000000, drawn.svm.smo.tolerance});
  const cv::Mat all = MatOf(drawn);
  cv::Mat rows(0, all.cols, CV_32F);
  std::vector<int> labels;
  for (int row = 0; row < all.rows; ++row) {
    if (row == left_out) continue;
    rows.push_back(all.row(row));
    labels.push_back(static_cast<int>(drawn.classes[static_cast<std::size_t>(row)]));
  }
  peer->train(rows, cv::ml::ROW_SAMPLE, labels);
  return peer;
}

std::string PeerName(const std::string& what) {
  return "OpenCV " + std::string(CV_VERSION) + " ml, " + what;
}

struct FreeWorkspace {
  void operator()(hc_workspace* workspace) const noexcept { hc_workspace_free(workspace); }
};

hc_cloud CloudOf(const datasets::MaskedCloud& object) {
  const features::ObjectCloud view = object.View();
  return {view.points,
          view.width,
          view.height,
          view.row_stride,
          view.point_stride,
          view.mask,
          view.mask_stride};
}

// Trains OpenCV's machine afresh for some folds; `predicted` is what ours said of each view.
void TimePeerFolds(const Drawn& drawn,
                   const std::vector<std::uint32_t>& predicted,
                   int num_peer_folds,
                   BenchmarkResult& result) {
  const auto num_folds = static_cast<int>(drawn.classes.size());
  cv::setNumThreads(1);
  double same = 0.0;
  const std::clock_t start = std::clock();
  for (int fold = 0; fold < num_peer_folds; ++fold) {
    const int row = fold * num_folds / num_peer_folds;
    const float said = TrainPeer(drawn, row)->predict(MatOf(drawn).row(row));
    const std::uint32_t ours = predicted[static_cast<std::size_t>(row)];
    same += static_cast<std::uint32_t>(said) == ours ? 1.0 : 0.0;
  }
  result.peer_ms = 1e3 * static_cast<double>(std::clock() - start) /
                   static_cast<double>(CLOCKS_PER_SEC) / num_peer_folds * num_folds;
  result.peer = PeerName("every fold afresh, extrapolated");
  result.ratio = result.peer_ms / result.ours_ms;
  result.details["peer_folds"] = num_peer_folds;
  result.details["same_predictions"] = same;
}

}  // namespace

BenchmarkResult BenchmarkLeaveOneOut(const BenchmarkOptions& options,
                                     const ObjectClassBenchmarkSize& size) {
  const Drawn drawn = Draw(size);
  const std::size_t num_folds = drawn.classes.size();
  const std::vector<std::uint32_t> folds = svm::LeaveOneOutFolds(num_folds);
  svm::CrossValidation validation;
  BenchmarkResult result;
  result.dissertation_ms = std::numeric_limits<double>::quiet_NaN();
  const svm::Samples samples = svm::PrepareSamples(drawn.Matrix(), drawn.classes, {});
  const std::clock_t start = std::clock();
  result.ours_ms = MedianMs(size.repetitions, [&] {
    const svm::SampleMatrix gram = svm::ComputeGram(svm::ComputeInnerProducts(samples, 1),
                                                    drawn.svm.SimilarityFor(samples.num_features),
                                                    samples,
                                                    1);
    validation = svm::CrossValidate(gram, samples, folds, drawn.svm);
  });
  result.details["processor_seconds"] = static_cast<double>(std::clock() - start) /
                                        static_cast<double>(CLOCKS_PER_SEC) /
                                        (size.repetitions + 1);
  result.details["inner_products_ms"] =
      MedianMs(size.repetitions, [&] { (void)svm::ComputeInnerProducts(samples, 1); });
  Report(options.progress, "leave-one-out of the peer", 0, 0);
  TimePeerFolds(drawn, validation.predicted, size.peer_folds, result);
  result.details["num_folds"] = static_cast<double>(num_folds);
  result.details["num_machines"] = static_cast<double>(validation.num_machines);
  result.details["accuracy"] = validation.accuracy;
  return result;
}

BenchmarkResult BenchmarkClassify(const BenchmarkOptions& options,
                                  const ObjectClassBenchmarkSize& size) {
  Drawn drawn = Draw(size);
  drawn.svm.penalty = 1e-6;  // every sample is at its limit, a support vector
  const datasets::MaskedCloud object = DrawObject(0, size.views_per_class, size);
  model_io::ObjectClassModel made{
      .descriptor = drawn.descriptor,
      .svm = svm::TrainSvm(drawn.Matrix(), drawn.classes, drawn.svm).model};
  for (int c = 0; c < size.num_classes; ++c) made.classes.push_back("class_" + std::to_string(c));
  const LoadedModel model =
      LoadModel(model_io::Serialise(model_io::MakeObjectClassModel(made, object.View(), {})));
  hc_workspace* scratch = nullptr;
  const hc_status created = hc_row_workspace_create(model.get(), &scratch);
  HC_CHECK(created == HC_OK, hc_status_message(created));
  const std::unique_ptr<hc_workspace, FreeWorkspace> workspace(scratch);
  const hc_cloud cloud = CloudOf(object);
  hc_class_prediction prediction{};
  BenchmarkResult result;
  result.dissertation_ms = std::numeric_limits<double>::quiet_NaN();
  result.ours_ms = MedianMs(options.repetitions, [&] {
    const hc_status status =
        hc_classify_cloud(model.get(), workspace.get(), &cloud, &prediction, nullptr);
    HC_CHECK(status == HC_OK, hc_status_message(status));
  });
  std::vector<std::byte> sums(drawn.descriptor.WorkspaceBytes());
  std::vector<float> features(drawn.descriptor.NumFeatures());
  result.details["features_ms"] = MedianMs(options.repetitions, [&] {
    const bool done = drawn.descriptor.Compute(object.View(), sums, features);
    HC_CHECK(done);
  });
  cv::setNumThreads(1);
  const cv::Ptr<cv::ml::SVM> peer = TrainPeer(drawn, -1);
  const cv::Mat row(1, static_cast<int>(features.size()), CV_32F, features.data());
  result.peer_ms = MedianMs(options.repetitions, [&] { (void)peer->predict(row); });
  result.peer = PeerName("predict alone, features given");
  result.ratio = result.peer_ms / result.ours_ms;
  result.details["num_support_vectors"] = static_cast<double>(made.svm.NumSupportVectors());
  result.details["peer_support_vectors"] = peer->getSupportVectors().rows;
  return result;
}

BenchmarkResult BenchmarkSvmLeaveOneOut(const BenchmarkOptions& options) {
  return BenchmarkLeaveOneOut(options, {});
}

BenchmarkResult BenchmarkClassifyCloud(const BenchmarkOptions& options) {
  return BenchmarkClassify(options, {});
}

}  // namespace handcraft::experiments
