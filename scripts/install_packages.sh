#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs the Debian packages that Handcraft needs: the one list of them.
#
#   scripts/install_packages.sh GROUP...     groups: build test check peers
#   scripts/install_packages.sh --list GROUP...
#
# Says what is missing and why before anything is installed, leaves alone what is there, and asks
# for rights only when something is missing: runs apt-get as root, else through sudo.
# Exit code: 0 all there, 1 could not install, 2 wrong use.
set -euo pipefail

# group | package | what it is for
readonly packages='
build | g++                | C++20 compiler
build | cmake              | build configuration
build | ninja-build        | build program
build | ccache             | compiles only what changed
build | libeigen3-dev      | matrices
build | libopencv-dev      | reading and writing pictures
build | libopenblas-dev    | fast matrix products for training
build | liblapacke-dev     | eigenvectors and linear systems
build | libcli11-dev       | command line
build | nlohmann-json3-dev | JSON
build | libtinyxml2-dev    | XML
build | libtomlplusplus-dev | TOML
build | liborocos-kdl-dev  | inverse kinematics of arms without a closed form
build | zlib1g-dev         | compressed MATLAB files
build | libfmt-dev         | text formatting
build | libembree-dev      | ray casting for made-up pictures
build | libhwy-dev         | vector instructions for AVX2, AVX-512 and NEON
test  | libgtest-dev       | test framework
test  | libgmock-dev       | matchers for the tests
test  | libbenchmark-dev   | micro-benchmarks
test  | gnuplot-nox        | figures of studies as SVG and PDF
test  | git                | lists the files that are checked
test  | python3            | reads model files independently of the C++ code
test  | python3-numpy      | the same
check | clang              | fuzz targets
check | libclang-rt-14-dev | fuzzer and sanitizer run-time
check | clang-format       | code layout
check | clang-tidy         | static analysis
peers | python3            | runs scikit-learn
peers | python3-numpy      | hands matrices to scikit-learn
peers | python3-sklearn    | logistic regression that training is measured against
peers | libpcl-dev         | plane segmentation that table removal is measured against
'

usage() {
  echo "usage: scripts/install_packages.sh [--list] GROUP...   groups: build test check peers" >&2
  exit 2
}

# The lines of the named groups, each package once: "package | what it is for".
select_packages() {
  awk -F' *[|] *' -v groups=" $* " \
    'NF == 3 && index(groups, " " $1 " ") && !seen[$2]++ { print $2 " | " $3 }' <<<"$packages"
}

is_installed() {
  dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null | grep -qx installed
}

install_missing() {
  local as_root=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || {
      echo "install_packages: not root and no sudo; as root, run: apt-get install $*" >&2
      return 1
    }
    as_root=(sudo)
  fi
  if ! "${as_root[@]}" apt-get -qq update ||
    ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
      apt-get -qq install --yes --no-install-recommends "$@" >/dev/null; then
    echo "install_packages: apt-get failed; by hand: apt-get install $*" >&2
    return 1
  fi
}

main() {
  local list_only=false
  [[ "${1:-}" == --list ]] && { list_only=true; shift; }
  (($# > 0)) || usage
  local group
  for group in "$@"; do
    [[ " build test check peers " == *" $group "* ]] || usage
  done
  if $list_only; then
    select_packages "$@"
    return
  fi
  if ! command -v apt-get >/dev/null; then
    echo "install_packages: no apt-get here; install the counterparts of these packages:" >&2
    select_packages "$@" >&2
    return 1
  fi
  local missing=() package reason
  while IFS='|' read -r package reason; do
    package=${package// /}
    is_installed "$package" && continue
    ((${#missing[@]} > 0)) || echo "Installing with apt-get:"
    printf '  %-20s%s\n' "$package" "$reason"
    missing+=("$package")
  done < <(select_packages "$@")
  if ((${#missing[@]} == 0)); then
    echo "Packages ($*): all there."
    return
  fi
  install_missing "${missing[@]}"
}

main "$@"
