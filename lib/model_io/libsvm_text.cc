// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/libsvm_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "lib/core/error.h"
#include "lib/core/fields.h"

namespace handcraft::model_io {
namespace {

using features::PairIndex;
using features::SimilarityType;

constexpr std::size_t kMaxIndex = 1000000;

template <class T>
bool ReadNumber(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

// Column of libsvm's table of coefficients that a support vector of class `own` has for the pair
// with `other`.
std::size_t CoefficientColumn(std::size_t own, std::size_t other) {
  return other < own ? other : other - 1;
}

void RequireExpressible(const SvmModel& model) {
  const auto refuse = [](const char* reason, const char* remedy) {
    throw Error({.kind = Error::Kind::kUsage, .reason = reason, .remedy = remedy});
  };
  if (model.scheme != features::ClassScheme::kOneAgainstOne && model.num_classes > 2) {
    refuse("libsvm's text holds pairs of classes; this model is one against all",
           "train it with --scheme one-against-one");
  }
  const bool has_normaliser =
      std::any_of(
          model.feature_mean.begin(), model.feature_mean.end(), [](auto m) { return m != 0.0; }) ||
      std::any_of(
          model.feature_scale.begin(), model.feature_scale.end(), [](auto s) { return s != 1.0; });
  if (has_normaliser) {
    refuse("libsvm's text has no place for the normaliser of this model",
           "train it without --standardize, on a table that is scaled already");
  }
}

std::vector<std::string> LibsvmLabels(const std::vector<std::string>& names) {
  const bool are_numbers = std::all_of(names.begin(), names.end(), [](const std::string& name) {
    std::int32_t number = 0;
    return ReadNumber(name, number);
  });
  if (are_numbers) return names;
  std::vector<std::string> labels;
  for (std::size_t c = 0; c < names.size(); ++c) labels.push_back(NumberToText(c));
  return labels;
}

std::string HeaderText(const NamedSvm& svm, const std::vector<std::size_t>& counts) {
  const SvmModel& model = svm.model;
  const features::Similarity& kernel = model.similarity;
  const bool is_polynomial = kernel.type == SimilarityType::kPolynomial;
  std::string text = "svm_type c_svc\nkernel_type ";
  text += is_polynomial ? "polynomial" : std::string(features::NameOf(kernel.type));
  if (is_polynomial) text += "\ndegree " + NumberToText(kernel.degree);
  if (kernel.type != SimilarityType::kLinear) text += "\ngamma " + NumberToText(kernel.gamma);
  if (is_polynomial) text += "\ncoef0 " + NumberToText(kernel.coef0);
  text += "\nnr_class " + NumberToText(model.num_classes);
  text += "\ntotal_sv " + NumberToText(model.NumSupportVectors());
  text += "\nrho";
  for (std::size_t a = 0; a < model.num_classes; ++a) {
    for (std::size_t b = a + 1; b < model.num_classes; ++b) {
      text += ' ';
      text += NumberToText(-model.intercepts[PairIndex(a, b)]);
    }
  }
  text += "\nlabel";
  for (const std::string& label : LibsvmLabels(svm.names.classes)) {
    text += ' ';
    text += label;
  }
  text += "\nnr_sv";
  for (const std::size_t count : counts) {
    text += ' ';
    text += NumberToText(count);
  }
  return text + "\nSV\n";
}

// The lines of a model's text, and its errors.
class ModelLines {
 public:
  ModelLines(std::string_view text, const std::string& path) : rest_(text), path_(path) {}

  bool Next(std::vector<std::string_view>& words) {
    if (rest_.empty()) return false;
    const std::size_t length = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, length);
    rest_.remove_prefix(std::min(length + 1, rest_.size()));
    ++line_;
    constexpr std::string_view kBlanks = " \t\r";
    words.clear();
    for (;;) {
      line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
      if (line.empty()) return true;
      const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
      words.push_back(line.substr(0, end));
      line.remove_prefix(end);
    }
  }

  template <class T>
  [[nodiscard]] T Number(std::string_view word) const {
    T value{};
    if (!ReadNumber(word, value))
      Fail("'" + std::string(word.substr(0, 40)) + "' is no number here");
    if constexpr (std::is_floating_point_v<T>) {
      if (!std::isfinite(value)) Fail("'" + std::string(word) + "' is not finite");
    }
    return value;
  }

  [[noreturn]] void Fail(const std::string& reason) const {
    throw Error({.path = path_,
                 .line = line_,
                 .reason = reason,
                 .remedy = "give a model written by svm-train"});
  }

 private:
  std::string_view rest_;
  const std::string& path_;
  std::size_t line_ = 0;
};

// What stands above the support vectors: key → words.
using Header = std::map<std::string, std::vector<std::string_view>, std::less<>>;

Header ReadHeader(ModelLines& lines) {
  Header header;
  std::vector<std::string_view> words;
  while (lines.Next(words)) {
    if (words.empty()) continue;
    if (words[0] == "SV") return header;
    header[std::string(words[0])] = {words.begin() + 1, words.end()};
  }
  lines.Fail("the line 'SV' is missing");
}

const std::vector<std::string_view>& WordsOf(const Header& header,
                                             std::string_view key,
                                             std::size_t count,
                                             const ModelLines& lines) {
  const auto found = header.find(key);
  if (found != header.end() && found->second.size() == count) return found->second;
  lines.Fail("above this line, '" + std::string(key) + "' with " + NumberToText(count) +
             " values is missing");
}

features::Similarity ReadKernel(const Header& header, const ModelLines& lines) {
  const std::string_view type = WordsOf(header, "svm_type", 1, lines)[0];
  if (type != "c_svc" && type != "nu_svc") {
    lines.Fail("svm_type " + std::string(type) + " is no classifier: c_svc or nu_svc is due");
  }
  const std::string_view name = WordsOf(header, "kernel_type", 1, lines)[0];
  const auto number = [&](std::string_view key) {
    return lines.Number<double>(WordsOf(header, key, 1, lines)[0]);
  };
  if (name == "linear") return {.type = SimilarityType::kLinear};
  if (name == "rbf") return {.type = SimilarityType::kRbf, .gamma = number("gamma")};
  if (name == "polynomial") {
    return {.type = SimilarityType::kPolynomial,
            .degree = lines.Number<int>(WordsOf(header, "degree", 1, lines)[0]),
            .gamma = number("gamma"),
            .coef0 = number("coef0")};
  }
  lines.Fail("kernel_type " + std::string(name) + ": linear, polynomial or rbf is due");
}

// Support vectors as they stand in the file.
struct SparseRows {
  std::vector<std::vector<double>> coefficients;  // num_classes − 1 each
  std::vector<std::vector<std::pair<std::size_t, double>>> entries;
  std::size_t num_features = 0;
};

void ReadSupportVector(const std::vector<std::string_view>& words,
                       std::size_t num_coefficients,
                       const ModelLines& lines,
                       SparseRows& rows) {
  if (words.size() < num_coefficients) {
    lines.Fail(NumberToText(num_coefficients) + " coefficients are due at the front of the line");
  }
  rows.coefficients.emplace_back();
  rows.entries.emplace_back();
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (k < num_coefficients) {
      rows.coefficients.back().push_back(lines.Number<double>(words[k]));
      continue;
    }
    const std::size_t colon = std::min(words[k].find(':'), words[k].size());
    const auto index = lines.Number<std::size_t>(words[k].substr(0, colon));
    if (index < 1 || index > kMaxIndex) lines.Fail("an index is a number from 1 to 1000000");
    rows.num_features = std::max(rows.num_features, index);
    rows.entries.back().emplace_back(
        index - 1, lines.Number<double>(words[k].substr(std::min(colon + 1, words[k].size()))));
  }
}

// Labels, and what each pair's decision value begins with.
void ReadClasses(const Header& header, const ModelLines& lines, NamedSvm& svm) {
  constexpr std::size_t kMaxClasses = 4096;
  const auto k = lines.Number<std::size_t>(WordsOf(header, "nr_class", 1, lines)[0]);
  if (k < 2 || k > kMaxClasses) lines.Fail("nr_class is " + NumberToText(k) + "; 2 to 4096 is due");
  svm.model.num_classes = k;
  for (const std::string_view label : WordsOf(header, "label", k, lines)) {
    svm.names.classes.emplace_back(label);
  }
  svm.model.intercepts.resize(k * (k - 1) / 2);
  const auto& rho = WordsOf(header, "rho", svm.model.intercepts.size(), lines);
  for (std::size_t a = 0, next = 0; a < k; ++a) {
    for (std::size_t b = a + 1; b < k; ++b) {
      svm.model.intercepts[PairIndex(a, b)] = -lines.Number<double>(rho[next++]);
    }
  }
}

SparseRows ReadSupportVectors(const Header& header, ModelLines& lines, SvmModel& model) {
  SparseRows rows;
  std::vector<std::string_view> words;
  const auto& counts = WordsOf(header, "nr_sv", model.num_classes, lines);
  for (std::size_t c = 0; c < model.num_classes; ++c) {
    const auto count = lines.Number<std::size_t>(counts[c]);
    for (std::size_t v = 0; v < count; ++v) {
      if (!lines.Next(words)) lines.Fail("the file ends before its last support vector");
      ReadSupportVector(words, model.num_classes - 1, lines, rows);
      model.support_classes.push_back(static_cast<std::int32_t>(c));
    }
  }
  if (rows.num_features == 0) lines.Fail("the support vectors have no numbers");
  return rows;
}

void FillMachines(const SparseRows& rows, SvmModel& model) {
  model.machine_begins = {0};
  for (std::size_t b = 1; b < model.num_classes; ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      for (std::size_t v = 0; v < model.NumSupportVectors(); ++v) {
        const auto own = static_cast<std::size_t>(model.support_classes[v]);
        if (own != a && own != b) continue;
        const double coefficient = rows.coefficients[v][CoefficientColumn(own, own == a ? b : a)];
        if (coefficient == 0.0) continue;
        model.machine_supports.push_back(static_cast<std::int32_t>(v));
        model.dual_coefficients.push_back(coefficient);
      }
      model.machine_begins.push_back(static_cast<std::int32_t>(model.machine_supports.size()));
    }
  }
}

}  // namespace

