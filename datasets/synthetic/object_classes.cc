// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/object_classes.h"

#include <algorithm>
#include <string>

#include "datasets/synthetic/drills.h"
#include "datasets/synthetic/novel_objects.h"
#include "datasets/synthetic/spray_bottle.h"
#include "datasets/synthetic/taught_objects.h"
#include "datasets/synthetic/trained_objects.h"
#include "datasets/synthetic/untaught_objects.h"
#include "lib/core/check.h"
#include "lib/core/error.h"

namespace handcraft::synthetic {
namespace {

constexpr std::array<ObjectClass, 9> kTrained = {{
    {"cereal_bowl", Family::kTrained, DrawCerealBowl, 1, 1800, Symmetry::kRound},
    {"eraser", Family::kTrained, DrawEraser, 1, 1700, Symmetry::kHalfTurn},
    {"martini_glass", Family::kTrained, DrawMartiniGlass, 1, 1700, Symmetry::kRound},
    {"mug", Family::kTrained, DrawMug, 1, 2001},
    {"stapler", Family::kTrained, DrawStapler, 1, 1500},
    {"tea_cup", Family::kTrained, DrawTeaCup, 1, 1800},
    {"pencil", Family::kTrained, DrawPencil, 1, 1700},
    {"two_tea_cups", Family::kTrained, DrawTeaCup, 2, 926},
    {"two_mugs", Family::kTrained, DrawMug, 2, 120},
}};

constexpr std::array<ObjectClass, 6> kNovel = {{
    {"bottle", Family::kNovel, DrawBottle, 1, 30},  // round where it stands, some lie
    {"calculator", Family::kNovel, DrawCalculator, 1, 30},
    {"very_small_cup", Family::kNovel, DrawVerySmallCup, 1, 30},
    {"hammer", Family::kNovel, DrawHammer, 1, 30},
    {"shampoo_bottle", Family::kNovel, DrawShampooBottle, 1, 30, Symmetry::kHalfTurn},
    {"tape", Family::kNovel, DrawTape, 1, 30, Symmetry::kHalfTurn},
}};

constexpr std::array<ObjectClass, 6> kTaught = {{
    {"coffee_can", Family::kTaught, DrawCoffeeCan, 1, 36, Symmetry::kHalfTurn},
    {"drill", Family::kTaught, DrawDrill, 1, 36},
    {"mouthwash_bottle", Family::kTaught, DrawMouthwashBottle, 1, 36, Symmetry::kHalfTurn},
    {"mug", Family::kTaught, DrawBelliedMug, 1, 36},
    {"detergent_bottle", Family::kTaught, DrawDetergentBottle, 1, 36},
    {"plastic_bottle", Family::kTaught, DrawPlasticBottle, 1, 36, Symmetry::kRound},
}};

constexpr std::array<ObjectClass, 8> kUntaught = {{
    {"dvd_case", Family::kUntaught, DrawDvdCase, 1, 30, Symmetry::kHalfTurn},
    {"other_drill", Family::kUntaught, DrawOtherDrill, 1, 30},
    {"shampoo_bottle", Family::kUntaught, DrawFlipTopBottle, 1, 30, Symmetry::kHalfTurn},
    {"other_mug", Family::kUntaught, DrawTaperedMug, 1, 30},
    {"other_detergent_bottle", Family::kUntaught, DrawSlantedJug, 1, 30},
    {"water_bottle", Family::kUntaught, DrawWaterBottle, 1, 30, Symmetry::kRound},
    {"salt_container", Family::kUntaught, DrawSaltContainer, 1, 30, Symmetry::kRound},
    {"rectangular_box", Family::kUntaught, DrawRectangularBox, 1, 30, Symmetry::kHalfTurn},
}};

constexpr std::array<ObjectClass, 4> kRegrasp = {{
    {"water_bottle", Family::kRegrasp, DrawWaterBottle, 1, 36, Symmetry::kRound},
    {"spray_bottle", Family::kRegrasp, DrawSprayBottle, 1, 36},
    {"coffee_can", Family::kRegrasp, DrawCoffeeCan, 1, 36, Symmetry::kHalfTurn},
    {"drill", Family::kRegrasp, DrawDrill, 1, 36},
}};

constexpr std::array<std::string_view, 5> kFamilyNames = {
    "trained", "novel", "taught", "untaught", "regrasp"};

}  // namespace

std::string_view NameOf(Family family) { return kFamilyNames.at(static_cast<std::size_t>(family)); }

Family FamilyNamed(std::string_view name) {
  const auto* const found = std::find(kFamilyNames.begin(), kFamilyNames.end(), name);
  if (found == kFamilyNames.end()) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "there is no family of objects \"" + std::string(name) + "\"",
                 .remedy = "give trained, novel, taught, untaught or regrasp"});
  }
  return static_cast<Family>(found - kFamilyNames.begin());
}

std::string_view NameOf(Symmetry symmetry) {
  switch (symmetry) {
    case Symmetry::kNone:
      return "none";
    case Symmetry::kHalfTurn:
      return "half_turn";
    case Symmetry::kRound:
      return "round";
  }
  HC_CHECK(false, static_cast<int>(symmetry));
  return {};
}

std::span<const ObjectClass> ClassesOf(Family family) {
  switch (family) {
    case Family::kTrained:
      return kTrained;
    case Family::kNovel:
      return kNovel;
    case Family::kTaught:
      return kTaught;
    case Family::kUntaught:
      return kUntaught;
    case Family::kRegrasp:
      return kRegrasp;
  }
  HC_CHECK(false, static_cast<int>(family));
  return {};
}

}  // namespace handcraft::synthetic
