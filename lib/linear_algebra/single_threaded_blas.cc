// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/linear_algebra/single_threaded_blas.h"

#include <dlfcn.h>

#include <cstdint>
#include <functional>
#include <mutex>

namespace handcraft {
namespace {

struct ThreadControl {
  std::function<int()> get;
  std::function<void(int)> set;
};

// The functions of one library, whose own type of a number of threads is Count.
template <class Count>
bool Find(const char* get_name, const char* set_name, ThreadControl& control) {
  void* get = dlsym(RTLD_DEFAULT, get_name);
  void* set = dlsym(RTLD_DEFAULT, set_name);
  if (get == nullptr || set == nullptr) return false;
  control.get = [get] { return static_cast<int>(reinterpret_cast<Count (*)()>(get)()); };
  control.set = [set](int count) { reinterpret_cast<void (*)(Count)>(set)(Count{count}); };
  return true;
}

ThreadControl FindThreadControl() {
  ThreadControl control;
  static_cast<void>(
      Find<int>("openblas_get_num_threads", "openblas_set_num_threads", control) ||
      Find<int>("MKL_Get_Max_Threads", "MKL_Set_Num_Threads", control) ||
      Find<std::int64_t>("bli_thread_get_num_threads", "bli_thread_set_num_threads", control));
  return control;
}

const ThreadControl& Control() {
  static const ThreadControl control = FindThreadControl();
  return control;
}

std::mutex mutex;
int num_alive = 0;   // guarded by mutex
int num_before = 1;  // guarded by mutex: the setting to come back to

}  // namespace

SingleThreadedBlas::SingleThreadedBlas() {
  if (!Control().set) return;
  const std::lock_guard lock(mutex);
  if (num_alive++ == 0) {
    num_before = Control().get();
    Control().set(1);
  }
}

SingleThreadedBlas::~SingleThreadedBlas() {
  if (!Control().set) return;
  const std::lock_guard lock(mutex);
  if (--num_alive == 0) Control().set(num_before);
}

int SingleThreadedBlas::NumThreads() { return !Control().get ? 1 : Control().get(); }

}  // namespace handcraft
