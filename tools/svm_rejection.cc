// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/svm_rejection.h"

#include <fmt/format.h>

#include "experiments/metrics/binary_metrics.h"
#include "lib/core/fields.h"
#include "tools/number_option.h"
#include "tools/svm_options.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using Json = nlohmann::ordered_json;

std::string PercentOf(std::size_t part, std::size_t whole) {
  return fmt::format("{:.2f} %", 100.0 * experiments::WilsonInterval(part, whole).value);
}

std::string WithInterval(std::size_t part, std::size_t whole) {
  const experiments::Estimate share = experiments::WilsonInterval(part, whole);
  return fmt::format("{:.2f} % (95 % interval {:.2f} to {:.2f} %)",
                     100.0 * share.value,
                     100.0 * share.low,
                     100.0 * share.high);
}

}  // namespace

void AddNovelOptions(CLI::App& command,
                     const std::string& type,
                     const std::string& samples,
                     NovelOptions& novel) {
  CLI::Option* const path =
      command
          .add_option("--novel",
                      novel.path,
                      "Novel " + samples +
                          ", of no class: sets the margin below which one is none of the classes. "
                          "Finding most novel ones may lose many known ones: both shares are told")
          ->type_name(type)
          ->group(kSvmGroup);
  AddNumber(command,
            "--max-lost",
            novel.max_lost,
            CheckNumber<double>([](double share) {
              return share >= 0.0 && share <= 1.0 ? std::string() : "a share from 0 to 1";
            }),
            "With --novel: at most this share of the known " + samples + " is lost, 0 to 1")
      ->needs(path)
      ->group(kSvmGroup);
}

std::vector<svm::Rejection> FewOf(const std::vector<svm::Rejection>& trade_off) {
  std::vector<svm::Rejection> few;
  for (const double share : {0.5, 0.75, 0.9, 0.95, 1.0}) {
    for (const svm::Rejection& rejection : trade_off) {
      const auto wanted = share * static_cast<double>(rejection.num_novel);
      if (static_cast<double>(rejection.num_novel_rejected) < wanted) continue;
      if (few.empty() || few.back().threshold < rejection.threshold) few.push_back(rejection);
      break;
    }
  }
  return few;
}

void AddJson(const svm::Calibration& calibration, Json& json) {
  const svm::Rejection& chosen = calibration.chosen;
  json["rejection_threshold"] = chosen.threshold;
  json["false_rejection"] = chosen.FalseRejection();
  json["false_acceptance"] = chosen.FalseAcceptance();
  json["num_held_out"] = chosen.num_known;
  json["num_novel"] = chosen.num_novel;
  json["trade_off"] = Json::array();
  for (const svm::Rejection& other : FewOf(calibration.trade_off)) {
    json["trade_off"].push_back({{"threshold", other.threshold},
                                 {"false_rejection", other.FalseRejection()},
                                 {"false_acceptance", other.FalseAcceptance()}});
  }
}

std::string ToText(const svm::Calibration& calibration, const std::string& samples) {
  const svm::Rejection& chosen = calibration.chosen;
  TextTable others({"novel found", "known lost", "margin below"});
  for (const svm::Rejection& other : FewOf(calibration.trade_off)) {
    others.AddRow({PercentOf(other.num_novel_rejected, other.num_novel),
                   PercentOf(other.num_known_rejected, other.num_known),
                   fmt::format("{:.4g}", other.threshold)});
  }
  return fmt::format(
             "None of these below a margin of {:.4g}: {} of {} novel {} are found, {},\n"
             "and {} of {} known ones, held out, are lost, {}\n\n",
             chosen.threshold,
             chosen.num_novel_rejected,
             chosen.num_novel,
             samples,
             WithInterval(chosen.num_novel_rejected, chosen.num_novel),
             chosen.num_known_rejected,
             chosen.num_known,
             WithInterval(chosen.num_known_rejected, chosen.num_known)) +
         others.ToText() +
         (chosen.num_novel_rejected > 0
              ? ""
              : "\nThis threshold finds none: what is novel here looks like what is known.\n") +
         fmt::format(
             "\n--max-lost takes another. Known {} that are less like those trained on\n"
             "are lost more often: measure it with 'handcraft evaluate'.\n",
             samples);
}

void AddMetrics(const svm::Calibration& calibration, std::map<std::string, std::string>& metrics) {
  const svm::Rejection& chosen = calibration.chosen;
  metrics["rejection.num_held_out"] = NumberToText(chosen.num_known);
  metrics["rejection.false_rejection"] = NumberToText(chosen.FalseRejection());
  metrics["rejection.num_novel"] = NumberToText(chosen.num_novel);
  metrics["rejection.false_acceptance"] = NumberToText(chosen.FalseAcceptance());
}

std::string DroppedThresholdText(double threshold) {
  return fmt::format(
      "the model rejected what has a margin below {:.4g}; that was set without the new class and "
      "is dropped: everything is taken for one of the classes (give --novel, with samples of all "
      "classes, to set it anew)",
      threshold);
}

}  // namespace handcraft::tools
