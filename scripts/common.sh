# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash

# What the scripts share; sourced by them.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '==> %s\n' "$*"; }

# --help prints the comment at the head of the calling script.
if [[ "${1-}" == --help || "${1-}" == -h ]]; then
  sed -n '5,/^[^#]/s/^# \?//p' "$0" | sed '/^shellcheck /d'
  exit 0
fi

fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# From one line of progress to the next [s]; PCL_OPS_SILENCE is for tests of the scripts.
progress_interval=${PCL_OPS_SILENCE:-20}

# progress_of LOG: prints in a line how far a build, an installation or tests are, by their
# output.
progress_of() {
  LC_ALL=C awk '
    function megabytes(number, unit) {
      gsub(",", "", number)
      return number * (unit ~ /^GB/ ? 1000 : unit ~ /^MB/ ? 1 : unit ~ /^kB/ ? 0.001 : 0.000001)
    }
    / newly installed, / { packages = $3 }
    /^Need to get / { split($4, all, "/"); wanted = megabytes(all[1], $5) }
    /^Get:/ && match($0, /\[[0-9.,]+ [kMG]?B\]$/) {
      split(substr($0, RSTART + 1, RLENGTH - 2), size, " ")
      fetched += megabytes(size[1], size[2])
    }
    /^Unpacking / { ++unpacked }
    /^Setting up / { ++set_up }
    /^\[ *[0-9]+%\]/ || /^\[[0-9]+\/[0-9]+\]/ { step = substr($0, 2, index($0, "]") - 2) }
    / Test +#[0-9]+:/ { tests = $1 }
    NF { last = $0 }
    END {
      if (set_up) print set_up " of " packages " packages are set up"
      else if (unpacked) print unpacked " of " packages " packages are unpacked"
      else if (wanted) printf "%d of %d MB are fetched for %d packages\n", fetched, wanted, packages
      else if (tests) print tests " tests are done"
      else if (step) print (step ~ /%/ ? step " is built" : step " steps are done")
      else print substr(last, 1, 100)
    }' "$1" 2>/dev/null || true
}

# print_progress LOG always|if_silent: prints a line of progress at each interval until the
# script ends; with if_silent only if the log has not grown since the last one.
print_progress() {
  local log=$1 when=$2 last_size=-1 size never_written
  # The read waits until its time is over, as nobody writes. A sleep would be a process of its
  # own, which could outlive this one and keep its output open.
  exec {never_written}<> <(:)
  while kill -0 $$ 2>/dev/null; do
    read -r -t "$progress_interval" -u "$never_written" _ || true
    size=$(wc -c <"$log")
    if [ "$when" = always ] || [ "$size" = "$last_size" ]; then
      say "  $(progress_of "$log"), goes on"
    fi
    last_size=$size
  done
}

# stop_progress PID: ends a print_progress in the background.
stop_progress() {
  kill "$1" 2>/dev/null || true
  wait "$1" 2>/dev/null || true
}

# quietly LOG COMMAND...: runs a command whose output goes to the log and is shown only if it
# fails; prints its progress.
quietly() {
  local log=$1 status=0 progress_pid
  shift
  mkdir -p "$(dirname "$log")"
  : >"$log"
  print_progress "$log" always &
  progress_pid=$!
  "$@" >"$log" 2>&1 </dev/null || status=$?
  stop_progress "$progress_pid"
  if [ "$status" -ne 0 ]; then
    tail -n 60 "$log" >&2
    fail "failed: $* (all of its output: $log)"
  fi
}

# aloud LOG COMMAND...: runs a command whose output is shown and goes to the log; prints its
# progress while it prints nothing itself.
aloud() {
  local log=$1 status=0 progress_pid
  shift
  mkdir -p "$(dirname "$log")"
  : >"$log"
  print_progress "$log" if_silent &
  progress_pid=$!
  "$@" </dev/null 2>&1 | tee "$log" || status=$?
  stop_progress "$progress_pid"
  return "$status"
}

# missing_packages PACKAGE...: prints those that are not installed. A ?PACKAGE is optional: it
# is left out if this Debian or Ubuntu does not have it.
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

# install_packages PACKAGE...: installs the missing_packages.
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
  as_root+=(env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get --quiet --yes)
  quietly "$root/build/apt-update.log" "${as_root[@]}" update
  mapfile -t missing < <(missing_packages "$@") # more names are known now
  # --print-uris prints what would be fetched and installs nothing; --assume-no would not, as
  # --yes overrides it.
  quietly "$root/build/apt-size.log" "${as_root[@]}" --print-uris install --no-install-recommends "${missing[@]}"
  say "installing ${missing[*]}"
  sed -n 's/.* \([0-9]*\) newly installed.*/==>   packages: \1/p; s/^Need to get \(.*\) of archives.*/==>   to fetch: \1/p' \
    "$root/build/apt-size.log"
  quietly "$root/build/apt-install.log" "${as_root[@]}" install --no-install-recommends "${missing[@]}"
}

# Packages that pcl_ops_segment and pcl_ops_simulate need without PCL.
# shellcheck disable=SC2034
build_packages_without_pcl=(g++ cmake make libeigen3-dev libboost-dev nlohmann-json3-dev
  libpng-dev '?liblaszip-dev')
# Packages that every other build needs.
# shellcheck disable=SC2034
build_packages=(g++ cmake make libpcl-dev nlohmann-json3-dev libpng-dev libsqlite3-dev
  '?liblaszip-dev')
# Packages that the Python module needs, too; without them the build leaves it out.
# shellcheck disable=SC2034
python_packages=(python3-dev python3-numpy pybind11-dev)

# Compilers that have to build everything; a distribution has some of them.
# shellcheck disable=SC2034
all_compilers=(g++-12 g++-13 g++-14 clang-14 clang-15 clang-16 clang-17 clang-18 clang-19)

# install_newest_compiler: installs the last of all_compilers that this distribution has and
# that works with its standard library; sets newest to its name, or to g++ if there is none.
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

# jobs: prints how many compilers can run at once: one per core, but no more than fit into the
# free memory at 1.5 GB each, a value chosen by hand.
jobs() {
  awk -v cores="$(nproc)" -v kilobytes_per_job=1500000 '
    /^MemAvailable/ { fit = int($2 / kilobytes_per_job) }
    END { print fit < 1 ? 1 : fit < cores ? fit : cores }' /proc/meminfo 2>/dev/null || nproc
}

# configure FOLDER OPTION...: configures build/FOLDER with these CMake options. A unity build is
# the default, as building all of it once takes half the time.
configure() {
  local folder=$root/build/$1
  shift
  set -- -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 "$@"
  if command -v ccache >/dev/null; then
    set -- "$@" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  # Ninja compiles sources of a program before its libraries are done, and make does not.
  if [ ! -f "$folder/CMakeCache.txt" ] && command -v ninja >/dev/null; then
    set -- -G Ninja "$@"
  fi
  quietly "$folder/configure.log" cmake -S "$root" -B "$folder" "$@"
}

# build FOLDER [TARGET...]: builds everything in build/FOLDER, or only these targets.
build() {
  local folder=$root/build/$1
  shift
  [ $# -eq 0 ] || set -- --target "$@"
  quietly "$folder/build.log" cmake --build "$folder" --parallel "$(jobs)" "$@"
}
