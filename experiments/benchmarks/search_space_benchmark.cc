// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "datasets/formats/organised_cloud.h"
#include "datasets/synthetic/measured_view.h"
#include "datasets/synthetic/object_classes.h"
#include "datasets/synthetic/scene.h"
#include "experiments/benchmarks/benchmark.h"
#include "experiments/benchmarks/opencv_scorers.h"
#include "experiments/benchmarks/pcl_table_peer.h"
#include "lib/core/check.h"
#include "lib/core/rng.h"
#include "lib/model_io/linear_models.h"
#include "lib/perception/search_region.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRealClouds = "../shared/data/pointclouds_pcl/segmentation/mOSD";

// Mean processor time of a call [ms], after one that is not counted: what other work on the machine
// does not lengthen.
double ProcessorMs(int repetitions, const std::function<void()>& call) {
  call();
  const std::clock_t start = std::clock();
  for (int i = 0; i < repetitions; ++i) call();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / repetitions;
}

// A mug on a table as a depth camera takes it, 640 × 480.
synthetic::MeasuredView MakeFrame() {
  Rng rng = Rng::Stream(1, "search_space_benchmark");
  const auto classes = synthetic::ClassesOf(synthetic::Family::kTrained);
  const auto mug = std::find_if(
      classes.begin(), classes.end(), [](const auto& kind) { return kind.name == "mug"; });
  const std::vector<synthetic::Object> targets = {mug->draw(rng)};
  return synthetic::MeasureView(synthetic::DrawScene(targets, rng),
                                synthetic::CloudSensor::kDepthCamera,
                                0.12F,
                                1,
                                "search_space_benchmark");
}

// Hypothesis 2 with random weights, in a loaded model: the time depends on neither.
class RuntimeScorer {
 public:
  RuntimeScorer(int width, int height) : map_(width, height) {
    Rng rng = Rng::Stream(1, "search_space_weights");
    model_io::LinearModel linear;
    for (int i = 0; i < spec_.NumFeatures(); ++i) {
      linear.weights.push_back(0.02 * rng.Normal());
      linear.feature_mean.push_back(0.0);
      linear.feature_scale.push_back(1.0);
    }
    weights_.assign(linear.weights.begin(), linear.weights.end());
    model_io::Provenance provenance;
    provenance.name = "search space benchmark";
    provenance.task = "grasp_point";
    const std::vector<std::uint8_t> bytes =
        model_io::Serialise(model_io::MakeGraspPointModel(spec_, linear, provenance));
    hc_error error{};
    hc_model* model = nullptr;
    HC_CHECK(hc_model_load_memory(bytes.data(), bytes.size(), &model, &error) == HC_OK,
             error.message);
    model_.reset(model);
    hc_workspace* workspace = nullptr;
    HC_CHECK(hc_workspace_create(model, width, height, &workspace) == HC_OK, width, height);
    workspace_.reset(workspace);
  }

  // The ranked grasp points of a region.
  void Rank(const Image& image, const Image& mask) {
    const std::int64_t width = image.width();
    const hc_image view{image.values().data(), image.width(), image.height(), 3 * width, HC_BGR8};
    const hc_status scored = hc_score_mask(
        model_.get(), workspace_.get(), &view, mask.values().data(), width, map_.Row(0), width);
    HC_CHECK(scored == HC_OK, hc_status_message(scored));
    RankMap(map_);
  }

  static void RankMap(const FloatImage& map) {
    std::array<hc_point, 15> points{};
    std::size_t count = points.size();
    const hc_status ranked = hc_top_k(map.values().data(),
                                      map.width(),
                                      map.height(),
                                      map.width(),
                                      0.0F,
                                      8,
                                      points.data(),
                                      &count);
    HC_CHECK(ranked == HC_OK, hc_status_message(ranked));
  }

  [[nodiscard]] const features::FeatureSpec& spec() const { return spec_; }
  [[nodiscard]] const std::vector<float>& weights() const { return weights_; }