std::string ToLibsvmText(const NamedSvm& svm) {
  const SvmModel& model = svm.model;
  RequireExpressible(model);
  const std::size_t k = model.num_classes;
  const std::size_t p = model.NumFeatures();
  std::vector<std::vector<double>> coefficients(model.NumSupportVectors(),
                                                std::vector<double>(k - 1, 0.0));
  for (std::size_t b = 1; b < k; ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      const std::size_t m = PairIndex(a, b);
      const auto end = static_cast<std::size_t>(model.machine_begins[m + 1]);
      for (auto i = static_cast<std::size_t>(model.machine_begins[m]); i < end; ++i) {
        const auto v = static_cast<std::size_t>(model.machine_supports[i]);
        const auto own = static_cast<std::size_t>(model.support_classes[v]);
        coefficients[v][CoefficientColumn(own, own == a ? b : a)] += model.dual_coefficients[i];
      }
    }
  }
  std::vector<std::size_t> counts(k, 0);
  for (const std::int32_t c : model.support_classes) ++counts[static_cast<std::size_t>(c)];
  std::string text = HeaderText(svm, counts);
  for (std::size_t c = 0; c < k; ++c) {  // libsvm has them class by class
    for (std::size_t v = 0; v < model.NumSupportVectors(); ++v) {
      if (static_cast<std::size_t>(model.support_classes[v]) != c) continue;
      for (const double coefficient : coefficients[v]) text += NumberToText(coefficient) + ' ';
      for (std::size_t j = 0; j < p; ++j) {
        const double value = model.support_vectors[v * p + j];
        if (value == 0.0) continue;
        text += NumberToText(j + 1);
        text += ':';
        text += NumberToText(value);
        text += ' ';
      }
      text += '\n';
    }
  }
  return text;
}

