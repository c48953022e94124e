// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_data.h"

#include <set>

#include <fmt/format.h>

#include "datasets/scaled_set.h"
#include "datasets/split_assignment.h"
#include "datasets/synthetic/grasp_point_set.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTrain = "train";
constexpr const char* kTest = "test";

datasets::LabelledImageSet Provide(const DataSource& source,
                                   const fs::path& made_folder,
                                   int num_threads,
                                   const Progress& progress) {
  if (!source.folder.empty()) return datasets::ReadLabelledImageSet(source.folder);
  fs::create_directories(made_folder.parent_path());
  return synthetic::MakeGraspPointSet(made_folder,
                                      {.family = synthetic::FamilyNamed(source.family),
                                       .num_images = source.num_images,
                                       .seed = source.seed,
                                       .num_threads = num_threads,
                                       .progress = progress})
      .set;
}

datasets::SplitGroup GroupOf(StudySplit split) {
  switch (split) {
    case StudySplit::kClass:
      return datasets::SplitGroup::kClass;
    case StudySplit::kPicture:
      return datasets::SplitGroup::kPicture;
    case StudySplit::kInstance:
    case StudySplit::kManifest:
      break;
  }
  return datasets::SplitGroup::kInstance;
}

// The pictures with their new splits; all to train on when the share is 1.
datasets::LabelledImageSet Divide(const Study& study,
                                  const datasets::LabelledImageSet& whole,
                                  const Cell& cell) {
  datasets::LabelledImageSet set = whole;
  const double share = cell.settings.training_share;
  if (share == 1.0) {
    for (datasets::LabelledImage& item : set.items) item.split = kTrain;
    return set;
  }
  datasets::AssignSplits(set,
                         {.shares = {{kTrain, share}, {kTest, 1.0 - share}},
                          .group = GroupOf(study.split),
                          .seed = cell.seed});
  return set;
}

// The sizes that any cell trains on, but the pictures' own.
std::set<double> OtherScales(const Study& study) {
  std::set<double> scales;
  for (const Cell& cell : MakeCells(study)) {
    scales.insert(cell.settings.training_scales.begin(), cell.settings.training_scales.end());
  }
  scales.erase(1.0);
  return scales;
}

// Those pictures of another size whose own are to be trained on.
datasets::LabelledImageSet PickTraining(const datasets::LabelledImageSet& divided,
                                        const datasets::LabelledImageSet& scaled) {
  datasets::LabelledImageSet picked{.root = scaled.root, .items = {}};
  for (std::size_t i = 0; i < divided.items.size(); ++i) {
    if (divided.items[i].split == kTrain) picked.items.push_back(scaled.items.at(i));
  }
  return picked;
}

}  // namespace

StudyData PrepareStudyData(const Study& study,
                           const fs::path& made_folder,
                           int num_threads,
                           const Progress& progress) {
  StudyData data;
  data.train = Provide(study.train, made_folder / kTrain, num_threads, progress);
  data.train_fingerprint = datasets::Fingerprint(data.train);
  for (const double scale : OtherScales(study)) {
    data.scaled[scale] =
        datasets::ProvideScaledSet(data.train,
                                   scale,
                                   made_folder / fmt::format("{}_{}", kTrain, scale),
                                   num_threads,
                                   progress);
  }
  if (study.test) {
    data.test = Provide(*study.test, made_folder / kTest, num_threads, progress);
    data.test_fingerprint = datasets::Fingerprint(*data.test);
  }
  return data;
}

CellData DivideForCell(const Study& study, const StudyData& data, const Cell& cell) {
  const datasets::LabelledImageSet divided =
      study.split == StudySplit::kManifest ? data.train : Divide(study, data.train, cell);
  CellData cell_data{.train = {}, .test = data.test ? *data.test : divided.Only(kTest)};
  for (const double scale : cell.settings.training_scales) {
    cell_data.train.push_back(scale == 1.0 ? divided.Only(kTrain)
                                           : PickTraining(divided, data.scaled.at(scale)));
  }
  return cell_data;
}

}  // namespace handcraft::experiments
