// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kept_numbers.h"

#include <evaluation/metrics/confusion.h>

#include <algorithm>

namespace pcl_ops::evaluation {

void
KeptNumbers::add (const PlaneLabels& truth, const PlaneLabels& result)
{
  const Confusion confusion = confusionOf (truth, result);
  numbers_.insert (confusion.result.label.begin(), confusion.result.label.end());
  for (const Overlap& overlap : confusion.overlaps) {
    constexpr double half = 0.5; // above, there is one partner at most
    if (confusion.iou (overlap) <= half)
      continue;
    History& history = of_truth_[confusion.truth.label[overlap.truth]];
    const std::uint32_t number = confusion.result.label[overlap.result];
    if (history.sightings > 0) {
      ++sightings_;
      sightings_kept_ += number == history.last ? 1 : 0;
    }
    ++history.sightings;
    history.last = number;
    history.numbers.insert (number);
  }
}

std::size_t
KeptNumbers::planes() const
{
  return static_cast<std::size_t> (
      std::count_if (of_truth_.begin(), of_truth_.end(), [] (const auto& plane) {
        return plane.second.sightings > 1;
      }));
}

std::size_t
KeptNumbers::planesKept() const
{
  return static_cast<std::size_t> (
      std::count_if (of_truth_.begin(), of_truth_.end(), [] (const auto& plane) {
        return plane.second.sightings > 1 && plane.second.numbers.size() == 1;
      }));
}

} // namespace pcl_ops::evaluation
