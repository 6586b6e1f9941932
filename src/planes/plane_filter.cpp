// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/angles.h"
#include <pcl_ops/plane_detector.h>
#include <pcl_ops/plane_filter.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops {
namespace {

using namespace internal;

/** \brief The member of DroppedPlanes that counts the planes that fail one test. */
using Counter = std::size_t DroppedPlanes::*;

bool
isFiniteAndNotNegative (double number)
{
  return number >= 0.0 && std::isfinite (number);
}

bool
isDirection (const Eigen::Vector3d& vector)
{
  return vector.allFinite() && !vector.isZero (0.0);
}

/** \brief Whether both are finite numbers, 0 or more, and low is not above high. */
bool
areBounds (double low, double high)
{
  return isFiniteAndNotNegative (low) && isFiniteAndNotNegative (high) && low <= high;
}

/** \brief Whether a plane has a length and a width.
 * \param[in] size both sides in any order, and a tolerance [m] */
bool
hasSize (const PlaneExtent& extent, const std::array<double, 3>& size)
{
  const auto [shorter, longer] = std::minmax (size[0], size[1]);
  const double tolerance = size[2];
  return std::abs (extent.length - longer) <= tolerance &&
         std::abs (extent.width - shorter) <= tolerance;
}

/** \return the counter of the first test that an extent fails; nullptr if it passes all
 */
Counter
failureOf (const PlaneExtent& extent, const PlaneFilter& filter)
{
  if (extent.area < filter.min_area)
    return &DroppedPlanes::by_area;
  if (extent.width < filter.min_width)
    return &DroppedPlanes::by_width;
  if (filter.max_area && extent.area > *filter.max_area)
    return &DroppedPlanes::by_max_area;
  if (filter.max_width && extent.width > *filter.max_width)
    return &DroppedPlanes::by_max_width;
  if (filter.size && !hasSize (extent, *filter.size))
    return &DroppedPlanes::by_size;
  return nullptr;
}

/** \return the counter of the first test that a plane fails; nullptr if it passes all
 * \param[in] filter its direction and up axis have length 1
 * \param[in] extent_of called only if a test needs the extent */
Counter
failureOf (const PlaneSegment& plane,
           const PlaneFilter& filter,
           const ExtentOfPlane& extent_of)
{
  if (filter.orientation && plane.orientation != *filter.orientation)
    return &DroppedPlanes::by_orientation;
  // A plane faces the direction if it is horizontal with the direction as up.
  if (filter.direction &&
      orientationOf (plane.normal, *filter.direction, filter.direction_tolerance) !=
          Orientation::Horizontal)
    return &DroppedPlanes::by_direction;
  const double slope = slopeOf (plane.normal, filter.up_axis);
  if (filter.slope && !(slope >= (*filter.slope)[0] && slope <= (*filter.slope)[1]))
    return &DroppedPlanes::by_slope;
  const double points = plane.inliers.empty()
                            ? plane.moments.count
                            : static_cast<double> (plane.inliers.size());
  if (points < static_cast<double> (filter.min_points))
    return &DroppedPlanes::by_points;
  const bool asks_for_extent = filter.min_area > 0.0 || filter.min_width > 0.0 ||
                               filter.max_area || filter.max_width || filter.size;
  return asks_for_extent ? failureOf (extent_of (plane), filter) : nullptr;
}

} // namespace

std::string
validate (const PlaneFilter& filter)
{
  if (filter.direction && !isDirection (*filter.direction))
    return "the direction must be a finite vector other than zero, or not be given";
  if (!(filter.direction_tolerance >= 0.0 &&
        filter.direction_tolerance <= max_right_angle))
    return "the direction tolerance must be between 0 and pi/2 (radians)";
  if (!isDirection (filter.up_axis))
    return "the up axis must be a finite vector other than zero";
  if (filter.slope && !(areBounds ((*filter.slope)[0], (*filter.slope)[1]) &&
                        (*filter.slope)[1] <= max_right_angle))
    return "the slope must be two angles between 0 and pi/2 (radians), rising";
  if (!isFiniteAndNotNegative (filter.min_area))
    return "the smallest area must be a number from 0";
  if (!isFiniteAndNotNegative (filter.min_width))
    return "the smallest width must be a length from 0";
  if (filter.max_area && !areBounds (filter.min_area, *filter.max_area))
    return "the largest area must be a number from the smallest area on";
  if (filter.max_width && !areBounds (filter.min_width, *filter.max_width))
    return "the largest width must be a length from the smallest width on";
  if (filter.size &&
      !std::all_of (filter.size->begin(), filter.size->end(), isFiniteAndNotNegative))
    return "the size must be two lengths and a tolerance from 0";
  return {};
}

std::vector<std::size_t>
keptPlanes (const std::vector<PlaneSegment>& planes,
            const PlaneFilter& filter,
            const ExtentOfPlane& extent_of,
            DroppedPlanes& dropped)
{
  detail::throwOn (validate (filter));
  dropped = {};
  PlaneFilter with_unit_vectors = filter;
  with_unit_vectors.up_axis.stableNormalize();
  if (with_unit_vectors.direction)
    with_unit_vectors.direction->stableNormalize();
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (const Counter failed_test = failureOf (planes[i], with_unit_vectors, extent_of))
      ++(dropped.*failed_test);
    else
      kept.push_back (i);
  if (filter.max_planes && kept.size() > *filter.max_planes) {
    dropped.by_number = kept.size() - *filter.max_planes;
    kept.resize (*filter.max_planes);
  }
  return kept;
}

DroppedPlanes
filterPlanes (std::vector<PlaneSegment>& planes,
              const PlaneFilter& filter,
              const ExtentOfPlane& extent_of)
{
  DroppedPlanes dropped;
  std::vector<PlaneSegment> kept;
  for (const std::size_t i : keptPlanes (planes, filter, extent_of, dropped))
    kept.push_back (std::move (planes[i]));
  planes = std::move (kept);
  return dropped;
}

DroppedPlanes
filterPlanes (std::vector<PlaneSegment>& planes,
              const PlaneFilter& filter,
              const CloudView& cloud)
{
  return filterPlanes (planes, filter, [&] (const PlaneSegment& plane) {
    return planeExtent (cloud, plane);
  });
}

} // namespace pcl_ops
