# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash

# What the scripts share; sourced by them.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '==> %s\n' "$*"; }

# What is said of a script at its head, to whoever asks any of them for it.
if [[ "${1-}" == --help || "${1-}" == -h ]]; then
  sed -n '5,/^[^#]/s/^# \?//p' "$0" | sed '/^shellcheck /d'
  exit 0
fi

fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

silence=${PCL_OPS_SILENCE:-20} # seconds after which a line says what goes on

# progress_of LOG: how far a build, an installation or tests are by their output, in a line.
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

# tell_of LOG WHILE: lines that say how far a command is that writes the log, and says nothing
# itself; with WHILE silent only as long as the log does not grow, as others see it, too.
tell_of() {
  local log=$1 while=$2 size=-1 now waiting
  # Reads of what nobody writes: a sleep would outlive this one, and hold its output open.
  exec {waiting}<> <(:)
  while kill -0 $$ 2>/dev/null; do
    read -r -t "$silence" -u "$waiting" _ || true
    now=$(wc -c <"$log")
    if [ "$while" = always ] || [ "$now" = "$size" ]; then
      say "  $(progress_of "$log"), goes on"
    fi
    size=$now
  done
}

# stop_telling PID: of tell_of in the background.
stop_telling() {
  kill "$1" 2>/dev/null || true
  wait "$1" 2>/dev/null || true
}

# quietly LOG COMMAND...: the command's output goes to the file and is shown if it fails;
# meanwhile lines say how far it is.
quietly() {
  local log=$1 status=0 teller
  shift
  mkdir -p "$(dirname "$log")"
  : >"$log"
  tell_of "$log" always &
  teller=$!
  "$@" >"$log" 2>&1 </dev/null || status=$?
  stop_telling "$teller"
  if [ "$status" -ne 0 ]; then
    tail -n 60 "$log" >&2
    fail "failed: $* (all of its output: $log)"
  fi
}

# aloud LOG COMMAND...: the command's output is shown, and goes to the file; where there is
# none for long, lines say how far it is.
aloud() {
  local log=$1 status=0 teller
  shift
  mkdir -p "$(dirname "$log")"
  : >"$log"
  tell_of "$log" silent &
  teller=$!
  "$@" </dev/null 2>&1 | tee "$log" || status=$?
  stop_telling "$teller"
  return "$status"
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
  as_root+=(env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get --quiet --yes)
  quietly "$root/build/apt-update.log" "${as_root[@]}" update
  mapfile -t missing < <(missing_packages "$@") # more names are known now
  # Names what it would fetch, and installs nothing; --assume-no would give way to --yes.
  quietly "$root/build/apt-size.log" "${as_root[@]}" --print-uris install --no-install-recommends "${missing[@]}"
  say "installing ${missing[*]}"
  sed -n 's/.* \([0-9]*\) newly installed.*/==>   packages: \1/p; s/^Need to get \(.*\) of archives.*/==>   to fetch: \1/p' \
    "$root/build/apt-size.log"
  quietly "$root/build/apt-install.log" "${as_root[@]}" install --no-install-recommends "${missing[@]}"
}

# What pcl_ops_segment and pcl_ops_simulate need; the rest of the project needs PCL.
# shellcheck disable=SC2034
build_packages_without_pcl=(g++ cmake make libeigen3-dev libboost-dev nlohmann-json3-dev
  libpng-dev '?liblaszip-dev')
# What every other build needs.
# shellcheck disable=SC2034
build_packages=(g++ cmake make libpcl-dev nlohmann-json3-dev libpng-dev libsqlite3-dev
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
  set -- -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 "$@"
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
