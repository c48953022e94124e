// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/peak_memory.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <fstream>
#include <limits>
#include <string>

namespace handcraft::experiments {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// A field of /proc/self/status given in kB, in bytes.
double StatusBytes(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(field + ":")) return 1024.0 * std::stod(line.substr(field.size() + 1));
  }
  return kUnknown;
}

}  // namespace

double PeakMemoryAbove(const std::function<void()>& call) {
#if defined(__GLIBC__)
  ::malloc_trim(0);  // memory freed before must not hide what the call takes
#endif
  std::ofstream clear("/proc/self/clear_refs");
  clear << "5" << std::flush;  // resets the peak to the present
  const bool has_reset = clear.good();
  const double before = StatusBytes("VmRSS");
  call();
  return has_reset ? StatusBytes("VmHWM") - before : kUnknown;
}

}  // namespace handcraft::experiments
