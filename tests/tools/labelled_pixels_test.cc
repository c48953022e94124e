// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/labelled_pixels.h"

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"
#include "tests/tools/support/generated_data.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;

class LabelledPixelsTest : public testing::ImageSetTest {
 protected:
  LabelledPixelsOptions Parse(const std::string& line) {
    CLI::App app;
    LabelledPixelsOptions options;
    AddLabelledPixelsOptions(app, options);
    app.parse(set_.string() + " " + line);
    RefuseUnreadOptions(app, options);
    return options;
  }
  LabelledPixels Draw(const LabelledPixelsOptions& options) {
    return DrawLabelledPixels(
        options, datasets::ReadLabelledImageSet(options.dataset), {.out = out_, .err = err_});
  }

  std::ostringstream out_;
  std::ostringstream err_;
};

TEST_F(LabelledPixelsTest, DrawsWhatTheOptionsSay) {
  const LabelledPixels pixels = Draw(
      Parse("--features edges54 --split test --samples 90 --bad-per-good 2 --seed 3 --threads 1"));
  EXPECT_EQ(pixels.spec.NumFeatures(), 54);
  EXPECT_EQ(pixels.set.items.size(), 2U);
  EXPECT_EQ(pixels.num_images, 2U);
  EXPECT_EQ(pixels.samples.num_samples(), 90U);
  EXPECT_EQ(pixels.samples.features.size(), 90U * 54U);
  EXPECT_EQ(std::count(pixels.samples.labels.begin(), pixels.samples.labels.end(), 1), 30);
  EXPECT_EQ(err_.str(), "");
}

TEST_F(LabelledPixelsTest, WarnsOfFewerSamplesThanAskedFor) {
  const LabelledPixels pixels = Draw(Parse("--features edges54 --samples 1000000"));
  EXPECT_THAT(err_.str(),
              HasSubstr("1000000 samples were asked for; the images give " +
                        std::to_string(pixels.samples.num_samples())));
}

TEST_F(LabelledPixelsTest, RefusesRatiosWhereEveryPixelIsTaken) {
  EXPECT_THROWS_MESSAGE(Parse("--samples 0 --hard-negatives 0.5"),
                        Error,
                        HasSubstr("--hard-negatives says which pixels to draw"));
}

}  // namespace
}  // namespace handcraft::tools
