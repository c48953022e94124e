// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "experiments/evaluation/grasp_point_evaluation.h"
#include "experiments/evaluation/grasp_point_figures.h"

namespace handcraft::testing {

/// Three images of two classes whose figures are counted by hand:
///   cup/1.png  best: good, good, bad; pixels .9 .7 (good) .6 .2 (bad)
///   cup/2.png  best: none;            pixels .4 (good) .1 (bad)
///   pen/3.png  best: don't care;      pixels .8 (bad)
struct HandFilledEvaluation {
  datasets::LabelledImageSet set;
  experiments::GraspPointEvaluation evaluation;
};

inline HandFilledEvaluation MakeHandFilledEvaluation() {
  HandFilledEvaluation hand;
  hand.set.root = "hand";
  hand.set.items = {{"cup/1.png", "m1.png", "cup", "cup1", "test", ""},
                    {"cup/2.png", "m2.png", "cup", "cup2", "test", ""},
                    {"pen/3.png", "m3.png", "pen <x>", "pen1", "test", ""}};
  hand.evaluation.data_fingerprint = "0123abcd";
  hand.evaluation.options.bootstrap_resamples = 200;
  hand.evaluation.images = {
      {.item = 0,
       .best = {{5, 6, 0.99F, 255}, {7, 8, 0.95F, 255}, {9, 1, 0.91F, 0}},
       .probabilities = {0.9F, 0.7F, 0.6F, 0.2F},
       .labels = {1, 1, 0, 0},
       .score_ms = 1.0},
      {.item = 1, .best = {}, .probabilities = {0.4F, 0.1F}, .labels = {1, 0}, .score_ms = 2.0},
      {.item = 2,
       .best = {{2, 3, 0.97F, 128}},
       .probabilities = {0.8F},
       .labels = {0},
       .score_ms = 3.0}};
  experiments::FormFigures(hand.set, hand.evaluation);
  return hand;
}

}  // namespace handcraft::testing