 private:
  struct Free {
    void operator()(hc_model* model) const { hc_model_free(model); }
    void operator()(hc_workspace* workspace) const { hc_workspace_free(workspace); }
  };
  features::FeatureSpec spec_ = features::ParseFeatureSpec("window180");
  std::vector<float> weights_;
  std::unique_ptr<hc_model, Free> model_;
  std::unique_ptr<hc_workspace, Free> workspace_;
  FloatImage map_;
};

// Points of these pixels within the quartile fences, by sorting.
std::vector<std::int32_t> WithoutOutliers(const perception::CloudView& cloud,
                                          const std::vector<std::int32_t>& pixels) {
  std::vector<std::int32_t> kept = pixels;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = [&](std::int32_t pixel) {
      return cloud.points[static_cast<std::size_t>(pixel)][axis];
    };
    std::vector<float> values(pixels.size());
    std::transform(pixels.begin(), pixels.end(), values.begin(), at);
    std::sort(values.begin(), values.end());
    if (values.empty()) return {};
    const float q1 = values[values.size() / 4];
    const float q3 = values[3 * values.size() / 4];
    const float step = 1.5F * (q3 - q1);
    std::erase_if(kept, [&](std::int32_t p) { return at(p) < q1 - step || at(p) > q3 + step; });
  }
  return kept;
}

// The peer's chain: PCL's plane, quartiles, OpenCV's box, edges, dilation and convolutions.
void RankLikePeer(const Image& image,
                  const perception::CloudView& cloud,
                  const PclTablePeer& peer,
                  const perception::TableRemovalOptions& options,
                  const RuntimeScorer& scorer) {
  const std::vector<std::int32_t> kept = WithoutOutliers(cloud, peer.PixelsOffTable(options));
  std::vector<cv::Point> object;
  object.reserve(kept.size());
  for (const std::int32_t pixel : kept) {
    object.emplace_back(pixel % cloud.width, pixel / cloud.width);
  }
  const cv::Rect crop = cv::boundingRect(object);
  const cv::Mat picture(
      image.height(), image.width(), CV_8UC3, const_cast<std::uint8_t*>(image.values().data()));
  Image gray(crop.width, crop.height);
  cv::Mat gray_mat(crop.height, crop.width, CV_8U, gray.Row(0));
  cv::cvtColor(picture(crop), gray_mat, cv::COLOR_BGR2GRAY);
  cv::Mat region;
  cv::Canny(gray_mat, region, 50.0, 150.0);
  cv::dilate(region, region, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));
  FloatImage map = ScoreByConvolutions(gray, scorer.spec(), scorer.weights(), 0.1F);
  cv::Mat(crop.height, crop.width, CV_32F, map.Row(0)).setTo(0.0, region == 0);
  RuntimeScorer::RankMap(map);
}

// Points left and processor time of the two steps on clouds, ours and the peer's; sums over clouds.
struct CloudFigures {
  int num_clouds = 0;
  double ours_ms = 0.0;
  double peer_ms = 0.0;
  double ours_points = 0.0;
  double peer_points = 0.0;
  double both_points = 0.0;
};

void MeasureCloud(const perception::CloudView& cloud,
                  const perception::TableRemovalOptions& options,
                  int repetitions,
                  CloudFigures& figures) {
  perception::PixelPoints points;
  figures.ours_ms += ProcessorMs(repetitions, [&] {
    const perception::TablePlanes table = perception::FindTable(cloud, options);
    perception::TakePointsOffPlanes(cloud, table.planes, options.epsilon_m, points);
    perception::RemoveOutliers(points, {});
  });
  ++figures.num_clouds;
  figures.ours_points += static_cast<double>(points.size());
  if (!PclTablePeer::IsAvailable()) return;
  const PclTablePeer peer(cloud);
  std::vector<std::int32_t> kept;
  figures.peer_ms += ProcessorMs(std::max(1, repetitions / 5), [&] {
    kept = WithoutOutliers(cloud, peer.PixelsOffTable(options));
  });
  figures.peer_points += static_cast<double>(kept.size());
  std::vector<std::int32_t> both;
  std::set_intersection(kept.begin(),
                        kept.end(),
                        points.Pixels().begin(),
                        points.Pixels().end(),
                        std::back_inserter(both));
  figures.both_points += static_cast<double>(both.size());
}

