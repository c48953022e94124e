// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/report_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const ReportTable kTable{.head = {"name", "value"}, .rows = {{"a,b", "1"}, {"say \"c\"", "<2"}}};

TEST(ReportTable, AsCsvQuotesWhatWouldBeMisread) {
  EXPECT_EQ(CsvText(kTable), "name,value\n\"a,b\",1\n\"say \"\"c\"\"\",<2\n");
}

TEST(ReportTable, AsMarkdown) {
  EXPECT_EQ(MarkdownText(kTable),
            "| name | value |\n|---|---|\n| a,b | 1 |\n| say \"c\" | <2 |\n\n");
}

TEST(ReportTable, AsHtmlEscapesItsCells) {
  EXPECT_THAT(HtmlText(kTable),
              AllOf(HasSubstr("<th>name</th><th class=\"number\">value</th>"),
                    HasSubstr("<th>say &quot;c&quot;</th><td class=\"number\">&lt;2</td>")));
}

TEST(ReportTable, AsHtmlPutsIntervalsBelowTheirValues) {
  EXPECT_THAT(
      HtmlText({.head = {"right_of"}, .rows = {{"mug", "61.7 [55.4, 67.6] of 240", "[1]"}}}),
      AllOf(HasSubstr("<th>right_<wbr>of</th>"),
            HasSubstr(">61.7<span class=\"range\">[55.4, 67.6] of 240</span></td>"),
            HasSubstr(">[1]</td>")));
}

TEST(ReportTable, WithoutRowsIsItsHead) {
  EXPECT_EQ(CsvText({.head = {"a"}}), "a\n");
  EXPECT_EQ(MarkdownText({.head = {"a"}}), "| a |\n|---|\n\n");
}

}  // namespace
}  // namespace handcraft::experiments
