// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "found_planes.h"

#include <detection/up_search.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace pcl_ops::apps {

namespace {

/** \brief The plane that most of a plane's points lie on after merging; 0 for none. */
std::uint32_t
mergedInto (const PlaneSegment& plane, const FoundPlanes& after)
{
  std::map<std::uint32_t, std::size_t> votes;
  for (const pcl::index_t index : plane.inliers)
    ++votes[after.labels[static_cast<std::size_t> (index)]];
  votes.erase (0);
  const auto most = std::max_element (
      votes.begin(), votes.end(), [] (const auto& first, const auto& second) {
        return first.second < second.second;
      });
  return most == votes.end() ? 0 : most->first;
}

} // namespace

FoundPlanes
findPlanes (const DetectionRun& run,
            DetectorOptions options,
            const XyzCloud::ConstPtr& cloud)
{
  options.preset = run.preset;
  options.merging = run.merging;
  Detected detected = runMethod (methodCalled (run.method), options, cloud);
  FoundPlanes found;
  found.planes = std::move (detected.planes);
  found.up = detected.up;
  found.advice = std::move (detected.advice);
  found.up_note = std::move (detected.up_note);
  found.labels = labelsOf (found.planes, cloud->size());
  for (const PlaneSegment& plane : found.planes)
    found.extents.push_back (planeExtent (*cloud, plane));
  found.edges = findPlaneEdges (*cloud, found.planes);
  found.colors.resize (found.planes.size());
  std::iota (found.colors.begin(), found.colors.end(), 1);
  return found;
}

std::vector<std::uint32_t>
colorsBeforeMerging (const FoundPlanes& before, const FoundPlanes& after)
{
  std::vector<bool> is_taken (after.planes.size() + 1, false);
  // The first plane after merging has the first colour, and so on.
  auto unused = static_cast<std::uint32_t> (after.planes.size());
  std::vector<std::uint32_t> colors;
  for (const PlaneSegment& plane : before.planes) { // by falling size
    const std::uint32_t merged = mergedInto (plane, after);
    const bool keeps = merged != 0 && !is_taken[merged];
    is_taken[merged] = true;
    colors.push_back (keeps ? merged : ++unused);
  }
  return colors;
}

PlaneFinder::PlaneFinder (DetectorOptions options, XyzCloud::ConstPtr cloud)
: options_ (std::move (options)), cloud_ (std::move (cloud))
{}

const FoundPlanes&
PlaneFinder::detectOnce (const DetectionRun& run)
{
  const auto known = std::find_if (
      entries_.begin(), entries_.end(), [&] (const Entry& e) { return e.run == run; });
  if (known != entries_.end())
    return known->found;
  ++detections_;
  entries_.push_back ({run, findPlanes (run, options_, cloud_)});
  return entries_.back().found;
}

const FoundPlanes&
PlaneFinder::find (const DetectionRun& run)
{
  DetectionRun merged = run;
  merged.merging = true;
  const FoundPlanes& after = detectOnce (merged);
  // Not before: had the detector failed, the planes of the last run would still be
  // shown.
  entries_.remove_if ([&] (const Entry& entry) {
    return entry.run.method != run.method || entry.run.preset != run.preset;
  });
  if (run.merging)
    return after;
  const bool is_new = entries_.size() == 1;
  const FoundPlanes& before = detectOnce (run);
  if (is_new)
    entries_.back().found.colors = colorsBeforeMerging (before, after);
  return before;
}

} // namespace pcl_ops::apps
