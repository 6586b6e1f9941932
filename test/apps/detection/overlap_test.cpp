// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <detection/overlap.h>

#include <numeric>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::apps;

/** \brief Adds a level square of 40 x 40 points to a cloud and returns its plane. The
 * points are 2 cm apart, every second one is 1 cm higher: the rms distance of the
 * points to the plane is 5 mm.
 * \param[in] x where the square begins [m]; in y it begins at 0
 * \param[in] height of the lower points [m] */
PlaneSegment
addSquare (float x, float height, XyzCloud& cloud)
{
  PlaneSegment plane;
  constexpr int steps = 40;
  for (int i = 0; i < steps * steps; ++i) {
    plane.inliers.push_back (static_cast<pcl::index_t> (cloud.size()));
    const float rise = i % 2 == 0 ? 0.0f : 0.01f;
    cloud.emplace_back (
        x + 0.02f * float (i / steps), 0.02f * float (i % steps), height + rise);
    const pcl::PointXYZ& point = cloud.back();
    plane.moments.add (point.x, point.y, point.z);
  }
  plane.centroid = plane.moments.centroid();
  return plane;
}

/** \brief The overlap of two squares of \ref addSquare: the first at x = 0 and height
 * 0, the second at the given x and height [m]. */
std::optional<OverlappingPlanes>
overlapOfSquares (float x, float height)
{
  XyzCloud cloud;
  const PlaneSegment first = addSquare (0.0f, 0.0f, cloud);
  return findOverlapping (cloud, {first, addSquare (x, height, cloud)});
}

TEST (FindOverlapping, FindsTwoPlanesOneAboveTheOtherAndTheirDistance)
{
  const auto found = overlapOfSquares (0.4f, 0.012f);
  ASSERT_TRUE (found);
  EXPECT_EQ (found->larger, 0u);
  EXPECT_EQ (found->smaller, 1u);
  EXPECT_NEAR (found->distance, 0.012, 1e-6);
}

TEST (FindOverlapping, FindsTwoPlanesASmallGapApart)
{
  // The first square ends at x = 0.78 m. The gap of 6 cm is 3 times the spacing.
  EXPECT_TRUE (overlapOfSquares (0.84f, 0.012f));
}

TEST (FindOverlapping, FindsNoPlanesALargeGapApart)
{
  EXPECT_FALSE (overlapOfSquares (1.5f, 0.012f));
}

TEST (FindOverlapping, FindsNoPlanesFartherApartThanThreeTimesTheirRms)
{
  // 3 times 5 mm are 15 mm.
  EXPECT_FALSE (overlapOfSquares (0.4f, 0.02f));
}

TEST (FindOverlapping, FindsNoPlanesThatAreNotParallel)
{
  XyzCloud cloud;
  const PlaneSegment first = addSquare (0.0f, 0.0f, cloud);
  PlaneSegment second = addSquare (0.4f, 0.0f, cloud);
  second.normal = Eigen::Vector3d (0.2, 0.0, 1.0).normalized();
  EXPECT_FALSE (findOverlapping (cloud, {first, second}));
}

} // namespace
