// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace handcraft {

/// While an object of this class lives, BLAS works in the calling thread alone, so that our own
/// threads are the only ones; the former setting comes back when the last object goes.
///
/// Knows OpenBLAS, MKL and BLIS by the functions they export, looked up in the running process:
/// whatever BLAS is linked, or put in its place by the system's alternatives, is set right, and one
/// that has no threads (the reference BLAS) is left alone. Thread-safe; objects may overlap.
class SingleThreadedBlas {
 public:
  SingleThreadedBlas();
  ~SingleThreadedBlas();
  SingleThreadedBlas(const SingleThreadedBlas&) = delete;
  SingleThreadedBlas& operator=(const SingleThreadedBlas&) = delete;

  /// Threads BLAS would use now; 1 when the library does not tell.
  [[nodiscard]] static int NumThreads();
};

}  // namespace handcraft
