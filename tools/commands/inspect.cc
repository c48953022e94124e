// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/core/utf8.h"
#include "lib/model_io/model_writer.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

struct InspectOptions {
  std::string model;
  bool json = false;
};

// In the order of the variant's types.
constexpr std::array<std::string_view, 5> kTypeNames = {"F32", "F64", "I64", "I32", "U8"};

std::string_view TypeName(const model_io::Tensor& tensor) {
  return kTypeNames.at(tensor.values.index());
}

nlohmann::ordered_json ToJson(const std::string& path,
                              const std::vector<std::uint8_t>& bytes,
                              const model_io::ModelFile& file) {
  nlohmann::ordered_json json{{"model", path},
                              {"bytes", bytes.size()},
                              {"sha256", Sha256Hex(bytes)},
                              {"metadata", file.metadata},
                              {"tensors", nlohmann::ordered_json::array()}};
  for (const auto& [name, tensor] : file.tensors) {
    json["tensors"].push_back(
        {{"name", name}, {"dtype", TypeName(tensor)}, {"shape", tensor.shape}});
  }
  return json;
}

// Smallest and largest value: enough to see a weight vector that is all zero or has run away.
std::array<std::string, 2> RangeOf(const model_io::Tensor& tensor) {
  return std::visit(
      [](const auto& values) -> std::array<std::string, 2> {
        if (values.empty()) return {"-", "-"};
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        return {fmt::format("{:.6g}", static_cast<double>(*low)),
                fmt::format("{:.6g}", static_cast<double>(*high))};
      },
      tensor.values);
}

void PrintText(const Console& console,
               const std::string& path,
               const std::vector<std::uint8_t>& bytes,
               const model_io::ModelFile& file) {
  console.out << "Model " << OnOneLine(path) << ", " << bytes.size() << " bytes\nsha256 "
              << Sha256Hex(bytes) << "\n\n";
  TextTable metadata;
  for (const auto& [key, value] : file.metadata) metadata.AddRow({key, value});
  TextTable tensors({"tensor", "type", "shape", "min", "max"});
  for (const auto& [name, tensor] : file.tensors) {
    const auto [low, high] = RangeOf(tensor);
    tensors.AddRow({name,
                    std::string(TypeName(tensor)),
                    fmt::format("[{}]", fmt::join(tensor.shape, " × ")),
                    low,
                    high});
  }
  console.out << metadata.ToText() << '\n' << tensors.ToText();
}

void RunInspect(const InspectOptions& options, const Console& console) {
  const std::vector<std::uint8_t> bytes = ReadFile(options.model);
  const model_io::ModelFile file = model_io::Parse(bytes, options.model);
  if (options.json) {
    console.Print(ToJson(options.model, bytes, file));
  } else {
    PrintText(console, options.model, bytes, file);
  }
}

}  // namespace

void AddInspect(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<InspectOptions>();
  CLI::App* command =
      parent.add_subcommand("inspect", "Show what a model file says and holds, and its SHA-256");
  command->add_option("MODEL", options->model, "Model file")->required();
  AddJsonFlag(*command, options->json);
  SetExample(*command, "handcraft inspect out/demo/grasp_points.safetensors");
  command->callback([options, &console] { RunInspect(*options, console); });
}

}  // namespace handcraft::tools
