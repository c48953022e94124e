// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/import_formats.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "datasets/importers/bop.h"
#include "datasets/importers/coco.h"
#include "datasets/importers/coil.h"
#include "datasets/importers/cornell.h"
#include "datasets/importers/cvat.h"
#include "datasets/importers/eth80.h"
#include "datasets/importers/folders.h"
#include "datasets/importers/jacquard.h"
#include "datasets/importers/labelme.h"
#include "datasets/importers/umd.h"
#include "datasets/importers/washington.h"
#include "tools/number_option.h"

namespace handcraft::tools {
namespace {

// An option that may be given more than once, with one value each time.
template <class T>
CLI::Option* AddRepeated(CLI::App& command,
                         const std::string& name,
                         std::vector<T>& values,
                         const std::string& description) {
  return command.add_option(name, values, description + "; may be given again")
      ->allow_extra_args(false);
}

void AddGraspMaskOptions(CLI::App& command, datasets::GraspMaskOptions& mask) {
  AddNumber(command,
            "--good-share",
            mask,
            &datasets::GraspMaskOptions::good_share,
            "Central share of a rectangle's opening that is good, the rest is don't care");
  AddNumber(command,
            "--dont-care-margin",
            mask,
            &datasets::GraspMaskOptions::dont_care_margin_px,
            "Nothing nearer than this to a rectangle is called bad [px]");
}

SourceLister AddCornellOptions(CLI::App& command) {
  auto options = std::make_shared<datasets::CornellOptions>();
  AddGraspMaskOptions(command, options->mask);
  command.add_flag_callback(
      "--no-negative-rectangles",
      [options] { options->use_negative_rectangles = false; },
      "Do not call the inside of negative rectangles (cneg) bad");
  AddNumber(command,
            "--instance-span",
            *options,
            &datasets::CornellOptions::instance_span,
            "Numbers that make one instance: neighbours show the same object");
  AddNumber(command,
            "--split-gap",
            *options,
            &datasets::CornellOptions::split_gap,
            "Training pictures this close in number to the test ones are left out");
  return [options](const std::filesystem::path& source) {
    return datasets::ListCornell(source, *options);
  };
}

void AddLabelRoles(CLI::App& command, datasets::LabelRoles& roles) {
  std::string good;
  for (const std::string& label : roles.good) good += (good.empty() ? "'" : ", '") + label + "'";
  const auto add =
      [&command](const char* name, std::vector<std::string>& labels, const std::string& what) {
        AddRepeated(command, name, labels, what)->type_name("LABEL");
      };
  add("--good", roles.good, "Label that means good; without it " + good);
  add("--bad", roles.bad, "Label that means bad, even on something good");
  add("--dont-care", roles.dont_care, "Label that means don't care");
}

SourceLister AddLabelmeOptions(CLI::App& command) {
  auto roles = std::make_shared<datasets::LabelRoles>();
  AddLabelRoles(command, *roles);
  return [roles](const std::filesystem::path& source) {
    return datasets::ListLabelme(source, *roles);
  };
}

SourceLister AddCocoOptions(CLI::App& command) {
  auto options = std::make_shared<datasets::CocoOptions>();
  command.add_option("--images", options->images, "Folder of the pictures; without it that of SRC")
      ->type_name("DIR");
  AddLabelRoles(command, options->roles);
  return [options](const std::filesystem::path& source) {
    return datasets::ListCoco(source, *options);
  };
}

SourceLister AddCvatOptions(CLI::App& command) {
  auto options = std::make_shared<datasets::CvatOptions>();
  command
      .add_option(
          "--images", options->images, "Folder of the pictures; without it that of the export")
      ->type_name("DIR");
  AddLabelRoles(command, options->roles);
  return [options](const std::filesystem::path& source) {
    return datasets::ListCvat(source, *options);
  };
}

SourceLister AddUmdOptions(CLI::App& command) {
  auto roles = std::make_shared<datasets::LabelRoles>(datasets::UmdRoles());
  AddLabelRoles(command, *roles);
  return [roles](const std::filesystem::path& source) { return datasets::ListUmd(source, *roles); };
}

SourceLister AddJacquardOptions(CLI::App& command) {
  auto options = std::make_shared<datasets::GraspMaskOptions>();
  AddGraspMaskOptions(command, *options);
  return [options](const std::filesystem::path& source) {
    return datasets::ListJacquard(source, *options);
  };
}

void AddMaskValue(CLI::App& command,
                  const std::string& name,
                  std::vector<int>& values,
                  const std::string& description) {
  AddRepeated(command, name, values, description)
      ->transform(IntegerWithin(0, 255))
      ->type_name("INT");
}

void AddText(CLI::App& command, const char* name, std::string& text, const char* description) {
  command.add_option(name, text, description)->capture_default_str();
}

// `folders` with pictures and labels in one place.
SourceLister AddSaxenaOptions(CLI::App& command) {
  auto options = std::make_shared<datasets::FoldersOptions>(
      datasets::FoldersOptions{.images = ".", .masks = ".", .mask_suffix = "_label"});
  AddText(command, "--image-suffix", options->image_suffix, "What ends a picture's name");
  AddText(command, "--label-suffix", options->mask_suffix, "What ends a label picture's name");
  return [options](const std::filesystem::path& source) {
    return datasets::ListFolders(source, *options);
  };
}

SourceLister AddFoldersOptions(CLI::App& command) {
  auto options = std::make_shared<datasets::FoldersOptions>();
  AddText(command, "--images", options->images, "Folder of the pictures, below SRC");
  AddText(command, "--masks", options->masks, "Folder of the masks, below SRC");
  AddText(command, "--image-suffix", options->image_suffix, "What ends a picture's name: _rgb");
  AddText(command, "--mask-suffix", options->mask_suffix, "What ends a mask's name: _label");
  AddMaskValue(command,
               "--good",
               options->good,
               "Value of a mask that means good; without it all but 0 and don't care");
  AddMaskValue(command, "--dont-care", options->dont_care, "Value of a mask that means don't care");
  return [options](const std::filesystem::path& source) {
    return datasets::ListFolders(source, *options);
  };
}

constexpr const char* kFlatClouds =
    "Flat clouds of the silhouettes, for what asks for clouds; nothing of them was measured";

SourceLister AddEth80Options(CLI::App& command) {
  auto options = std::make_shared<datasets::Eth80Options>();
  AddNumber(command,
            "--polar",
            *options,
            &datasets::Eth80Options::polar_deg,
            "Views from this angle to the vertical [deg]; 90 is level");
  command.add_flag("--flat-clouds", options->flat_clouds, kFlatClouds);
  return [options](const std::filesystem::path& source) {
    return datasets::ListEth80(source, *options);
  };
}

SourceLister AddCoilOptions(CLI::App& command) {
  auto options = std::make_shared<datasets::CoilOptions>();
  AddNumber(command,
            "--threshold",
            *options,
            &datasets::CoilOptions::threshold,
            "Values up to this are dark; what is dark up to the edge is background");
  command.add_flag("--flat-clouds", options->flat_clouds, kFlatClouds);
  return [options](const std::filesystem::path& source) {
    return datasets::ListCoil(source, *options);
  };
}

SourceLister AddWashingtonOptions(CLI::App& /*command*/) {
  return [](const std::filesystem::path& source) { return datasets::ListWashington(source); };
}

SourceLister AddBopOptions(CLI::App& command) {
  auto options = std::make_shared<datasets::BopOptions>();
  AddNumber(command,
            "--min-visible",
            *options,
            &datasets::BopOptions::min_visible,
            "Leave out objects of which a smaller share is seen");
  AddNumber(command,
            "--margin",
            *options,
            &datasets::BopOptions::margin_px,
            "Margin of the cut-out around an object [px]");
  return [options](const std::filesystem::path& source) {
    return datasets::ListBop(source, *options);
  };
}

constexpr auto kFormats = std::to_array<ImportFormat>(
    {{"folders",
      "Folders of pictures and of masks with the same names",
      "Folder that holds the two folders",
      "folders datasets/samples/cornell_mini --image-suffix r --good 255 --dont-care 128 --out "
      "folders",
      AddFoldersOptions},
     {"labelme",
      "LabelMe files: polygons, rectangles and circles with labels",
      "Folder with NAME.json, the pictures embedded or beside them",
      "labelme tests/data/labelme --dont-care table --out labelme",
      AddLabelmeOptions},
     {"coco",
      "COCO object segmentations: polygons and runs",
      "The JSON file",
      "coco tests/data/coco/instances.json --images tests/data/cornell --out coco",
      AddCocoOptions},
     {"cvat",
      "CVAT's exports \"CVAT for images 1.1\" and \"Segmentation mask 1.1\"",
      "The unpacked folder, with annotations.xml or labelmap.txt",
      "cvat tests/data/cvat --images tests/data/cornell --good handle --out cvat",
      AddCvatOptions},
     {"saxena",
      "Pairs of a picture and a binary label picture in one folder, as Saxena et al. made them",
      "Folder with NAME.png beside NAME_label.png, at any depth",
      "saxena tests/data/saxena --out saxena",
      AddSaxenaOptions},
     {"umd",
      "UMD part affordances: tools and what their parts are for",
      "Folder with NAME_rgb.jpg beside NAME_label.mat, at any depth",
      "umd tests/data/umd --out umd",
      AddUmdOptions},
     {"jacquard",
      "Jacquard data set: rendered objects and simulated grasps",
      "Folder with N_OBJECT_RGB.png beside N_OBJECT_grasps.txt, at any depth",
      "jacquard tests/data/jacquard --out jacquard",
      AddJacquardOptions},
     {"cornell",
      "Cornell grasping data set: photographs and grasp rectangles into label masks",
      "Folder with pcdNNNNr.png beside pcdNNNNcpos.txt, in one folder or in 01, 02, …",
      "cornell tests/data/cornell --out cornell",
      AddCornellOptions},
     {"eth80",
      "ETH-80, as views: objects on a turntable with silhouettes",
      "Folder with OBJECT-PPP-AAA.png beside maps/OBJECT-PPP-AAA-map.png, at any depth",
      "eth80 tests/data/views/eth80 --out eth80",
      AddEth80Options,
      SetKind::kViews},
     {"coil",
      "COIL-20 and COIL-100, as views: objects on a turntable before black",
      "Folder with objN__K.png, at any depth, or NPY file of the pictures",
      "coil tests/data/views/coil --out coil",
      AddCoilOptions,
      SetKind::kViews},
     {"washington",
      "Washington RGB-D objects, as views with clouds",
      "Folder with CLASS_N_VIDEO_FRAME_crop.png, _maskcrop.png, _depthcrop.png, _loc.txt",
      "washington tests/data/views/washington --out washington",
      AddWashingtonOptions,
      SetKind::kViews},
     {"bop",
      "BOP scenes (LINEMOD and others), as views with clouds",
      "Folder with scene_gt.json, scene_camera.json, rgb, mask_visib and depth, at any depth",
      "bop tests/data/views/bop --out bop",
      AddBopOptions,
      SetKind::kViews}});

}  // namespace

std::span<const ImportFormat> ImportFormats() { return kFormats; }

}  // namespace handcraft::tools
