// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "datasets/formats/csv_records.h"
#include "datasets/formats/npy.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/utf8.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/labelled_pixels.h"

namespace handcraft::tools {
namespace {

struct DataExportOptions {
  LabelledPixelsOptions pixels;
  std::string out;
  bool json = false;
};

// One line a sample: its features, then its label.
std::string CsvText(const LabelledPixels& pixels) {
  std::string text;
  for (int i = 0; i < pixels.spec.NumFeatures(); ++i) {
    text += datasets::CsvField(features::FeatureName(pixels.spec, i)) + ',';
  }
  text += "label\n";
  const datasets::GraspPointSamples& samples = pixels.samples;
  for (std::size_t row = 0; row < samples.num_samples(); ++row) {
    const float* const values = samples.features.data() + row * samples.num_features;
    for (std::size_t j = 0; j < samples.num_features; ++j) text += NumberToText(values[j]) + ',';
    text += samples.labels[row] != 0 ? "1\n" : "0\n";
  }
  return text;
}

void WriteAsNpy(const std::filesystem::path& path, const datasets::GraspPointSamples& samples) {
  const std::size_t num_columns = samples.num_features + 1;
  std::vector<float> table;
  table.reserve(samples.num_samples() * num_columns);
  for (std::size_t row = 0; row < samples.num_samples(); ++row) {
    const float* const values = samples.features.data() + row * samples.num_features;
    table.insert(table.end(), values, values + samples.num_features);
    table.push_back(samples.labels[row]);
  }
  datasets::WriteNpy(path, table.data(), samples.num_samples(), num_columns);
}

void RunDataExport(const DataExportOptions& options, const Console& console) {
  const std::string extension = std::filesystem::path(options.out).extension().string();
  if (extension != ".csv" && extension != ".npy") {
    throw Error({.kind = Error::Kind::kUsage,
                 .path = options.out,
                 .reason = "--out must end in .csv or .npy: that says which format is written"});
  }
  RequireWritable(options.out);
  const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(options.pixels.dataset);
  RequireNotAnInput(options.out, FilesOf(set));
  const LabelledPixels pixels = DrawLabelledPixels(options.pixels, set, console);
  if (extension == ".npy") {
    WriteAsNpy(options.out, pixels.samples);
  } else {
    WriteFileAtomically(options.out, CsvText(pixels));
  }
  const std::size_t num_samples = pixels.samples.num_samples();
  if (options.json) {
    console.Print({{"table", options.out},
                   {"features", features::ToString(pixels.spec)},
                   {"num_features", pixels.spec.NumFeatures()},
                   {"num_images", pixels.num_images},
                   {"num_samples", num_samples}});
  } else {
    console.out << "Wrote " << num_samples << " samples with " << pixels.spec.NumFeatures()
                << " features and a label to " << OnOneLine(options.out) << '\n';
  }
}

}  // namespace

void AddDataExport(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<DataExportOptions>();
  CLI::App* command = parent.add_subcommand(
      "export", "Write labelled pixels as a table of features, for other programs to read");
  AddLabelledPixelsOptions(*command, options->pixels);
  command->add_option("--out", options->out, "Table to write, .csv or .npy; the label comes last")
      ->type_name("FILE")
      ->required();
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft data export datasets/samples/cornell_mini --out samples.npy");
  command->callback([options, command, &console] {
    RefuseUnreadOptions(*command, options->pixels);
    RunDataExport(*options, console);
  });
}

}  // namespace handcraft::tools
