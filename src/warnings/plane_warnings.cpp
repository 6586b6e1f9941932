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

/** \brief A plane fitted to the points of a segment, and how they spread. All numbers
 * are 0 if the points span no plane. */
struct PlaneSpread {
  Plane plane;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  double points = 0.0;
  /** \brief Rms distance of the points to this fit [m]; the plane of the segment may be
   * another one. */
  double rms = 0.0;
  /** \brief Sides of the rectangle that uniformly distributed points of the same
   * variances would fill [m]: a rectangle a x b gives a^2 / 12 and b^2 / 12. */
  double width = 0.0;
  double length = 0.0;

  /** \brief Distance between neighboring points, as if they were evenly spread [m]. */
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
  spread.rms = std::sqrt (fit->variances[0]);
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

/** \brief Number of the points of all planes. */
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

/** \brief Whether the rms distance of a plane's points is several times its noise and
 * more than a share of their spacing.
 * \param[in] noise of the plane [m]; a plane without it is not thick
 * \param[in] sampled_share share of a survey's points that are in the sample, else 1:
 * the spacing of all points is that of the sampled ones times the square root of it */
bool
isThick (const PlaneSpread& spread,
         const std::optional<double>& noise,
         double sampled_share)
{
  return noise && spread.rms > warning_constants.min_noises_of_thick * *noise &&
         spread.rms > warning_constants.min_spacings_of_thick *
                          std::sqrt (sampled_share) * spread.spacing();
}

/** \brief The parameter for thinner planes: half the voxel size for a survey in tiles,
 * else a threshold of min_noises_of_thick times the noise.
 * \param[in] noise of the largest thick plane [m] */
std::string
fixOfThickPlanes (double noise,
                  const std::optional<TiledSearch>& tiles,
                  const ParameterText& text)
{
  if (tiles)
    return text.of ("voxel-size", roundedLength (0.5 * tiles->voxel_size));
  return text.of ("threshold",
                  roundedLength (warning_constants.min_noises_of_thick * noise));
}

/** \brief Whether all points are on the plane, as far as single precision tells. */
bool
isExact (const PlaneSpread& plane)
{
  return plane.points > 0.0 &&
         plane.rms <= warning_constants.max_rms_of_exact * plane.width;
}

/** \brief Whether two exact planes are levels: nearly parallel, one close behind the
 * other. */
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

/** \brief Distance to the nearest other level [m]; 0 if there is no other level.
 * \param[in] exact_planes all of them, \p plane as well */
double
stepToNextLevel (const PlaneSpread& plane, const std::vector<PlaneSpread>& exact_planes)
{
  double step = 0.0;
  for (const PlaneSpread& other : exact_planes)
    if (const double distance = distanceBetween (plane, other);
        areLevels (plane, other) && (step == 0.0 || distance < step))
      step = distance;
  return step;
}

/** \brief Positions of two planes in the list of planes, the lower one first. */
using PlanePair = std::pair<std::int32_t, std::int32_t>;

/** \brief How many neighbors the searched points on planes have. */
struct NeighborCounts {
  /** \brief Neighbors that are on planes. */
  std::size_t all = 0;
  /** \brief Mixed neighbors: those on another plane than the point that may be the same
   * surface. */
  std::size_t mixed = 0;
  /** \brief Number of mixed neighbors for each pair of planes that has any. */
  std::map<PlanePair, std::size_t> mixed_of_planes;
};

/** \brief Whether a point on its \p own plane may also belong to another plane, as both
 * may be the same surface. */
bool
mayBeOnBoth (const Eigen::Vector3d& point,
             const PlaneSpread& own,
             const PlaneSpread& other)
{
  const double max_distance =
      warning_constants.max_distance_of_mixed * (own.rms + other.rms);
  return areWithin (warning_constants.max_angle_of_mixed, own, other) &&
         std::abs (other.plane.distance (point)) <= max_distance;
}

/** \brief Counts the nearest neighbors of up to searched_points of the sampled points.
 * \param[in] planes the spread of each plane, in the order of the sample's labels */
NeighborCounts
countNeighbors (const LabeledSample& sample, const std::vector<PlaneSpread>& planes)
{
  const PointTree tree (sample.points);
  // The searched points are evenly spread over the order of the tree, and so in space.
  const std::size_t step = sample.labels.size() / warning_constants.searched_points + 1;
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
      ++counts.mixed_of_planes[std::minmax (own, other)];
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
  double on_thick = 0.0;              // number of points
  std::optional<std::size_t> largest; // thick plane, by its position
  for (std::size_t p = 0; p < planes.size(); ++p)
    if (isThick (spreads[p], planes[p].noise, sampled_share)) {
      on_thick += spreads[p].points;
      if (!largest || spreads[p].points > spreads[*largest].points)
        largest = p;
    }
  const double on_planes = pointsOn (spreads);
  if (!largest || on_thick < warning_constants.min_share_on_thick * on_planes)
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
  std::vector<PlaneSpread> exact_planes;
  std::copy_if (
      spreads.begin(), spreads.end(), std::back_inserter (exact_planes), isExact);
  // Exact planes that are not parallel, small ones included, are faces of a model.
  for (const PlaneSpread& plane : exact_planes)
    if (!areWithin (warning_constants.max_angle_of_levels, exact_planes.front(), plane))
      return std::nullopt;
  double on_levels = 0.0;   // number of points
  std::vector<float> steps; // from each level to the next one [m]
  for (const PlaneSpread& plane : exact_planes)
    if (const double step = stepToNextLevel (plane, exact_planes); step > 0.0) {
      on_levels += plane.points;
      steps.push_back (static_cast<float> (step));
    }
  if (steps.size() < warning_constants.min_levels ||
      on_levels < warning_constants.min_share_on_levels * pointsOn (spreads))
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
warnOfMixedLabels (const LabeledSample& sample,
                   const std::vector<PlaneSegment>& planes,
                   const std::optional<TiledSearch>& tiles,
                   const ParameterText& text)
{
  const std::vector<PlaneSpread> spreads = spreadsOf (planes);
  const NeighborCounts counts = countNeighbors (sample, spreads);
  const auto all = static_cast<double> (counts.all);
  const auto mixed = static_cast<double> (counts.mixed);
  if (counts.mixed == 0 || mixed < warning_constants.min_mixed_share * all)
    return std::nullopt;
  const auto hasFewerMixed = [] (const auto& one, const auto& other) {
    return one.second < other.second;
  };
  const PlanePair most_mixed = std::max_element (counts.mixed_of_planes.begin(),
                                                 counts.mixed_of_planes.end(),
                                                 hasFewerMixed)
                                   ->first;
  const auto [first, second] = most_mixed;
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
