// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/evaluation/grasp_point_evaluation.h"
#include "experiments/evaluation/json_text.h"
#include "experiments/evaluation/loaded_model.h"
#include "experiments/evaluation/runtime_scoring.h"
#include "experiments/evaluation/table_model.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"
#include "lib/perception/overlay.h"
#include "tools/cloud_commands.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/output_folder.h"
#include "tools/progress_bar.h"
#include "tools/search_input.h"
#include "tools/table_prediction.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kPointsEnding = ".grasp_points.json";
constexpr const char* kOverlayEnding = ".grasp_points.png";
constexpr const char* kTableEnding = ".probabilities.csv";
constexpr const char* kClassesEnding = ".classes.csv";
constexpr const char* kObjectEnding = ".object_class.json";

struct PredictOptions {
  std::string model;
  std::vector<std::string> inputs;
  std::string out;
  int top = 15;
  double min_probability = 0.9;
  int suppression_radius_px = 8;
  bool json = false;
  SearchInput search;
  std::string object_mask;                   // read by models of object classes alone
  std::vector<std::string> picture_options;  // given, and read by grasp-point models alone
};

Json PointsJson(const std::string& path, const Image& image, const std::vector<hc_point>& points) {
  Json json = {{"image", path},
               {"width_px", image.width()},
               {"height_px", image.height()},
               {"grasp_points", Json::array()}};
  for (const hc_point& point : points) {
    json["grasp_points"].push_back(
        {{"u_px", point.u},
         {"v_px", point.v},
         {"probability", experiments::ShortestDouble(point.probability)}});
  }
  return json;
}

// <stem>.<ending>, the name of what is written beside others about an input.
std::string OutputName(const std::string& input, const char* ending) {
  return fs::path(input).stem().string() + ending;
}

// What was found in one picture.
struct Prediction {
  Image image;
  std::optional<perception::SearchRegion> region;  // where it was looked for; none: everywhere
  FloatImage probabilities;
  std::vector<hc_point> points;
};

// What to look at when there is no region.
std::string RemedyOf(perception::SearchState state, const SearchInput& search) {
  if (state != perception::SearchState::kNoPoints) {
    return "look at --up, --up-angle, --table-distance and --cloud-unit, or leave the depth out";
  }
  if (search.right.empty()) return "give depth in which something was measured, or leave it out";
  return "look at the order of the pair, which must be rectified, and at --camera, or leave "
         "--right "
         "out";
}

// The region of the picture that stands on a table. Throws Error(kNoResult) when there is none.
perception::SearchRegion FindRegion(const SearchInput& search,
                                    const std::string& path,
                                    const Image& image) {
  std::optional<perception::SearchStage> matching;
  const datasets::OrganisedCloud cloud = CloudFor(search, image, &matching);
  perception::SearchRegion region =
      perception::SearchRegionFinder(RegionOptions(search)).Find(image, cloud.View());
  if (matching) region.stages.insert(region.stages.begin() + 1, *matching);  // after "picture"
  if (region.HasRegion()) return region;
  throw Error({.kind = Error::Kind::kNoResult,
               .path = path,
               .reason = std::string(perception::MessageOf(region.state)),
               .remedy = RemedyOf(region.state, search)});
}

Prediction Predict(const hc_model* model, const std::string& path, const PredictOptions& options) {
  Prediction prediction{.image = perception::ReadImage(path),
                        .region = std::nullopt,
                        .probabilities = {},
                        .points = {}};
  if (options.search.IsGiven()) {
    prediction.region = FindRegion(options.search, path, prediction.image);
  }
  experiments::RuntimeScores scores = experiments::ScoreWithRuntime(
      model, prediction.image, path, prediction.region ? &prediction.region->mask : nullptr);
  if (prediction.region) {
    std::vector<perception::SearchStage>& stages = prediction.region->stages;
    stages.push_back(
        {.name = "scored", .num_pixels = stages.back().num_pixels, .time_ms = scores.score_ms});
  }
  prediction.probabilities = std::move(scores.probabilities);
  prediction.points = experiments::FindBestPixels(prediction.probabilities,
                                                  options.top,
                                                  options.min_probability,
                                                  options.suppression_radius_px);
  return prediction;
}

Image Overlay(const Prediction& prediction) {
  std::vector<perception::MarkedPoint> marks;
  marks.reserve(prediction.points.size());
  for (const hc_point& point : prediction.points) {
    marks.push_back({.u_px = point.u, .v_px = point.v, .probability = point.probability});
  }
  if (!prediction.region) {
    return perception::DrawGraspPoints(prediction.image, prediction.probabilities, marks);
  }
  return perception::DrawGraspPoints(
      perception::DrawRegion(prediction.image, prediction.region->mask),
      prediction.probabilities,
      marks);
}

