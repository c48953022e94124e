// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/provenance.h"

#include <cstdlib>
#include <ctime>
#include <initializer_list>
#include <utility>

#include "lib/core/error.h"

namespace handcraft::model_io {
namespace {

using Metadata = std::map<std::string, std::string>;

void AddUnlessEmpty(const std::string& key, const std::string& value, Metadata& metadata) {
  if (!value.empty()) metadata[key] = value;
}

// § 4: a time only if the builder fixes it (reproducible-builds.org), so that bytes stay the same.
std::string CreationTime() {
  const char* text = std::getenv("SOURCE_DATE_EPOCH");  // NOLINT(concurrency-mt-unsafe)
  if (text == nullptr || *text == '\0') return "";
  char* end = nullptr;
  const std::time_t seconds = std::strtoll(text, &end, 10);
  std::tm utc{};
  if (*end != '\0' || ::gmtime_r(&seconds, &utc) == nullptr) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = std::string("SOURCE_DATE_EPOCH is '") + text + "'",
                 .remedy = "give seconds since 1970, or unset it"});
  }
  char buffer[32];
  const std::size_t length = std::strftime(buffer, sizeof buffer, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {buffer, length};
}

}  // namespace

// § 4.1: what every model says about its origin.
std::map<std::string, std::string> DescribeOrigin(const Provenance& provenance) {
  Metadata metadata;
  for (const auto& [key, value] : provenance.hyper_parameters) {
    metadata["hc.training." + key] = value;
  }
  for (const auto& [key, value] : provenance.metrics) metadata["hc.metrics." + key] = value;
  const std::initializer_list<std::pair<const char*, const std::string&>> fields = {
      {"hc.name", provenance.name},
      {"hc.version", provenance.version},
      {"hc.task", provenance.task},
      {"hc.licence", provenance.licence},
      {"hc.intended_use", provenance.intended_use},
      {"hc.limits", provenance.limits},
      {"hc.training.algorithm", provenance.algorithm},
      {"hc.training.data_fingerprint", provenance.data_fingerprint},
      {"hc.training.class_counts", provenance.class_counts},
      {"hc.parent", provenance.parent}};
  for (const auto& [key, value] : fields) AddUnlessEmpty(key, value, metadata);
  AddUnlessEmpty("hc.created", CreationTime(), metadata);
  metadata["hc.tool"] = "handcraft " HANDCRAFT_VERSION;
  metadata["hc.tool.compiler"] = HANDCRAFT_COMPILER;
  AddUnlessEmpty("hc.tool.commit", HANDCRAFT_COMMIT, metadata);
  return metadata;
}

}  // namespace handcraft::model_io