NamedSvm FromLibsvmText(std::string_view text, const std::string& path) {
  ModelLines lines(text, path);
  const Header header = ReadHeader(lines);
  NamedSvm svm;
  SvmModel& model = svm.model;
  model.similarity = ReadKernel(header, lines);
  ReadClasses(header, lines, svm);
  const SparseRows rows = ReadSupportVectors(header, lines, model);
  const std::size_t p = rows.num_features;
  model.feature_mean.assign(p, 0.0);
  model.feature_scale.assign(p, 1.0);
  model.support_vectors.assign(p * model.NumSupportVectors(), 0.0);
  for (std::size_t v = 0; v < rows.entries.size(); ++v) {
    for (const auto& [index, value] : rows.entries[v]) model.support_vectors[v * p + index] = value;
  }
  FillMachines(rows, model);
  svm.names.label_column = "label";
  for (std::size_t j = 1; j <= p; ++j) svm.names.columns.push_back(NumberToText(j));
  return svm;
}

void GiveNames(const SvmNames& names, NamedSvm& svm) {
  SvmModel& model = svm.model;
  const std::size_t old_p = model.NumFeatures();
  const std::size_t p = names.columns.empty() ? old_p : names.columns.size();
  if (p < old_p) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = NumberToText(p) + " columns are named; the support vectors have " +
                           NumberToText(old_p),
                 .remedy = "name all columns of the table but the label, in their order"});
  }
  if (!names.classes.empty() && names.classes.size() != model.num_classes) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = NumberToText(names.classes.size()) +
                           " classes are named; the model has " + NumberToText(model.num_classes),
                 .remedy = "name them in the order of the line 'label' of libsvm's text"});
  }
  std::vector<double> vectors(p * model.NumSupportVectors(), 0.0);
  for (std::size_t v = 0; v < model.NumSupportVectors(); ++v) {
    std::copy_n(model.support_vectors.data() + v * old_p, old_p, vectors.data() + v * p);
  }
  model.support_vectors = std::move(vectors);
  model.feature_mean.resize(p, 0.0);
  model.feature_scale.resize(p, 1.0);
  if (!names.columns.empty()) svm.names.columns = names.columns;
  if (!names.classes.empty()) svm.names.classes = names.classes;
  if (!names.label_column.empty()) svm.names.label_column = names.label_column;
}

}  // namespace handcraft::model_io