// Means a cloud. The peer's are left out where there is none.
void Tell(const std::string& prefix, const CloudFigures& figures, BenchmarkResult& result) {
  if (figures.num_clouds == 0) return;
  const double count = figures.num_clouds;
  result.details[prefix + "_clouds"] = count;
  result.details[prefix + "_ours_processor_ms"] = figures.ours_ms / count;
  result.details[prefix + "_ours_points"] = figures.ours_points / count;
  if (!PclTablePeer::IsAvailable()) return;
  result.details[prefix + "_pcl_processor_ms"] = figures.peer_ms / count;
  result.details[prefix + "_pcl_points"] = figures.peer_points / count;
  result.details[prefix + "_both_points"] = figures.both_points / count;
}

// The organised clouds of the folder, in the order of their paths; none when it is not there.
std::vector<fs::path> RealClouds() {
  std::vector<fs::path> files;
  if (!fs::is_directory(kRealClouds)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(kRealClouds)) {
    if (entry.path().extension() == ".pcd") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void TellClouds(const perception::CloudView& made_cloud, int repetitions, BenchmarkResult& result) {
  CloudFigures made;
  MeasureCloud(made_cloud, {}, repetitions, made);
  Tell("made", made, result);
  CloudFigures real;
  // A camera that looks down by about 35°, with the cloud in its own frame.
  const perception::TableRemovalOptions kinect{.up = {0.0F, -0.8F, -0.6F}, .max_angle_rad = 0.26F};
  for (const fs::path& file : RealClouds()) {
    const datasets::OrganisedCloud found = datasets::ReadPcd(file);
    MeasureCloud(found.View(), kinect, repetitions, real);
  }
  Tell("real", real, result);
}

}  // namespace

BenchmarkResult BenchmarkSearchSpaceVga(const BenchmarkOptions& options) {
  const synthetic::MeasuredView frame = MakeFrame();
  const perception::CloudView cloud = frame.cloud.View();
  RuntimeScorer scorer(cloud.width, cloud.height);
  perception::SearchRegionFinder finder({});
  perception::SearchRegion region;
  const int previous_threads = cv::getNumThreads();
  cv::setNumThreads(1);
  BenchmarkResult result;
  result.dissertation_ms = 172.0;  // Table 3.1 without the acquisition
  result.peer = "PCL SACSegmentation, OpenCV Canny and convolutions";
  const auto rank = [&] {
    region = finder.Find(frame.image, cloud);
    scorer.Rank(frame.image, region.mask);
  };
  result.ours_ms = MedianMs(options.repetitions, rank);
  result.details["ours_processor_ms"] = ProcessorMs(options.repetitions, rank);
  result.peer_ms = std::numeric_limits<double>::quiet_NaN();
  if (PclTablePeer::IsAvailable()) {
    const PclTablePeer peer(cloud);
    const auto rank_like_peer = [&] { RankLikePeer(frame.image, cloud, peer, {}, scorer); };
    const int repetitions = std::max(1, options.repetitions / 5);
    result.peer_ms = MedianMs(repetitions, rank_like_peer);
    result.details["peer_processor_ms"] = ProcessorMs(repetitions, rank_like_peer);
  } else {
    result.peer += " (not in this build)";
  }
  result.ratio = result.peer_ms / result.ours_ms;
  for (const perception::SearchStage& stage : region.stages) {
    std::string name = "pixels_" + std::string(stage.name);
    std::replace(name.begin(), name.end(), ' ', '_');
    result.details[name] = static_cast<double>(stage.num_pixels);
  }
  TellClouds(cloud, options.repetitions, result);
  cv::setNumThreads(previous_threads);
  return result;
}

}  // namespace handcraft::experiments
