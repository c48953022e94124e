// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/svm_options.h"

#include <map>
#include <string>

#include "lib/core/error.h"
#include "tools/number_option.h"

namespace handcraft::tools {
namespace {

using features::ClassScheme;
using features::SimilarityType;

// An option for one of several words.
template <class T>
void AddChoice(CLI::App& command,
               const std::string& name,
               T& value,
               const std::map<std::string, T>& choices,
               const std::string& description) {
  std::vector<std::string> words;
  std::string chosen;
  for (const auto& [word, choice] : choices) {
    words.push_back(word);
    if (choice == value) chosen = word;
  }
  command
      .add_option_function<std::string>(
          name,
          [&value, choices](const std::string& word) { value = choices.at(word); },
          description)
      ->check(CLI::IsMember(words))
      ->type_name("WORD")
      ->default_str(chosen)
      ->group(kSvmGroup);
}

}  // namespace

const std::map<std::string, SimilarityType>& KernelWords() {
  static const std::map<std::string, SimilarityType> words = {{"linear", SimilarityType::kLinear},
                                                              {"poly", SimilarityType::kPolynomial},
                                                              {"rbf", SimilarityType::kRbf}};
  return words;
}

void AddSvmOptions(CLI::App& command, svm::Options& options) {
  using svm::Options;
  AddChoice<SimilarityType>(command,
                            "--kernel",
                            options.kernel,
                            KernelWords(),
                            "K(a, b): linear aᵀb, poly (γ aᵀb + c)^degree, rbf exp(−γ‖a − b‖²)");
  AddNumber(command, "--degree", options, &Options::degree, "Degree of the polynomial")
      ->group(kSvmGroup);
  AddNumber(command, "--gamma", options, &Options::gamma, "γ; 0: 1 / number of features")
      ->group(kSvmGroup);
  AddNumber(command, "--coef0", options, &Options::coef0, "c of the polynomial")->group(kSvmGroup);
  AddNumber(command, "--C", options, &Options::penalty, "Penalty of what is on the wrong side")
      ->group(kSvmGroup);
  AddChoice<ClassScheme>(command,
                         "--scheme",
                         options.scheme,
                         {{"one-against-one", ClassScheme::kOneAgainstOne},
                          {"one-against-all", ClassScheme::kOneAgainstAll}},
                         "A machine for each pair of classes, or for each class");
  command.add_flag("--standardize", options.standardize, "Features to mean 0 and deviation 1")
      ->group(kSvmGroup);
  AddNumber(command,
            "--tolerance",
            options.smo,
            &svm::SmoOptions::tolerance,
            "Largest violation of the optimality conditions at the end")
      ->group(kSvmGroup);
}

void RequireUsable(const svm::Summary& summary) {
  if (summary.termination == svm::Termination::kConverged) return;
  throw Error({.kind = Error::Kind::kNoResult,
               .reason = "no model: " + summary.message,
               .remedy = "give --standardize, a smaller --C or a larger --tolerance"});
}

}  // namespace handcraft::tools
