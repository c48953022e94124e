// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/cloud_figures.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/progress_bar.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using datasets::CloudFigures;

struct DataCloudsOptions {
  std::string folder;
  int num_threads = 1;
  bool json = false;
};

double ShareOf(std::size_t part, std::size_t all) {
  return all == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(all);
}

double ShareMeasured(const CloudFigures& figures) {
  return ShareOf(figures.num_measured, figures.num_pixels);
}

double ShareTextured(const CloudFigures& figures) {
  return ShareOf(figures.num_textured, figures.num_measured);
}

nlohmann::ordered_json ToJson(const CloudFigures& figures) {
  return {{"num_views", figures.num_views},
          {"num_pixels", figures.num_pixels},
          {"share_measured", ShareMeasured(figures)},
          {"median_error_m", figures.median_error_m},
          {"percentile90_error_m", figures.percentile90_error_m},
          {"share_beyond_20_mm", figures.share_beyond},
          {"share_textured", ShareTextured(figures)},
          {"textured_median_error_m", figures.textured_median_error_m}};
}

void PrintJson(const Console& console,
               const std::string& folder,
               const std::vector<CloudFigures>& figures) {
  nlohmann::ordered_json json{
      {"folder", folder}, {"all", ToJson(figures.back())}, {"classes", nlohmann::ordered_json()}};
  for (std::size_t i = 0; i + 1 < figures.size(); ++i) {
    json["classes"][figures[i].object_class] = ToJson(figures[i]);
  }
  console.Print(json);
}

void PrintTable(const Console& console, const std::vector<CloudFigures>& figures) {
  TextTable table({"class",
                   "views",
                   "measured",
                   "median",
                   "90 % within",
                   "beyond 20 mm",
                   "textured",
                   "median there"});
  for (const CloudFigures& row : figures) {
    const bool has_errors = row.num_measured > 0;
    const auto unless_none = [&](const std::string& text) {
      return has_errors ? text : std::string("-");
    };
    const std::string median_there =
        row.num_textured == 0 ? "-"
                              : fmt::format("{:.1f} mm", 1000.0 * row.textured_median_error_m);
    table.AddRow({row.object_class.empty() ? "all" : row.object_class,
                  std::to_string(row.num_views),
                  fmt::format("{:.1f} %", 100.0 * ShareMeasured(row)),
                  unless_none(fmt::format("{:.1f} mm", 1000.0 * row.median_error_m)),
                  unless_none(fmt::format("{:.1f} mm", 1000.0 * row.percentile90_error_m)),
                  unless_none(fmt::format("{:.1f} %", 100.0 * row.share_beyond)),
                  unless_none(fmt::format("{:.1f} %", 100.0 * ShareTextured(row))),
                  median_there});
  }
  console.out << table.ToText();
}

void RunDataClouds(const DataCloudsOptions& options, const Console& console) {
  const datasets::ViewSet set = datasets::ReadViewSet(options.folder);
  ProgressBar bar(console);
  const std::vector<CloudFigures> figures =
      datasets::CompareClouds(set, options.num_threads, bar.Callback());
  bar.Clear();
  if (options.json) {
    PrintJson(console, options.folder, figures);
  } else {
    PrintTable(console, figures);
  }
}

}  // namespace

void AddDataClouds(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataCloudsOptions>();
  CLI::App* command = parent.add_subcommand(
      "clouds", "Compare the measured clouds of a view set with its true depth, on the objects");
  command->add_option("DIR", options->folder, "Folder with views.csv")->required();
  AddThreadsOption(*command, options->num_threads);
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data clouds turntable");
  command->callback([options, &console] { RunDataClouds(*options, console); });
}

}  // namespace handcraft::tools
