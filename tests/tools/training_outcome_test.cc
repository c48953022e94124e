// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/training_outcome.h"

#include <sstream>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::tools {
namespace {

using logistic::Termination;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class TrainingOutcome : public ::testing::Test {
 protected:
  static logistic::Summary Ended(Termination termination) {
    logistic::Summary summary;
    summary.termination = termination;
    summary.message = "the trainer's words";
    summary.advice = "set a ridge";
    return summary;
  }

  std::ostringstream out_;
  std::ostringstream err_;
  const Console console_{out_, err_};
};

TEST_F(TrainingOutcome, TakesAConvergedModelInSilence) {
  RequireUsable(Ended(Termination::kConverged), {}, console_);
  EXPECT_EQ(err_.str(), "");
}

TEST_F(TrainingOutcome, NamesRedundantFeatures) {
  logistic::Summary summary = Ended(Termination::kRankDeficient);
  summary.aliased_features = {1, 2};
  RequireUsable(summary, {"a", "b", "c"}, console_);
  EXPECT_EQ(err_.str(),
            "handcraft: warning: rank deficient: weights of redundant features are left at 0: "
            "b, c\n");
}

TEST_F(TrainingOutcome, CutsALongListOfNames) {
  logistic::Summary summary = Ended(Termination::kRankDeficient);
  summary.aliased_features = {0, 1, 2, 3, 4, 5, 6};
  RequireUsable(summary, {"a", "b", "c", "d", "e", "f", "g"}, console_);
  EXPECT_THAT(err_.str(), HasSubstr("a, b, c, d, e and 2 more"));
}

TEST_F(TrainingOutcome, RefusesWhatIsNoOptimum) {
  for (const Termination termination : {Termination::kNotRun,
                                        Termination::kSeparated,
                                        Termination::kIterationLimit,
                                        Termination::kNumericalFailure}) {
    EXPECT_FALSE(IsUsable(Ended(termination)));
    EXPECT_THROWS_MESSAGE(RequireUsable(Ended(termination), {}, console_),
                          Error,
                          AllOf(HasSubstr("no model: the trainer's words"),
                                HasSubstr("--ridge"),
                                Not(HasSubstr("set a ridge"))));
    try {
      RequireUsable(Ended(termination), {}, console_);
    } catch (const Error& error) {
      EXPECT_EQ(error.details().kind, Error::Kind::kNoResult);
    }
  }
}

}  // namespace
}  // namespace handcraft::tools
