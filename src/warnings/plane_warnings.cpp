// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warnings/plane_warnings.h"

#include "cloud/point_tree.h"
#include "warnings/constants.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace pcl_ops::internal {

namespace {

/** \brief A plane fitted to points, and how they spread; 0 points if they span none. */
struct PlaneSpread {
  Plane plane;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  double points = 0.0;
  /** \brief rms distance of the points to this fit [m], even if the plane of the
   * segment is another one. */
  double rms = 0.0;
  /** \brief Sides of the rectangle that uniformly distributed points of the same
   * variances would fill [m]: a rectangle a x b gives a^2 / 12 and b^2 / 12. */
  double width = 0.0;
  double length = 0.0;

  /** \brief Distance of neighboring points, as if they were evenly spread [m]. */
  double
  spacing () const
  {
    return std::sqrt (width * length / points);
  }
};

PlaneSpread
spreadOf (const PlaneSegment& plane)
{
  PlaneSpread spread;
  const std::optional<PlaneFit> fit =
      plane.moments.count > 0.0 ? fitPlane (plane.moments) : std::nullopt;
  if (!fit)
    return spread;
  constexpr double squared_side_by_variance = 12.0;
  spread.plane = fit->plane;
  spread.centroid = fit->centroid;
  spread.points = plane.moments.count;
  spread.rms = std::sqrt (std::max (0.0, fit->variances[0]));
  spread.width = std::sqrt (squared_side_by_variance * fit->variances[1]);
  spread.length = std::sqrt (squared_side_by_variance * fit->variances[2]);
  return spread;
}

std::vector<PlaneSpread>
spreadsOf (const std::vector<PlaneSegment>& planes)
{
  std::vector<PlaneSpread> spreads;
  for (const PlaneSegment& plane : planes)
    spreads.push_back (spreadOf (plane));
  return spreads;
}

double
pointsOn (const std::vector<PlaneSpread>& planes)
{
  double points = 0.0;
  for (const PlaneSpread& plane : planes)
    points += plane.points;
  return points;
}

/** \brief Whether the angle between two planes is at most \p angle [rad]. */
bool
areWithin (double angle, const PlaneSpread& one, const PlaneSpread& other)
{
  return std::abs (one.plane.normal.dot (other.plane.normal)) >= std::cos (angle);
}

/** \brief The larger of the distances from a centroid to the other plane [m]. */
double
distanceBetween (const PlaneSpread& one, const PlaneSpread& other)
{
  return std::max (std::abs (one.plane.distance (other.centroid)),
                   std::abs (other.plane.distance (one.centroid)));
}

/** \param[in] sampled_share share of the survey's points that the sample has: the
 * spacing of all points is that of the sample times the root of this share */
bool
isThick (const PlaneSpread& spread,
         const std::optional<double>& noise,
         double sampled_share)
{
  return noise && spread.rms > warning_constants.thick_noises * *noise &&
         spread.rms > warning_constants.min_rms_of_spacing * std::sqrt (sampled_share) *
                          spread.spacing();
}

/** \brief The parameter for thinner planes: half the voxel size for a survey in tiles,
 * else a threshold of thick_noises times the noise.
 * \param[in] noise of the largest thick plane [m] */
std::string
fixOfThickPlanes (double noise,
                  const std::optional<TiledSearch>& tiles,
                  const ParameterText& text)
{
  if (tiles)
    return text.of ("voxel-size", roundedLength (0.5 * tiles->voxel_size));
  return text.of ("threshold", roundedLength (warning_constants.thick_noises * noise));
}

bool
isExact (const PlaneSpread& plane)
{
  return plane.points > 0.0 && plane.rms <= warning_constants.max_exact * plane.width;
}

/** \brief Whether two exact planes are levels, one behind the other. */
bool
areLevels (const PlaneSpread& one, const PlaneSpread& other)
{
  if (std::min (one.points, other.points) < warning_constants.min_points_of_level)
    return false;
  const double step = distanceBetween (one, other);
  const double width = std::min (one.width, other.width);
  const double between_centroids = (one.centroid - other.centroid).norm();
  const bool is_close =
      step > 0.0 && step < warning_constants.max_step_of_width * width;
  const bool is_behind = between_centroids < 0.5 * (one.length + other.length);
  return areWithin (warning_constants.max_angle_of_levels, one, other) && is_close &&
         is_behind;
}

/** \brief Distance to the nearest other level [m]; 0 if there is no other level. */
double
stepToNextLevel (const PlaneSpread& plane, const std::vector<PlaneSpread>& exact)
{
  double step = 0.0;
  for (const PlaneSpread& other : exact)
    if (const double distance = distanceBetween (plane, other);
        areLevels (plane, other) && (step == 0.0 || distance < step))
      step = distance;
  return step;
}

/** \brief Two planes by their positions in the list, the lower position first. */
using PlanePair = std::pair<std::int32_t, std::int32_t>;

/** \brief Numbers of neighbors of points on planes. */
struct NeighborCounts {
  /** \brief Neighbors on planes. */
  std::size_t all = 0;
  /** \brief Those on another plane that may be the same surface. */
  std::size_t mixed = 0;
  std::map<PlanePair, std::size_t> mixed_by_planes;
};

/** \brief Whether a point on one plane may also belong to another plane. */
bool
mayBeOnBoth (const Eigen::Vector3d& point,
             const PlaneSpread& own,
             const PlaneSpread& other)
{
  const double reach = warning_constants.rms_of_mixed * (own.rms + other.rms);
  return areWithin (warning_constants.max_angle_of_mixed, own, other) &&
         std::abs (other.plane.distance (point)) <= reach;
}

NeighborCounts
countNeighbors (const LabelledSample& sample, const std::vector<PlaneSpread>& planes)
{
  const PointTree tree (sample.points);
  // Evenly spread over the tree, and so over the cloud.
  const std::size_t step = sample.labels.size() / warning_constants.probes + 1;
  NeighborCounts counts;
  NearestPoints nearest;
  for (std::size_t position = 0; position < sample.labels.size(); position += step) {
    const std::uint32_t point = tree.order()[position];
    const std::int32_t own = sample.labels[point];
    if (own == no_plane)
      continue;
    nearest.start (warning_constants.neighbors_of_label + 1); // and the point itself
    tree.find (position, nearest);
    for (std::size_t k = 0; k < nearest.size(); ++k) {
      const std::int32_t other = sample.labels[nearest[k]];
      if (other == no_plane || nearest[k] == point)
        continue;
      ++counts.all;
      if (other == own || !mayBeOnBoth (sample[point], planes[own], planes[other]))
        continue;
      ++counts.mixed;
      ++counts.mixed_by_planes[std::minmax (own, other)];
    }
  }
  return counts;
}

} // namespace

