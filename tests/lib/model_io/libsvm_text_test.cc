// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/libsvm_text.h"

#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/lib/runtime/c_interface.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::model_io {
namespace {

using handcraft::testing::Load;
using handcraft::testing::SomeSvm;
using handcraft::testing::SomeSvmNames;
using ::testing::HasSubstr;

const std::string kReferences = HANDCRAFT_SOURCE_DIR "/tests/data/trainers/svm_classes";

NamedSvm SomeNamedSvm() {
  NamedSvm svm{.model = SomeSvm(), .names = SomeSvmNames()};
  svm.model.feature_mean = {0.0, 0.0};
  svm.model.feature_scale = {1.0, 1.0};
  return svm;
}

TEST(ToLibsvmText, ByHand) {
  EXPECT_EQ(ToLibsvmText(SomeNamedSvm()),
            "svm_type c_svc\nkernel_type linear\nnr_class 3\ntotal_sv 3\nrho -0 -0 0.25\n"
            "label 0 1 2\nnr_sv 1 1 1\nSV\n1 1 1:1 \n-1 1 2:1 \n-1 -1 1:-1 2:-1 \n");
}

TEST(ToLibsvmText, KeepsLabelsThatAreNumbers) {
  NamedSvm svm = SomeNamedSvm();
  svm.names.classes = {"7", "-2", "3"};
  svm.model.similarity = {
      .type = features::SimilarityType::kPolynomial, .degree = 2, .gamma = 0.5, .coef0 = 1.0};
  EXPECT_THAT(ToLibsvmText(svm),
              HasSubstr("kernel_type polynomial\ndegree 2\ngamma 0.5\ncoef0 1\nnr_class 3\n"));
  EXPECT_THAT(ToLibsvmText(svm), HasSubstr("\nlabel 7 -2 3\n"));
}

TEST(ToLibsvmText, RefusesWhatItCannotHold) {
  NamedSvm svm{.model = SomeSvm(), .names = SomeSvmNames()};
  EXPECT_THROWS_MESSAGE(ToLibsvmText(svm), Error, HasSubstr("no place for the normaliser"));
  svm = SomeNamedSvm();
  svm.model.scheme = features::ClassScheme::kOneAgainstAll;
  EXPECT_THROWS_MESSAGE(ToLibsvmText(svm), Error, HasSubstr("this model is one against all"));
}

TEST(LibsvmText, ComesBackAsItWas) {
  for (const char* kernel : {"linear", "poly", "rbf"}) {
    const std::string path = kReferences + "_" + kernel + ".model";
    const NamedSvm svm = FromLibsvmText(ReadTextFile(path), path);
    EXPECT_EQ(svm.model.num_classes, 4U);
    EXPECT_EQ(svm.names.classes, (std::vector<std::string>{"7", "-2", "3", "11"}));
    const std::string text = ToLibsvmText(svm);
    const NamedSvm again = FromLibsvmText(text, "memory");
    EXPECT_EQ(again.model.support_vectors, svm.model.support_vectors);
    EXPECT_EQ(again.model.dual_coefficients, svm.model.dual_coefficients);
    EXPECT_EQ(again.model.machine_supports, svm.model.machine_supports);
    EXPECT_EQ(again.model.intercepts, svm.model.intercepts);
    EXPECT_EQ(ToLibsvmText(again), text);
  }
}

// Every row of the table by libsvm's model in our runtime: what svm-predict says.
TEST(FromLibsvmText, PredictsWhatLibsvmPredicts) {
  for (const char* kernel : {"linear", "poly", "rbf"}) {
    const std::string path = kReferences + "_" + kernel + ".model";
    const NamedSvm svm = FromLibsvmText(ReadTextFile(path), path);
    const auto model = Load(MakeSvmModel(svm.model, svm.names, {}));
    hc_workspace* scratch = nullptr;
    ASSERT_EQ(hc_row_workspace_create(model.get(), &scratch), HC_OK);
    const handcraft::testing::Workspace workspace(scratch);
    std::istringstream table(ReadTextFile(kReferences + ".libsvm"));
    std::istringstream said(ReadTextFile(kReferences + "_" + kernel + ".labels"));
    int num_rows = 0;
    for (std::string line; std::getline(table, line); ++num_rows) {
      std::istringstream words(line);
      std::string word;
      words >> word;
      double row[4] = {};
      while (words >> word) {
        row[std::stoul(word) - 1] = std::stod(word.substr(word.find(':') + 1));
      }
      hc_class_prediction prediction{};
      ASSERT_EQ(hc_classify_row(model.get(), workspace.get(), row, 4, &prediction), HC_OK);
      said >> word;
      EXPECT_EQ(hc_model_class_name(model.get(), static_cast<std::size_t>(prediction.number)), word)
          << kernel << ' ' << line;
    }
    EXPECT_EQ(num_rows, 80);
  }
}

void ExpectRefused(const std::string& from, const std::string& to, const std::string& message) {
  std::string text = ToLibsvmText(SomeNamedSvm());
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  EXPECT_THROWS_MESSAGE(FromLibsvmText(text, "m.model"), Error, HasSubstr(message));
}

TEST(FromLibsvmText, NamesTheLineOfWhatIsWrong) {
  EXPECT_THROWS_MESSAGE(
      FromLibsvmText("", "m.model"), Error, HasSubstr("the line 'SV' is missing"));
  ExpectRefused("c_svc", "epsilon_svr", "svm_type epsilon_svr is no classifier");
  ExpectRefused("linear", "sigmoid", "kernel_type sigmoid: linear, polynomial or rbf is due");
  ExpectRefused("linear", "rbf", "'gamma' with 1 values is missing");
  ExpectRefused("nr_class 3", "nr_class 1", "nr_class is 1; 2 to 4096 is due");
  ExpectRefused("label 0 1 2", "label 0 1", "'label' with 3 values is missing");
  ExpectRefused("rho -0 -0", "rho x -0", "'x' is no number here");
  ExpectRefused("nr_sv 1 1 1", "nr_sv 1 1 2", "the file ends before its last support vector");
  ExpectRefused("-1 1 2:1", "-1", "m.model:10: 2 coefficients are due");
  ExpectRefused("-1 1 2:1", "-1 1 0:1", "an index is a number from 1");
  ExpectRefused("-1 1 2:1", "-1 1 2", "'' is no number here");
  ExpectRefused("-1 1 2:1", "-1 nan 2:1", "'nan' is not finite");
}

}  // namespace
}  // namespace handcraft::model_io
