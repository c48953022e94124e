// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/object_class_options.h"

#include <gtest/gtest.h>

#include "lib/core/fields.h"

namespace handcraft::tools {
namespace {

experiments::ObjectClassOptions Parse(const std::string& line) {
  CLI::App app;
  experiments::ObjectClassOptions options;
  AddObjectClassOptions(app, options);
  app.parse(line);
  return options;
}

TEST(ObjectClassOptions, KeepTheDefaults) {
  EXPECT_EQ(FieldsToText(Parse("")), FieldsToText(experiments::ObjectClassOptions{}));
}

TEST(ObjectClassOptions, AreTaken) {
  const experiments::ObjectClassOptions options = Parse(
      "--descriptor depth-grid --grid-size 20 --box square --scaling unit --frame camera "
      "--outlier-step 3 --moved-copies 4 --folds 0 --kernel rbf");
  EXPECT_EQ(options.descriptor.type, features::CloudDescriptorType::kDepthGrid);
  EXPECT_EQ(options.descriptor.grid_size, 20);
  EXPECT_EQ(options.descriptor.box, features::GridBox::kSquare);
  EXPECT_EQ(options.descriptor.scaling, features::CloudScaling::kUnit);
  EXPECT_EQ(options.descriptor.frame, features::CloudFrame::kCamera);
  EXPECT_EQ(options.outlier_step, 3.0);
  EXPECT_EQ(options.moved.num_copies, 4);
  EXPECT_EQ(options.num_folds, 0);
  EXPECT_EQ(options.svm.kernel, features::SimilarityType::kRbf);
  using features::CloudDescriptorType;
  EXPECT_EQ(Parse("--descriptor polar").descriptor.type, CloudDescriptorType::kPolar);
  EXPECT_EQ(Parse("--descriptor vfh").descriptor.type, CloudDescriptorType::kViewpointHistogram);
  EXPECT_EQ(Parse("--descriptor esf").descriptor.type, CloudDescriptorType::kShapeFunctions);
}

TEST(ObjectClassOptions, RefuseWhatIsOutOfRange) {
  for (const char* line : {"--descriptor spin-image",
                           "--grid-size 0",
                           "--grid-size 129",
                           "--box round",
                           "--outlier-step -1",
                           "--moved-copies -1",
                           "--folds 1"}) {
    EXPECT_THROW(Parse(line), CLI::ParseError) << line;
  }
}

}  // namespace
}  // namespace handcraft::tools
