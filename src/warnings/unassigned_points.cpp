// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warnings/unassigned_points.h"

#include "warnings/constants.h"
#include <pcl_ops/detect_planes.h>

#include <algorithm>
#include <string>

namespace pcl_ops::internal {

namespace {

using OpsParameters = OrientedPointSamplingParameters;

/** \brief A search with another value of one parameter, and the advice to use it. */
struct OtherSearch {
  OpsParameters parameters;
  std::string advice;
};

/** \brief Searches that each have the default of one parameter in place of the given
 * value: one for each parameter whose given value may keep points off planes. */
std::vector<OtherSearch>
searchesWithDefaults (const OpsParameters& given, const ParameterText& text)
{
  const OpsParameters defaults;
  std::vector<OtherSearch> searches;
  // OPS on points needs a threshold.
  if (given.distance_threshold && given.sampling != Sampling::Points) {
    searches.push_back ({given, "leave out " + text.of ("threshold", "")});
    searches.back().parameters.distance_threshold.reset();
  }
  if (given.min_points > defaults.min_points) {
    searches.push_back ({given, "leave out " + text.of ("min-points", "")});
    searches.back().parameters.min_points = defaults.min_points;
  }
  if (given.min_samples > defaults.min_samples) {
    searches.push_back ({given, "leave out " + text.of ("min-inliers", "")});
    searches.back().parameters.min_samples = defaults.min_samples;
  }
  return searches;
}

/** \brief Share of all points that are on large planes.
 * \param[in] points number of finite points of the cloud
 * \param[in] min_share of all points that a large plane has */
double
shareOnPlanes (const std::vector<PlaneSegment>& planes,
               std::size_t points,
               double min_share = warning_constants.min_plane_share)
{
  const double all = static_cast<double> (points);
  double on_planes = 0.0;
  for (const PlaneSegment& plane : planes)
    if (plane.moments.count >= min_share * all)
      on_planes += plane.moments.count;
  return on_planes / all;
}

/** \brief The points on no plane around one of them: the points_per_part nearest ones,
 * or all if there are fewer.
 * \param[in] unassigned indices of the points on no plane
 * \param[in] center index of that one point in \p points
 * \return x, y, z, x, ... */
std::vector<float>
unassignedAround (const Points& points, const Indices& unassigned, std::uint32_t center)
{
  Indices nearest = unassigned;
  const auto isNearer = [&, position = points[center]] (std::uint32_t one,
                                                        std::uint32_t other) {
    return (points[one] - position).squaredNorm() <
           (points[other] - position).squaredNorm();
  };
  const std::size_t count =
      std::min (nearest.size(), warning_constants.points_per_part);
  std::nth_element (nearest.begin(),
                    nearest.begin() + static_cast<std::ptrdiff_t> (count - 1),
                    nearest.end(),
                    isNearer);
  nearest.resize (count);
  std::sort (nearest.begin(), nearest.end());
  std::vector<float> positions;
  for (const std::uint32_t i : nearest)
    positions.insert (positions.end(), {points.x[i], points.y[i], points.z[i]});
  return positions;
}

/** \brief Indices in \p points, the finite points of a cloud, of those on no plane.
 * \param[in] cloud_size number of all points of the cloud */
Indices
unassignedPoints (const Points& points,
                  std::size_t cloud_size,
                  const std::vector<PlaneSegment>& planes)
{
  std::vector<char> is_on_plane (cloud_size, 0);
  for (const PlaneSegment& plane : planes)
    for (const pcl::index_t index : plane.inliers)
      is_on_plane[static_cast<std::size_t> (index)] = 1;
  Indices unassigned;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_on_plane[static_cast<std::size_t> (points.indexOf (i))] == 0)
      unassigned.push_back (static_cast<std::uint32_t> (i));
  return unassigned;
}

/** \brief Whether points on no plane lie on planes if parts of them are searched
 * without the points on planes, as the sides of a thin wall do and trees do not. If so,
 * a search of the whole cloud is worth its time. */
bool
areUnassignedPointsFlat (const CloudView& cloud,
                         const std::vector<PlaneSegment>& planes,
                         const OpsParameters& parameters)
{
  const Points points = finitePoints (cloud, parameters.threads);
  const Indices unassigned = unassignedPoints (points, cloud.size, planes);
  const std::size_t wanted_parts = warning_constants.searched_parts;
  const Indices centers = sampleIndices (selected (points, unassigned), wanted_parts);
  for (std::size_t i = 0; i < std::min (centers.size(), wanted_parts); ++i) {
    const std::vector<float> part =
        unassignedAround (points, unassigned, unassigned[centers[i]]);
    constexpr std::size_t x_offset = 0;                    // [bytes]
    constexpr std::size_t point_step = 3 * sizeof (float); // [bytes]
    const CloudView view (part.data(), x_offset, point_step, part.size() / 3);
    if (shareOnPlanes (detectPlanes (view, parameters), view.size) <
        warning_constants.min_share_in_part)
      return false;
  }
  return !centers.empty();
}

} // namespace