std::optional<ResultWarning>
warnOfThickPlanes (const std::vector<PlaneSegment>& planes,
                   const std::optional<TiledSearch>& tiles,
                   const ParameterText& text)
{
  const double sampled_share = tiles ? tiles->sampled_share : 1.0;
  const std::vector<PlaneSpread> spreads = spreadsOf (planes);
  double on_thick = 0.0;
  std::optional<std::size_t> largest;
  for (std::size_t p = 0; p < planes.size(); ++p)
    if (isThick (spreads[p], planes[p].noise, sampled_share)) {
      on_thick += spreads[p].points;
      if (!largest || spreads[p].points > spreads[*largest].points)
        largest = p;
    }
  const double on_planes = pointsOn (spreads);
  if (!largest || on_thick < warning_constants.thick_share * on_planes)
    return std::nullopt;
  const double noise = *planes[*largest].noise;
  return ResultWarning{
      "thick-planes",
      percentText (on_thick / on_planes) +
          " of the points on planes are on planes thicker than three times their noise "
          "(rms " +
          roundedLength (spreads[*largest].rms) + ", noise " + roundedLength (noise) +
          " of the largest), as hills are; for thinner planes give " +
          fixOfThickPlanes (noise, tiles, text)};
}

std::optional<ResultWarning>
warnOfLevels (const std::vector<PlaneSegment>& planes,
              bool is_default_search,
              const ParameterText& text)
{
  const std::vector<PlaneSpread> spreads = spreadsOf (planes);
  std::vector<PlaneSpread> exact;
  std::copy_if (spreads.begin(), spreads.end(), std::back_inserter (exact), isExact);
  // Exact planes in several directions, small ones included, are faces of a model.
  for (const PlaneSpread& plane : exact)
    if (!areWithin (warning_constants.max_angle_of_levels, exact.front(), plane))
      return std::nullopt;
  double on_levels = 0.0;
  std::vector<float> steps;
  for (const PlaneSpread& plane : exact)
    if (const double step = stepToNextLevel (plane, exact); step > 0.0) {
      on_levels += plane.points;
      steps.push_back (static_cast<float> (step));
    }
  if (steps.size() < warning_constants.min_levels ||
      on_levels < warning_constants.level_share * pointsOn (spreads))
    return std::nullopt;
  const double step = medianOf (steps);
  const std::string edge = roundedLength (warning_constants.steps_of_voxel * step);
  return ResultWarning{
      "exact-levels",
      std::to_string (steps.size()) +
          " planes have an rms of 0 and lie one behind another, " +
          roundedLength (step) +
          " apart, as levels of a depth camera do; for whole surfaces " +
          (is_default_search ? "give " + text.of ("voxel-size", edge)
                             : "use " + text.ofWord ("method", "ops") + " without " +
                                   text.of ("voxel-size", ""))};
}

std::optional<ResultWarning>
warnOfMixedLabels (const LabelledSample& sample,
                   const std::vector<PlaneSegment>& planes,
                   const std::optional<TiledSearch>& tiles,
                   const ParameterText& text)
{
  const std::vector<PlaneSpread> spreads = spreadsOf (planes);
  const NeighborCounts counts = countNeighbors (sample, spreads);
  const auto all = static_cast<double> (counts.all);
  const auto mixed = static_cast<double> (counts.mixed);
  if (counts.mixed == 0 || mixed < warning_constants.mixed_share * all)
    return std::nullopt;
  const auto pair = std::max_element (
      counts.mixed_by_planes.begin(),
      counts.mixed_by_planes.end(),
      [] (auto& one, auto& other) { return one.second < other.second; });
  const auto [first, second] = pair->first;
  const double distance = distanceBetween (spreads[first], spreads[second]);
  const std::string fix =
      tiles ? text.of ("voxel-size", roundedLength (2.0 * tiles->voxel_size))
            : text.of ("merge-distance", roundedUpLength (distance));
  return ResultWarning{"mixed-labels",
                       percentText (mixed / all) +
                           " of the points next to one on a plane are on another one "
                           "of the same surface, "
                           "most on planes " +
                           text.planeNumber (first) + " and " +
                           text.planeNumber (second) + "; for one plane give " + fix};
}

} // namespace pcl_ops::internal
