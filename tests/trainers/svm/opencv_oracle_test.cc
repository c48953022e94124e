// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/ml.hpp>

#include "tests/trainers/svm/drawn_classes.h"
#include "trainers/svm/cross_validation.h"

namespace handcraft::svm {
namespace {

using features::SimilarityType;

int KernelOf(SimilarityType type) {
  switch (type) {
    case SimilarityType::kLinear:
      return cv::ml::SVM::LINEAR;
    case SimilarityType::kPolynomial:
      return cv::ml::SVM::POLY;
    case SimilarityType::kRbf:
      return cv::ml::SVM::RBF;
  }
  return -1;
}

cv::Ptr<cv::ml::SVM> Untrained(const Options& options, std::size_t num_features) {
  const features::Similarity similarity = options.SimilarityFor(num_features);
  const cv::Ptr<cv::ml::SVM> svm = cv::ml::SVM::create();
  svm->setType(cv::ml::SVM::C_SVC);
  svm->setKernel(KernelOf(options.kernel));
  svm->setDegree(similarity.degree);
  svm->setGamma(similarity.gamma);
  svm->setCoef0(similarity.coef0);
  svm->setC(options.penalty);
  svm->setTermCriteria(
      {cv::TermCriteria::EPS + cv::TermCriteria::MAX_ITER, 10000000, options.smo.tolerance});
  return svm;
}

// What OpenCV says of row `out` after training on all the others, ordered by class.
std::uint32_t PredictLeftOut(const DrawnClasses<float>& drawn,
                             const Samples& samples,
                             std::size_t out,
                             const Options& options) {
  const int num_features = static_cast<int>(drawn.num_features);
  cv::Mat rows(0, num_features, CV_32F);
  std::vector<int> labels;
  const cv::Mat all(static_cast<int>(drawn.classes.size()),
                    num_features,
                    CV_32F,
                    const_cast<float*>(drawn.values.data()));
  for (const std::size_t row : samples.rows) {
    if (row == out) continue;
    rows.push_back(all.row(static_cast<int>(row)));
    labels.push_back(static_cast<int>(drawn.classes[row]));
  }
  const cv::Ptr<cv::ml::SVM> svm = Untrained(options, drawn.num_features);
  svm->train(rows, cv::ml::ROW_SAMPLE, labels);
  return static_cast<std::uint32_t>(svm->predict(all.row(static_cast<int>(out))));
}

// OpenCV computes kernels in single precision and shrinks the problem: its decision values are near
// ours, not equal, but those of no sample here lie that near to 0.
void ExpectOpencvsPredictions(const Options& options) {
  const auto drawn = DrawClasses<float>(
      {.num_classes = 6, .samples_per_class = 10, .num_features = 40, .spread = 0.9}, 51);
  const Samples samples = PrepareSamples(drawn.Matrix(), drawn.classes, {});
  const SampleMatrix gram =
      ComputeGram(ComputeInnerProducts(samples, 1), options.SimilarityFor(40), samples, 1);
  const CrossValidation validation =
      CrossValidate(gram, samples, LeaveOneOutFolds(drawn.classes.size()), options);
  for (std::size_t row = 0; row < drawn.classes.size(); ++row) {
    EXPECT_EQ(validation.predicted[row], PredictLeftOut(drawn, samples, row, options)) << row;
  }
  EXPECT_GT(validation.accuracy, 0.5);
  EXPECT_LT(validation.accuracy, 1.0) << "nothing was hard here";
}

TEST(OpencvOracle, LeaveOneOutWithAPolynomialKernel) {
  ExpectOpencvsPredictions({.degree = 3, .coef0 = 1.0, .penalty = 1.0});
}

TEST(OpencvOracle, LeaveOneOutWithARadialBasisKernel) {
  ExpectOpencvsPredictions({.kernel = SimilarityType::kRbf, .gamma = 0.01, .penalty = 5.0});
}

TEST(OpencvOracle, LeaveOneOutWithALinearKernel) {
  ExpectOpencvsPredictions({.kernel = SimilarityType::kLinear, .penalty = 0.05});
}

}  // namespace
}  // namespace handcraft::svm
