// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/object_classes.h"

#include "datasets/synthetic/novel_objects.h"
#include "datasets/synthetic/trained_objects.h"

namespace handcraft::synthetic {
namespace {

constexpr std::array<ObjectClass, 9> kTrained = {{
    {"cereal_bowl", Family::kTrained, DrawCerealBowl, 1, 1800},
    {"eraser", Family::kTrained, DrawEraser, 1, 1700},
    {"martini_glass", Family::kTrained, DrawMartiniGlass, 1, 1700},
    {"mug", Family::kTrained, DrawMug, 1, 2001},
    {"stapler", Family::kTrained, DrawStapler, 1, 1500},
    {"tea_cup", Family::kTrained, DrawTeaCup, 1, 1800},
    {"pencil", Family::kTrained, DrawPencil, 1, 1700},
    {"two_tea_cups", Family::kTrained, DrawTeaCup, 2, 926},
    {"two_mugs", Family::kTrained, DrawMug, 2, 120},
}};

constexpr std::array<ObjectClass, 6> kNovel = {{
    {"bottle", Family::kNovel, DrawBottle, 1, 30},
    {"calculator", Family::kNovel, DrawCalculator, 1, 30},
    {"very_small_cup", Family::kNovel, DrawVerySmallCup, 1, 30},
    {"hammer", Family::kNovel, DrawHammer, 1, 30},
    {"shampoo_bottle", Family::kNovel, DrawShampooBottle, 1, 30},
    {"tape", Family::kNovel, DrawTape, 1, 30},
}};

}  // namespace

std::span<const ObjectClass> ClassesOf(Family family) {
  if (family == Family::kTrained) return kTrained;
  return kNovel;
}

}  // namespace handcraft::synthetic
