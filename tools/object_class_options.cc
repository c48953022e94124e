// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/object_class_options.h"

#include <algorithm>
#include <string>
#include <vector>

#include "tools/number_option.h"
#include "tools/svm_options.h"

namespace handcraft::tools {
namespace {

using experiments::ObjectClassOptions;

constexpr const char* kGroup = "Clouds";

// An option for one of several values that NameOf names.
template <class T>
void AddNamed(CLI::App& command,
              const std::string& name,
              T& value,
              const std::vector<T>& choices,
              const std::string& description) {
  std::vector<std::string> words;
  words.reserve(choices.size());
  for (const T choice : choices) words.emplace_back(features::NameOf(choice));
  command
      .add_option_function<std::string>(
          name,
          [&value, choices](const std::string& word) {
            value = *std::find_if(choices.begin(), choices.end(), [&word](T choice) {
              return features::NameOf(choice) == word;
            });
          },
          description)
      ->check(CLI::IsMember(words))
      ->type_name("WORD")
      ->default_str(std::string(features::NameOf(value)))
      ->group(kGroup);
}

// What an object is described by.
void AddDescriptorOptions(CLI::App& command, features::CloudDescriptor& descriptor) {
  using features::CloudDescriptorType;
  AddNamed<CloudDescriptorType>(command,
                                "--descriptor",
                                descriptor.type,
                                {CloudDescriptorType::kGrid,
                                 CloudDescriptorType::kDepthGrid,
                                 CloudDescriptorType::kPolar,
                                 CloudDescriptorType::kViewpointHistogram,
                                 CloudDescriptorType::kShapeFunctions},
                                "Mean points of a grid's cells, their depths alone, or mean points "
                                "of rings and sectors; of a "
                                "grid's mean points the viewpoint feature histogram (with --frame "
                                "camera) or shape functions");
  AddNumber(command,
            "--grid-size",
            descriptor.grid_size,
            IntegerWithin(1, features::kMaxGridSize),
            "Cells along each side")
      ->group(kGroup);
  AddNamed<features::GridBox>(command,
                              "--box",
                              descriptor.box,
                              {features::GridBox::kFitted, features::GridBox::kSquare},
                              "The grid divides the object's box, or a square around it");
  AddNamed<features::CloudScaling>(command,
                                   "--scaling",
                                   descriptor.scaling,
                                   {features::CloudScaling::kMetric, features::CloudScaling::kUnit},
                                   "Metres, or divided by the points' spread");
  AddNamed<features::CloudFrame>(command,
                                 "--frame",
                                 descriptor.frame,
                                 {features::CloudFrame::kBase, features::CloudFrame::kCamera},
                                 "Frame of the coordinates");
}

}  // namespace

void AddObjectClassOptions(CLI::App& command, ObjectClassOptions& options) {
  AddDescriptorOptions(command, options.descriptor);
  AddNumber(command,
            "--outlier-step",
            options,
            &ObjectClassOptions::outlier_step,
            "Points farther beyond the quartiles go, in interquartile ranges; 0: none")
      ->group(kGroup);
  AddNumber(command,
            "--moved-copies",
            options.moved,
            &datasets::MovedCopyOptions::num_copies,
            "Copies of each view, moved and scaled at random, to train on besides")
      ->group(kGroup);
  AddNumber(command,
            "--folds",
            options,
            &ObjectClassOptions::num_folds,
            "Of cross-validation, neighbouring views together; 0: none, -1: each view alone");
  AddSvmOptions(command, options.svm);
}

}  // namespace handcraft::tools
