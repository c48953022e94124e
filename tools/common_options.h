// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/view_set.h"
#include "tools/console.h"

namespace handcraft::tools {

/// The group, in --help, of the options that a model of tables does not read.
inline constexpr const char* kPictureGroup = "For models of pictures";

/// The group, in --help, of the options that a model of object classes alone reads.
inline constexpr const char* kCloudGroup = "For models of object classes";

/// The names of the options of a group that were given.
[[nodiscard]] std::vector<std::string> GivenOptions(const CLI::App& command,
                                                    const std::string& group);

/// Throws Error(kUsage) that names the first of `given`, options of kPictureGroup, if there is one:
/// the model is of tables.
void RefusePictureOptions(const std::vector<std::string>& given);

/// Options that mean the same in every subcommand that has them.
void AddJsonFlag(CLI::App& command, bool& json);
void AddSeedOption(CLI::App& command, std::uint64_t& seed);
/// Sets num_threads to the number of hardware threads until the user says otherwise.
void AddThreadsOption(CLI::App& command, int& num_threads);

/// `--json [FILE]`: empty when not given, "-" (standard output) without a file.
void AddJsonFileOption(CLI::App& command, std::string& target);
/// Writes JSON text where that option says; nothing when it was not given.
void WriteJson(const Console& console, const std::string& target, const std::string& text);

/// The last lines of --help: one command that works as printed, from the root of the sources
/// (files below out/demo are made by ./demo).
void SetExample(CLI::App& command, const std::string& line);

/// Says before the work, not after it, that a result could not be written: throws Error(kBadInput)
/// when `path` is a folder or its folder is missing or not writable. An empty path passes.
void RequireWritable(const std::filesystem::path& path);

/// The files of a labelled image set: manifest, pictures and masks.
[[nodiscard]] std::vector<std::filesystem::path> FilesOf(const datasets::LabelledImageSet& set);

/// Its list, pictures, object masks, clouds and depths, and the lists that may stand beside it.
[[nodiscard]] std::vector<std::filesystem::path> FilesOf(const datasets::ViewSet& set);

/// Throws Error(kUsage) when `output` is one of the files `inputs`, by whatever name. An empty path
/// and "-" pass.
void RequireNotAnInput(const std::filesystem::path& output,
                       std::span<const std::filesystem::path> inputs);

}  // namespace handcraft::tools
