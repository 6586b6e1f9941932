# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash

# What the scripts share; sourced by them.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '==> %s\n' "$*"; }

fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# quietly LOG COMMAND...: the command's output goes to the file and is shown if it fails.
quietly() {
  local log=$1
  shift
  mkdir -p "$(dirname "$log")"
  if ! "$@" >"$log" 2>&1 </dev/null; then
    tail -n 60 "$log" >&2
    fail "failed: $* (all of its output: $log)"
  fi
}

# missing_packages PACKAGE...: those that are not installed, and of ?PACKAGE those that this
# Debian or Ubuntu has.
missing_packages() {
  local package name
  for package in "$@"; do
    name=${package#\?}
    dpkg-query --show --showformat='${db:Status-Status}\n' "$name" 2>/dev/null |
      grep --quiet --line-regexp installed && continue
    [ "$package" = "$name" ] || apt-cache show "$name" >/dev/null 2>&1 || continue
    printf '%s\n' "$name"
  done
}

# install_packages PACKAGE...: the missing_packages.
install_packages() {
  local missing=() as_root=()
  if ! command -v apt-get >/dev/null; then
    say "no apt-get here; what is needed, by its names in Debian: ${*#\?}"
    return
  fi
  mapfile -t missing < <(missing_packages "$@")
  if [ ${#missing[@]} -eq 0 ]; then
    say "nothing to install"
    return
  fi
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "needs root or sudo to install: ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  as_root+=(env DEBIAN_FRONTEND=noninteractive apt-get --quiet --yes)
  quietly "$root/build/apt-update.log" "${as_root[@]}" update
  mapfile -t missing < <(missing_packages "$@") # more names are known now
  quietly "$root/build/apt-install.log" "${as_root[@]}" install --no-install-recommends "${missing[@]}"
}

# What every build needs.
# shellcheck disable=SC2034
build_packages=(g++ cmake make libpcl-dev nlohmann-json3-dev libpng-dev
  '?liblaszip-dev')
# What the Python module needs besides; where one is missing it is left out.
# shellcheck disable=SC2034
python_packages=(python3-dev python3-numpy pybind11-dev)

# Those that everything has to compile with, of which a distribution has some.
# shellcheck disable=SC2034
all_compilers=(g++-12 g++-13 g++-14 clang-14 clang-15 clang-16 clang-17 clang-18 clang-19)

# install_newest_compiler: the last of them that there is here and that works with the
# standard library here; sets newest to its name, or to g++.
install_newest_compiler() {
  local i
  for ((i = ${#all_compilers[@]} - 1; i >= 0; --i)); do
    newest=${all_compilers[i]}
    install_packages "?$newest"
    if "${newest/clang-/clang++-}" -std=c++17 -fsyntax-only -x c++ - <<<'#include <algorithm>' 2>/dev/null; then
      return
    fi
  done
  newest=g++
}

# How many compilers fit, at 1.5 GB each.
jobs() {
  awk -v cores="$(nproc)" '/^MemAvailable/ { fit = int($2 / 1500000) }
    END { print fit < 1 ? 1 : fit < cores ? fit : cores }' /proc/meminfo 2>/dev/null || nproc
}

# configure FOLDER OPTION...: a build below build/ with these CMake options. Built once,
# sources compile in half the time many at once.
configure() {
  local folder=$root/build/$1
  shift
  set -- -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 -DPCL_OPS_BUILD_LAB=ON "$@"
  if command -v ccache >/dev/null; then
    set -- "$@" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  # It compiles on where make waits for a library.
  if [ ! -f "$folder/CMakeCache.txt" ] && command -v ninja >/dev/null; then
    set -- -G Ninja "$@"
  fi
  quietly "$folder/configure.log" cmake -S "$root" -B "$folder" "$@"
}

# build FOLDER [TARGET...]: everything, or only these targets.
build() {
  local folder=$root/build/$1
  shift
  [ $# -eq 0 ] || set -- --target "$@"
  quietly "$folder/build.log" cmake --build "$folder" --parallel "$(jobs)" "$@"
}
