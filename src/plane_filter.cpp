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

using Count = std::size_t DroppedPlanes::*;

bool
isSize (double number)
{
  return number >= 0.0 && std::isfinite (number);
}

/** \brief A filter whose direction has length 1. */
class PlaneTest {
public:
  PlaneTest (const PlaneFilter& filter, const ExtentOfPlane& extent_of)
  : filter_ (filter), extent_of_ (extent_of)
  {
    if (filter_.direction)
      filter_.direction->stableNormalize();
  }

  /** \return where a plane counts that is dropped; nullptr for one that is kept */
  Count
  failureOf (const PlaneSegment& plane) const
  {
    if (filter_.orientation && plane.orientation != *filter_.orientation)
      return &DroppedPlanes::by_orientation;
    if (filter_.direction &&
        orientationOf (plane.normal, *filter_.direction, filter_.direction_tolerance) !=
            Orientation::Horizontal)
      return &DroppedPlanes::by_direction;
    if (plane.inliers.size() < filter_.min_points)
      return &DroppedPlanes::by_points;
    return asksForExtent() ? failureOf (extent_of_ (plane)) : nullptr;
  }

private:
  bool
  asksForExtent () const
  {
    return filter_.min_area > 0.0 || filter_.min_width > 0.0 || filter_.max_area ||
           filter_.max_width;
  }

  Count
  failureOf (const PlaneExtent& extent) const
  {
    if (extent.area < filter_.min_area)
      return &DroppedPlanes::by_area;
    if (extent.width < filter_.min_width)
      return &DroppedPlanes::by_width;
    if (filter_.max_area && extent.area > *filter_.max_area)
      return &DroppedPlanes::by_max_area;
    if (filter_.max_width && extent.width > *filter_.max_width)
      return &DroppedPlanes::by_max_width;
    return nullptr;
  }

  PlaneFilter filter_;
  const ExtentOfPlane& extent_of_;
};

} // namespace

std::string
validate (const PlaneFilter& filter)
{
  if (filter.direction &&
      (!filter.direction->allFinite() || filter.direction->isZero (0.0)))
    return "the direction must be a finite vector other than zero, or not be given";
  if (!(filter.direction_tolerance >= 0.0 && filter.direction_tolerance <= right_angle))
    return "the direction tolerance must be between 0 and pi/2 (radians)";
  if (!isSize (filter.min_area))
    return "the smallest area must be a number from 0";
  if (!isSize (filter.min_width))
    return "the smallest width must be a length from 0";
  if (filter.max_area &&
      !(isSize (*filter.max_area) && *filter.max_area >= filter.min_area))
    return "the largest area must be a number from the smallest area on";
  if (filter.max_width &&
      !(isSize (*filter.max_width) && *filter.max_width >= filter.min_width))
    return "the largest width must be a length from the smallest width on";
  return {};
}

DroppedPlanes
filterPlanes (std::vector<PlaneSegment>& planes,
              const PlaneFilter& filter,
              const ExtentOfPlane& extent_of)
{
  detail::throwOn (validate (filter));
  DroppedPlanes dropped;
  const PlaneTest test (filter, extent_of);
  const auto is_dropped = [&] (const PlaneSegment& plane) {
    const Count count = test.failureOf (plane);
    if (count != nullptr)
      ++(dropped.*count);
    return count != nullptr;
  };
  planes.erase (std::remove_if (planes.begin(), planes.end(), is_dropped),
                planes.end());
  if (filter.max_planes && planes.size() > *filter.max_planes) {
    dropped.by_number = planes.size() - *filter.max_planes;
    planes.resize (*filter.max_planes);
  }
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
