// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// libsvm's text models from anywhere: what is read is a model that can be written, as a file that
// the runtime loads or refuses by a rule of its own, and as the same text model again.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/error.h"
#include "lib/model_io/libsvm_text.h"
#include "lib/model_io/model_writer.h"
#include "lib/model_io/svm_models.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::model_io {
namespace {

void Require(bool condition) {
  if (!condition) __builtin_trap();
}

void LoadOrRefuse(const std::vector<std::uint8_t>& bytes) {
  hc_model* model = nullptr;
  hc_error error{};
  const hc_status status = hc_model_load_memory(bytes.data(), bytes.size(), &model, &error);
  Require(status == HC_OK || status == HC_ERROR_CONTENT || status == HC_ERROR_SELF_TEST);
  hc_model_free(model);
}

void ReadText(std::string_view text) {
  const NamedSvm svm = FromLibsvmText(text, "fuzz");
  Require(svm.model.NumFeatures() == svm.names.columns.size());
  Require(svm.model.num_classes == svm.names.classes.size());
  const std::string written = ToLibsvmText(svm);
  Require(ToLibsvmText(FromLibsvmText(written, "again")) == written);
  LoadOrRefuse(Serialise(MakeSvmModel(svm.model, svm.names, {})));
}

}  // namespace
}  // namespace handcraft::model_io

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    handcraft::model_io::ReadText({reinterpret_cast<const char*>(data), size});
  } catch (const handcraft::Error& error) {
    if (error.what()[0] == '\0') std::abort();
  }
  return 0;
}
