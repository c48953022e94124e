// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "datasets/formats/fault.h"
#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/organised_cloud.h"
#include "datasets/importers/grasp_mask.h"
#include "lib/core/image.h"
#include "lib/core/progress.h"

/// What all importers share. An importer lists the pictures of a foreign format and knows how to
/// make the mask of each; thinning, splitting, copying and the manifest are done here, once.
namespace handcraft::datasets {

/// A picture as an importer found it.
struct SourcePicture {
  std::filesystem::path path = {};  ///< its file; of an embedded picture the file that holds it
  std::string image = {};           ///< its path below images/ in the set
  std::string mask = {};            ///< the path of its mask below masks/, ends in .png
  std::string object_class = "object";
  std::string instance = {};                 ///< which physical object it shows
  std::optional<int> number = std::nullopt;  ///< in the order of taking, where that is known
  std::string split = {};                    ///< filled by the import
  /// Of a view: the object is turned by so much about z, in [0, 360).
  std::optional<double> angle_deg = std::nullopt;
  /// Its mask, given the size of the picture. Called once, from any thread.
  std::function<Image(int width, int height)> make_mask = {};
  /// What is worth knowing about its labels, given the size of the picture; empty: nothing.
  std::function<std::vector<Fault>(int width, int height)> find_notes = {};
  /// The bytes of an embedded picture; empty: those of `path`.
  std::function<std::vector<std::uint8_t>()> embedded = {};
  /// A picture that is no file, such as a part of one; empty: there is a file. It may return an
  /// empty Image for a view in which no object is seen.
  std::function<Image()> make_image = {};
  /// Its cloud, given the size of the picture; empty: none.
  std::function<OrganisedCloud(int width, int height)> make_cloud = {};
  /// The grasp rectangles that its mask was made of; empty: none.
  std::function<MarkedRectangles()> read_rectangles = {};
};

/// What a source holds.
struct SourceSet {
  std::vector<SourcePicture> pictures;
  int split_gap = 0;  ///< training pictures whose number is less than this below the first of the
                      ///< test are left out, for neighbours show the same object
  std::vector<Fault> notes = {};  ///< what it lacks, and hence what is left out
};

/// Options of every importer.
struct ImportOptions {
  double test_share = 1.0 / 3.0;  ///< share of the instances put into "test"; [0, 1)
  int max_images = 0;             ///< keep this many, evenly spread over the pictures; 0: all
  /// A regular expression (ECMAScript) that is found in each picture's path below images/; its
  /// first group, or all of it if it has none, is the instance. Empty: as the importer says.
  std::string instance_pattern = {};
  std::string licence = "see LICENCE";
  int num_threads = 1;
  Progress progress = {};
  /// Told, once the set is written, of what the source lacks, and of each thing that is hardly
  /// meant, in the order of the pictures: a shape that covers no pixel, a mask without good or
  /// without bad ones. Paths are the source's or, of masks, relative to `out`.
  std::function<void(const Fault& note)> on_note = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Writes a labelled image set to `out`, which must not exist or be empty: images/ (copied byte for
/// byte), masks/, clouds/ and rectangles.csv (see WriteRectangles) where there are any, and
/// manifest.csv. Of the instances, in the byte order of their names, the last
/// round(test_share · number) are the split "test", at least one and never all; a share of 0 is
/// none. On failure nothing is left of it. Throws Error when two pictures would be one file, a mask
/// is not of its picture's size, the pattern is not found, or a file cannot be read or written.
/// Same pictures and options, same bytes, for any number of threads.
LabelledImageSet ImportPictures(SourceSet source,
                                const std::filesystem::path& out,
                                const ImportOptions& options);

}  // namespace handcraft::datasets
