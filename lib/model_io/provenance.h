// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>

namespace handcraft::model_io {

/// What every model file says about its origin (metadata, docs/model_format.md). Empty strings are
/// left out.
struct Provenance {
  std::string name = {};
  std::string version = "1";
  std::string task = {};
  std::string licence = {};
  std::string intended_use = {};
  std::string limits = {};
  std::string algorithm = {};                                ///< "logistic_irls"
  std::string data_fingerprint = {};                         ///< SHA-256 of the training data
  std::string class_counts = {};                             ///< "0: 77094, 1: 77094"
  std::string parent = {};                                   ///< SHA-256 of the model it began with
  std::map<std::string, std::string> hyper_parameters = {};  ///< written as hc.training.<key>
  std::map<std::string, std::string> metrics = {};           ///< written as hc.metrics.<key>
};

/// The hc.* keys that say so, with those of the tool (docs/model_format.md § 4.1). Deterministic:
/// no time unless SOURCE_DATE_EPOCH is set. Throws Error(kUsage) when that is not a number.
[[nodiscard]] std::map<std::string, std::string> DescribeOrigin(const Provenance& provenance);

}  // namespace handcraft::model_io
