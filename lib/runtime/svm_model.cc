// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/svm_model.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace handcraft::runtime {

using features::PaddedLength;

// Where in the workspace things lie; every part begins at a multiple of 64 bytes.
struct SvmModel::Scratch {
  std::byte* sample;          // PaddedLength(NumFeatures()) numbers of the support vectors' type
  std::span<double> kernels;  // K of each support vector and the sample
  std::span<double> decisions;
  std::span<std::int32_t> votes;
};

namespace {

constexpr std::size_t kAlignment = 64;

constexpr std::size_t Aligned(std::size_t num_bytes) noexcept {
  return (num_bytes + kAlignment - 1) / kAlignment * kAlignment;
}

std::size_t SampleBytes(std::size_t num_features) noexcept {
  return Aligned(PaddedLength(num_features) * sizeof(double));
}

}  // namespace

std::size_t SvmModel::WorkspaceBytes() const noexcept {
  return SampleBytes(NumFeatures()) + Aligned(squared_norms_.size() * sizeof(double)) +
         Aligned(NumMachines() * sizeof(double)) +
         Aligned(class_names_.size() * sizeof(std::int32_t));
}

SvmModel::Scratch SvmModel::Divide(std::span<std::byte> workspace) const noexcept {
  std::byte* kernels = workspace.data() + SampleBytes(NumFeatures());
  std::byte* decisions = kernels + Aligned(squared_norms_.size() * sizeof(double));
  std::byte* votes = decisions + Aligned(NumMachines() * sizeof(double));
  return {.sample = workspace.data(),
          .kernels = {reinterpret_cast<double*>(kernels), squared_norms_.size()},
          .decisions = {reinterpret_cast<double*>(decisions), NumMachines()},
          .votes = {reinterpret_cast<std::int32_t*>(votes), class_names_.size()}};
}

template <class T>
void SvmModel::CompareWithSupport(const SupportVectors<T>& support,
                                  std::span<const double> row,
                                  const Scratch& scratch) const noexcept {
  T* sample = reinterpret_cast<T*>(scratch.sample);
  const std::size_t stride = support.rows.stride;
  for (std::size_t j = 0; j < row.size(); ++j) {
    sample[j] = static_cast<T>((row[j] - feature_mean_[j]) / feature_scale_[j]);
  }
  std::fill(sample + row.size(), sample + stride, T{0});
  features::InnerProducts(support.rows, sample, scratch.kernels);
  double squared_norm = 0.0;
  if (similarity_.type == features::SimilarityType::kRbf) {
    features::InnerProducts(features::PaddedRows<T>{sample, 1, stride}, sample, {&squared_norm, 1});
  }
  for (std::size_t v = 0; v < scratch.kernels.size(); ++v) {
    scratch.kernels[v] = similarity_(scratch.kernels[v], squared_norm, squared_norms_[v]);
  }
}

void SvmModel::Evaluate(std::span<const double> row, const Scratch& scratch) const noexcept {
  if (const auto* floats = std::get_if<SupportVectors<float>>(&support_)) {
    CompareWithSupport(*floats, row, scratch);
  } else if (const auto* doubles = std::get_if<SupportVectors<double>>(&support_)) {
    CompareWithSupport(*doubles, row, scratch);
  }
  for (std::size_t m = 0; m < NumMachines(); ++m) {
    double value = intercepts_[m];
    const auto end = static_cast<std::size_t>(machine_begins_[m + 1]);
    for (auto k = static_cast<std::size_t>(machine_begins_[m]); k < end; ++k) {
      value +=
          dual_coefficients_[k] * scratch.kernels[static_cast<std::size_t>(machine_supports_[k])];
    }
    scratch.decisions[m] = value;
  }
}

double SvmModel::Magnitude(std::size_t machine, std::span<std::byte> workspace) const noexcept {
  const Scratch scratch = Divide(workspace);
  double magnitude = std::fabs(intercepts_[machine]);
  const auto end = static_cast<std::size_t>(machine_begins_[machine + 1]);
  for (auto k = static_cast<std::size_t>(machine_begins_[machine]); k < end; ++k) {
    magnitude += std::fabs(dual_coefficients_[k] *
                           scratch.kernels[static_cast<std::size_t>(machine_supports_[k])]);
  }
  return magnitude;
}

std::span<const double> SvmModel::Decisions(std::span<std::byte> workspace) const noexcept {
  return Divide(workspace).decisions;
}

SvmModel::Prediction SvmModel::Predict(std::span<const double> row,
                                       std::span<std::byte> workspace) const noexcept {
  const Scratch scratch = Divide(workspace);
  Evaluate(row, scratch);
  const features::ClassVote vote =
      features::VoteForClass(scheme_, scratch.decisions, scratch.votes);
  return {.vote = vote,
          .is_rejected = rejection_threshold_ && !(vote.margin >= *rejection_threshold_)};
}

}  // namespace handcraft::runtime
