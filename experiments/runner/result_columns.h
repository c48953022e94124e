// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "experiments/runner/cell_result.h"

namespace handcraft::experiments {

/// The four counts of a confusion matrix, their names with `ending`.
template <class Matrix, class Visit>
void VisitConfusionColumns(Matrix& matrix, const std::string& ending, const Visit& visit) {
  visit("true_positive" + ending, matrix.true_positive);
  visit("false_positive" + ending, matrix.false_positive);
  visit("true_negative" + ending, matrix.true_negative);
  visit("false_negative" + ending, matrix.false_negative);
}

/// Calls visit(name, number) for every figure of a group, in the order of the columns of
/// results.csv. The numbers are double or std::size_t, and may be written to when the group may.
template <class Group, class Visit>
void VisitGroupColumns(Group& group, const Visit& visit) {
  const auto estimate = [&](const std::string& name, auto& of) {
    visit(name, of.value);
    visit(name + "_low", of.low);
    visit(name + "_high", of.high);
  };
  const auto rates = [&](const std::string& ending, auto& of) {
    estimate("true_positive_rate" + ending, of.true_positive_rate);
    estimate("true_negative_rate" + ending, of.true_negative_rate);
  };
  visit("num_images", group.num_images);
  visit("num_images_without_best", group.num_images_without_best);
  visit("best_good", group.best_good);
  visit("best_counted", group.best_total);
  visit("best_dont_care", group.best_dont_care);
  estimate("best_pixel_accuracy", group.best_pixel_accuracy);
  VisitConfusionColumns(group.confusion, "", visit);
  rates("", group.rates);
  estimate("accuracy", group.accuracy);
  estimate("auc", group.auc);
  estimate("average_precision", group.average_precision);
  estimate("log_loss", group.log_loss);
  estimate("brier", group.brier);
  VisitConfusionColumns(group.strict_confusion, "_at_0.9", visit);
  rates("_at_0.9", group.strict_rates);
  estimate("accuracy_at_0.9", group.strict_accuracy);
}

/// The same for what a cell's training came to.
template <class Result, class Visit>
void VisitTrainingColumns(Result& result, const Visit& visit) {
  visit("num_training_images", result.num_training_images);
  visit("num_samples", result.num_samples);
  visit("num_features", result.num_features);
  visit("training_log_loss", result.training_log_loss);
}

/// The same for the times, the columns of times.csv.
template <class Result, class Visit>
void VisitTimeColumns(Result& result, const Visit& visit) {
  visit("features_time_s", result.features_time_s);
  visit("training_time_s", result.training_time_s);
  visit("score_time_ms", result.score_time_ms);
}

/// The same for a stage of search-space reduction, the columns of search_space.csv.
template <class Stage, class Visit>
void VisitStageColumns(Stage& stage, const Visit& visit) {
  visit("num_pixels", stage.num_pixels);
  visit("time_ms", stage.time_ms);
}

/// The same for a picture.
template <class Figures, class Visit>
void VisitImageColumns(Figures& figures, const Visit& visit) {
  visit("best_good", figures.best.good);
  visit("best_bad", figures.best.bad);
  visit("best_dont_care", figures.best.dont_care);
  visit("num_pixels", figures.num_pixels);
  VisitConfusionColumns(figures.confusion, "", visit);
  VisitConfusionColumns(figures.strict_confusion, "_at_0.9", visit);
  visit("log_loss_sum", figures.log_loss_sum);
  visit("squared_error_sum", figures.squared_error_sum);
}

}  // namespace handcraft::experiments