// Scores one picture; writes what was found and an overlay when there is a folder, and adds the
// stages of the search to `stages`.
Json PredictImage(const hc_model* model,
                  const std::string& path,
                  const PredictOptions& options,
                  OutputFolder* folder,
                  std::string& stages) {
  const Prediction prediction = Predict(model, path, options);
  Json json = PointsJson(path, prediction.image, prediction.points);
  if (prediction.region) {
    json["search"] = SearchJson(*prediction.region);
    stages += SearchTable(*prediction.region);
    if (prediction.region->state != perception::SearchState::kFound) {
      stages += fmt::format("{}: {}\n", path, perception::MessageOf(prediction.region->state));
    }
  }
  if (folder != nullptr) {
    WriteFileAtomically(folder->Claim(OutputName(path, kPointsEnding)),
                        experiments::JsonText(json));
    perception::WritePng(folder->Claim(OutputName(path, kOverlayEnding)), Overlay(prediction));
  }
  return json;
}

void PrintPoints(const Console& console, const Json& predictions) {
  TextTable table({"image", "rank", "u [px]", "v [px]", "probability"});
  for (const Json& prediction : predictions) {
    const auto image = prediction["image"].get<std::string>();
    if (prediction["grasp_points"].empty()) table.AddRow({image, "-", "-", "-", "-"});
    int rank = 0;
    for (const Json& point : prediction["grasp_points"]) {
      table.AddRow({image,
                    std::to_string(++rank),
                    std::to_string(point["u_px"].get<int>()),
                    std::to_string(point["v_px"].get<int>()),
                    fmt::format("{:.4f}", point["probability"].get<double>())});
    }
  }
  console.out << table.ToText();
}

void PredictImages(const hc_model* model,
                   const PredictOptions& options,
                   const Console& console,
                   OutputFolder* folder) {
  ProgressBar bar(console);
  const Progress progress = bar.Callback();
  Json predictions = Json::array();
  std::string stages;
  bool found_any = false;
  for (const std::string& input : options.inputs) {
    Report(progress, "scoring", predictions.size(), options.inputs.size());
    predictions.push_back(PredictImage(model, input, options, folder, stages));
    found_any = found_any || !predictions.back()["grasp_points"].empty();
  }
  bar.Clear();
  if (folder != nullptr) folder->Keep();
  if (options.json) {
    console.Print({{"model", options.model}, {"predictions", predictions}});
  } else {
    PrintPoints(console, predictions);
    if (!stages.empty()) console.out << '\n' << stages;
  }
  if (!found_any) {
    throw Error(
        {.kind = Error::Kind::kNoResult,
         .reason = fmt::format("no grasp point above probability {}", options.min_probability),
         .remedy = "lower --min-probability"});
  }
}

const char* EndingOf(hc_kind kind) {
  if (kind == HC_KIND_OBJECT_CLASS) return kObjectEnding;
  return kind == HC_KIND_SVM ? kClassesEnding : kTableEnding;
}

void PredictTables(const hc_model* model,
                   const PredictOptions& options,
                   const Console& console,
                   OutputFolder* folder) {
  const experiments::TableModel table_model = experiments::ReadTableModel(options.model);
  const hc_kind kind = hc_model_kind(model);
  Json predictions = Json::array();
  std::string text;
  for (const std::string& input : options.inputs) {
    const auto [json, csv] =
        PredictTable(model, table_model, experiments::ReadTableFor(table_model, input));
    predictions.push_back({{"table", input}});
    predictions.back().update(json);
    if (folder != nullptr) {
      WriteFileAtomically(folder->Claim(OutputName(input, EndingOf(kind))), csv);
    } else {
      text += csv;
    }
  }
  if (folder != nullptr) folder->Keep();
  if (options.json) {
    console.Print({{"model", options.model}, {"predictions", predictions}});
  } else {
    console.out << text;
  }
}