std::optional<ResultWarning>
warnOfUnassignedPoints (const CloudView& cloud,
                        const LabeledSample& sample,
                        const std::vector<PlaneSegment>& planes,
                        const OpsParameters& search,
                        const ParameterText& text)
{
  if (sample.shareOnNoPlane() < warning_constants.min_share_on_none ||
      sample.finite_points > warning_constants.max_searched_again)
    return std::nullopt;
  OpsParameters given = search;
  given.on_stage = {}; // users see the stages of their own search alone
  std::vector<OtherSearch> searches = searchesWithDefaults (given, text);
  if (search.sampling_rate < warning_constants.high_sampling_rate) {
    const std::string rate = numberText (warning_constants.high_sampling_rate);
    OtherSearch finer{given, "give " + text.of ("sampling-rate", rate)};
    finer.parameters.sampling_rate = warning_constants.high_sampling_rate;
    OpsParameters of_parts = finer.parameters;
    of_parts.min_points = 0; // a part has fewer points than the cloud
    if (areUnassignedPointsFlat (cloud, planes, of_parts))
      searches.push_back (finer);
  }
  const double share_before = shareOnPlanes (planes, sample.finite_points);
  for (const OtherSearch& other : searches) {
    const std::vector<PlaneSegment> found = detectPlanes (cloud, other.parameters);
    const double share_on_all = shareOnPlanes (found, sample.finite_points, 0.0);
    if (shareOnPlanes (found, sample.finite_points) >=
            share_before + warning_constants.min_gained_share &&
        share_on_all >=
            1.0 - sample.shareOnNoPlane() + warning_constants.min_gained_share) {
      return ResultWarning{"unassigned-points",
                           percentText (sample.shareOnNoPlane()) +
                               " of the points are on no plane; for " +
                               percentText (share_on_all) + " on planes " +
                               other.advice};
    }
  }
  return std::nullopt;
}

std::optional<ResultWarning>
warnOfUnassignedPoints (const LabeledSample& sample,
                        const TiledSearch& tiles,
                        const ParameterText& text)
{
  const double share_on_no_plane = sample.shareOnNoPlane();
  if (share_on_no_plane < warning_constants.min_share_on_none)
    return std::nullopt;
  OpsParameters parameters;
  parameters.surfels.voxel_size = 0.5 * tiles.voxel_size;
  double sum_of_shares = 0.0; // of the points of a part that are on planes
  std::size_t searched_parts = 0;
  for (const CloudView& part : tiles.places_on_none) {
    if (part.size == 0)
      continue;
    const double share = shareOnPlanes (detectPlanes (part, parameters), part.size);
    if (share < warning_constants.min_share_in_part)
      return std::nullopt;
    sum_of_shares += share;
    ++searched_parts;
  }
  if (searched_parts == 0)
    return std::nullopt;
  const double mean_share = sum_of_shares / static_cast<double> (searched_parts);
  const double gained_share = mean_share * share_on_no_plane;
  if (gained_share < warning_constants.min_gained_share)
    return std::nullopt;
  return ResultWarning{
      "unassigned-points",
      percentText (share_on_no_plane) + " of the points are on no plane; for some " +
          percentText (1.0 - share_on_no_plane + gained_share) + " on planes give " +
          text.of ("voxel-size", roundedLength (*parameters.surfels.voxel_size))};
}

} // namespace pcl_ops::internal
