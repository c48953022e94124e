// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/svm_fit.h"

#include <set>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "lib/core/error.h"
#include "tools/number_option.h"
#include "tools/svm_options.h"

namespace handcraft::tools {
namespace {

constexpr const char* kForm =
    " given; it must be NAME=VALUE,VALUE… of kernel, degree, gamma, coef0 or C";

[[noreturn]] void RefuseSearch(const std::string& refusal) {
  throw Error({.kind = Error::Kind::kUsage, .reason = "--search: " + refusal});
}

void ReadValue(const std::string& text,
               features::SimilarityType svm::Options::* /*field*/,
               features::SimilarityType& value) {
  const auto& kernels = KernelWords();
  const auto found = kernels.find(text);
  if (found == kernels.end())
    RefuseSearch("kernel " + text + " given; it must be linear, poly or rbf");
  value = found->second;
}

template <class T>
void ReadValue(const std::string& text, T svm::Options::*field, T& value) {
  std::string number = text;
  const std::string refusal = TakenBy(field)(number);
  if (!refusal.empty()) RefuseSearch(refusal);
  static_cast<void>(ReadNumber(number, value));
}

template <class T>
void ReadValues(const std::string& list, T svm::Options::*field, std::vector<T>& values) {
  values.clear();
  std::istringstream stream(list);
  for (std::string text; std::getline(stream, text, ',');) {
    T value{};
    ReadValue(text, field, value);
    values.push_back(value);
  }
  if (values.empty() || list.back() == ',') RefuseSearch("'" + list + "'" + kForm);
}

void ReadList(const std::string& name, const std::string& list, svm::Grid& grid) {
  if (name == "kernel") return ReadValues(list, &svm::Options::kernel, grid.kernels);
  if (name == "degree") return ReadValues(list, &svm::Options::degree, grid.degrees);
  if (name == "gamma") return ReadValues(list, &svm::Options::gamma, grid.gammas);
  if (name == "coef0") return ReadValues(list, &svm::Options::coef0, grid.coef0s);
  if (name == "C") return ReadValues(list, &svm::Options::penalty, grid.penalties);
  RefuseSearch("'" + name + "'" + kForm);
}

}  // namespace

void AddSvmFitOptions(CLI::App& command, SvmFitOptions& options) {
  AddSvmOptions(command, options.svm);
  AddNumber(command,
            "--folds",
            options.num_folds,
            AnyNumber<std::size_t>(),
            "Cross-validate in so many folds, the same share of every class in each; 0: not")
      ->group(kSvmGroup);
  command
      .add_option("--search",
                  options.search,
                  "Values to choose from by --folds: kernel, degree, gamma, coef0, C")
      ->type_name("NAME=VALUE,…")
      ->group(kSvmGroup);
}

svm::Grid ParseGrid(const std::vector<std::string>& search, const svm::Options& base) {
  svm::Grid grid{.kernels = {base.kernel},
                 .degrees = {base.degree},
                 .gammas = {base.gamma},
                 .coef0s = {base.coef0},
                 .penalties = {base.penalty}};
  std::set<std::string> names;
  for (const std::string& text : search) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) RefuseSearch("'" + text + "'" + kForm);
    const std::string name = text.substr(0, equals);
    if (!names.insert(name).second) RefuseSearch(name + " given twice");
    ReadList(name, text.substr(equals + 1), grid);
  }
  return grid;
}

template <class T>
SvmFit FitSvm(const DesignMatrix<T>& X,
              std::span<const std::uint32_t> classes,
              const SvmFitOptions& options) {
  if (options.num_folds == 0 && !options.search.empty()) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "--search needs --folds: held-out samples say which values are best"});
  }
  SvmFit fit{.options = options.svm};
  if (options.num_folds > 0) {
    svm::GridSearch search = svm::SearchGridOfRows(X,
                                                   classes,
                                                   svm::StratifiedFolds(classes, options.num_folds),
                                                   ParseGrid(options.search, options.svm),
                                                   options.svm);
    fit.num_tried = search.points.size();
    fit.options = search.points[search.best].options;
    fit.held_out = std::move(search.points[search.best].validation);
  }
  fit.result = svm::TrainSvm(X, classes, fit.options);
  RequireUsable(fit.result.summary);
  return fit;
}

template SvmFit FitSvm(const DesignMatrix<float>&,
                       std::span<const std::uint32_t>,
                       const SvmFitOptions&);
template SvmFit FitSvm(const DesignMatrix<double>&,
                       std::span<const std::uint32_t>,
                       const SvmFitOptions&);

}  // namespace handcraft::tools
