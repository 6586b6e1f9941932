#!/bin/sh
# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause

# Prints a line with a checksum for each of some simulated clouds, and for the labels that each
# method gives its points. scripts/check compares these lines of two builds. Fails if labels
# depend on the number of threads, or if no method finds a plane in a cloud. Calls the programs
# in the folder of this script.
set -eu
PATH="$(cd "$(dirname "$0")" && pwd):$PATH"
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"

# label NAME OPTION...: labels the points of cloud.pcd, prints the checksum of the labels, and
# adds the number of planes to all_planes.
label() {
  name=$1
  shift
  pcl_ops_segment cloud.pcd labels.pcd --threads 3 --planes planes.json "$@" >/dev/null
  pcl_ops_segment cloud.pcd labels_by_one.pcd --threads 1 "$@" >/dev/null
  cmp labels.pcd labels_by_one.pcd
  planes=$(grep -c '"id"' planes.json) || true
  all_planes=$((all_planes + planes))
  echo "  $name: $planes planes, $(cksum <labels.pcd)"
}

for options in '--seed 401' '--seed 402' '--seed 403 --profile raw' '--points 200000' \
  '--scene furniture' '--scene shapes' '--scene survey'; do
  # shellcheck disable=SC2086 # an option and its value are two words
  pcl_ops_simulate cloud.pcd $options --quiet
  echo "$options: $(cksum <cloud.pcd)"
  all_planes=0
  for method in ops fspf kht; do
    for preset in default paper; do
      label "$method $preset" --method "$method" --preset "$preset"
    done
  done
  [ "$all_planes" -gt 0 ]
done
