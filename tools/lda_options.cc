// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/lda_options.h"

#include "lib/core/error.h"
#include "tools/feature_names.h"
#include "tools/number_option.h"

namespace handcraft::tools {
namespace {

void SetShrinkage(const std::string& text, lda::Options& options) {
  options = {.positive_prior = options.positive_prior,
             .num_threads = options.num_threads,
             .progress = options.progress};
  if (text == "auto") {
    options.shrinkage_rule = lda::ShrinkageRule::kLedoitWolf;
  } else {
    static_cast<void>(ReadNumber(text, options.shrinkage));
  }
}

// "auto", or what the trainer takes.
CLI::Validator ShrinkageRuleOrNumber() {
  const CLI::Validator number = TakenBy(&lda::Options::shrinkage);
  const auto check = [number](std::string& text) -> std::string {
    if (text == "auto") return "";
    const std::string fault = number(text);
    return fault.empty() ? "" : fault + ", or auto";
  };
  return {check, ""};
}

}  // namespace

void AddLdaOptions(CLI::App& command, lda::Options& options) {
  command
      .add_option_function<std::string>(
          "--shrinkage",
          [&options](const std::string& text) { SetShrinkage(text, options); },
          "Share λ of the identity in (1 − λ)R + λI, R the pooled correlation: [0, 1], or auto "
          "(Ledoit and Wolf)")
      ->check(ShrinkageRuleOrNumber())
      ->type_name("NUMBER|auto")
      ->default_str("0")
      ->group(kLdaGroup);
  AddNumber(command,
            "--prior",
            options,
            &lda::Options::positive_prior,
            "Probability of label 1 before anything is seen, (0, 1); 0: its share of the samples")
      ->group(kLdaGroup);
}

void RequireUsable(const lda::Summary& summary,
                   const std::vector<std::string>& feature_names,
                   const Console& console) {
  if (summary.termination != lda::Termination::kSolved) {
    // The trainer's own advice names fields of its options; here people give arguments.
    const bool by_shrinkage = summary.advice.find("shrinkage") != std::string::npos;
    throw Error({.kind = Error::Kind::kNoResult,
                 .reason = "no model: " + summary.message,
                 .remedy = by_shrinkage ? "give --shrinkage auto" : summary.advice});
  }
  if (!summary.constant_features.empty()) {
    console.Warn("constant features get the weight 0: " +
                 FirstNames(summary.constant_features, feature_names));
  }
}

}  // namespace handcraft::tools