void PredictObjectClasses(const hc_model* model,
                          const PredictOptions& options,
                          const Console& console,
                          OutputFolder* folder) {
  SearchInput search = options.search;
  search.cloud = "given";  // which way is up by default
  const Json predictions = PredictClouds(model,
                                         {.model = options.model,
                                          .clouds = options.inputs,
                                          .object_mask = options.object_mask,
                                          .table = RegionOptions(search).table});
  for (std::size_t i = 0; i < predictions.size() && folder != nullptr; ++i) {
    WriteFileAtomically(folder->Claim(OutputName(options.inputs[i], kObjectEnding)),
                        experiments::JsonText(predictions[i]));
  }
  if (folder != nullptr) folder->Keep();
  if (options.json) return console.Print({{"model", options.model}, {"predictions", predictions}});
  console.out << CloudTable(predictions);
}

// Options that fit each other and the model.
void Validate(const PredictOptions& options, hc_kind kind) {
  if (kind == HC_KIND_OBJECT_CLASS) return;
  if (!options.object_mask.empty()) RefuseCloudOption("--object-mask");
  if (kind == HC_KIND_GRASP_POINT) return RequireSearchFits(options.search, options.inputs.size());
  RefusePictureOptions(options.picture_options);
  if (options.inputs.size() > 1 && options.out.empty() && !options.json) {
    throw Error({.kind = Error::Kind::kUsage, .reason = "several tables need --out or --json"});
  }
}

// Nothing that will be written is the model or one of the inputs.
void RequireInputsStay(const PredictOptions& options, hc_kind kind) {
  if (options.out.empty()) return;
  std::vector<fs::path> inputs(options.inputs.begin(), options.inputs.end());
  inputs.emplace_back(options.model);
  for (fs::path& file : options.search.Files()) inputs.push_back(std::move(file));
  const auto endings = kind == HC_KIND_GRASP_POINT
                           ? std::vector<const char*>{kPointsEnding, kOverlayEnding}
                           : std::vector<const char*>{EndingOf(kind)};
  for (const std::string& input : options.inputs) {
    for (const char* ending : endings) {
      RequireNotAnInput(fs::path(options.out) / OutputName(input, ending), inputs);
    }
  }
}

void RunPredict(const PredictOptions& options, const Console& console) {
  const experiments::LoadedModel model = experiments::LoadModel(options.model);
  const hc_kind kind = hc_model_kind(model.get());
  Validate(options, kind);
  RequireInputsStay(options, kind);
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  const auto predict = kind == HC_KIND_GRASP_POINT    ? PredictImages
                       : kind == HC_KIND_OBJECT_CLASS ? PredictObjectClasses
                                                      : PredictTables;
  predict(model.get(), options, console, folder ? &*folder : nullptr);
  if (folder && !options.json) console.out << "Written to " << options.out << '\n';
}

// The same figures as in `evaluate`, with the same rules.
void AddPictureOptions(CLI::App& command, PredictOptions& options) {
  AddNumber(command,
            "--top",
            options.top,
            TakenBy(&experiments::EvaluationOptions::best_pixels),
            "Grasp points a picture, at most")
      ->group(kPictureGroup);
  AddNumber(command,
            "--min-probability",
            options.min_probability,
            TakenBy(&experiments::EvaluationOptions::best_min_probability),
            "Only grasp points above this probability")
      ->group(kPictureGroup);
  AddNumber(command,
            "--suppression-radius",
            options.suppression_radius_px,
            TakenBy(&experiments::EvaluationOptions::suppression_radius_px),
            "Grasp points are farther apart than this [px]; 0: no suppression")
      ->group(kPictureGroup);
  AddSearchOptions(command, options.search);
  command
      .add_option("--object-mask",
                  options.object_mask,
                  "Picture that shows the object of a cloud; without, what stands on the table")
      ->type_name("FILE")
      ->group(kCloudGroup);
}

}  // namespace

void AddPredict(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<PredictOptions>();
  CLI::App* command = parent.add_subcommand(
      "predict", "Run a model with the robot's runtime on pictures, clouds or tables");
  command->add_option("MODEL", options->model, "Model file")->required();
  command->add_option("INPUT", options->inputs, "Pictures, clouds (.pcd), or tables (.csv, .npy)")
      ->required();
  command
      ->add_option("--out",
                   options->out,
                   "Folder for <picture>.grasp_points.json and .png, <table>.probabilities.csv or "
                   "<table>.classes.csv")
      ->type_name("DIR");
  AddPictureOptions(*command, *options);
  AddJsonFlag(*command, options->json);
  SetExample(*command,
             "handcraft predict out/demo/grasp_points.safetensors "
             "datasets/samples/cornell_mini/images/pcd0525r.png --out out/predictions");
  command->callback([options, command, &console] {
    options->picture_options = GivenOptions(*command, kPictureGroup);
    RunPredict(*options, console);
  });
}

}  // namespace handcraft::tools
