// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/distinct_places.h"
#include "scene.h"

#include <algorithm>

using namespace pcl_ops::internal;

namespace {

/** \brief 300 points, many of which have the same x, and then copies of the first 50.
 */
Coordinates
pointsWithCopies ()
{
  Coordinates points;
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 300; ++i)
    points.add (static_cast<float> (drawBelow (generator, 9)),
                static_cast<float> (drawUnit (generator)),
                -1.0f);
  for (int i = 0; i < 50; ++i)
    points.add (points.x[i], points.y[i], points.z[i]);
  return points;
}

} // namespace

TEST (DistinctPlaces, HaveEqualPointsOnce)
{
  const Coordinates points = pointsWithCopies();
  const DistinctPlaces places = distinctPlaces (points, one_thread);
  EXPECT_EQ (places.size(), 300u);
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_EQ (places[places.of_input[i]], points[i]);
}

TEST (DistinctPlaces, ComeInTheSameOrderForAnyOrderOfPoints)
{
  Coordinates points = pointsWithCopies();
  const DistinctPlaces places = distinctPlaces (points, one_thread);
  ASSERT_EQ (places.size(), 300u);
  for (std::vector<float>* axis : {&points.x, &points.y, &points.z})
    std::reverse (axis->begin(), axis->end());
  const DistinctPlaces again = distinctPlaces (points, 2);
  EXPECT_EQ (again.x, places.x);
  EXPECT_EQ (again.y, places.y);
  EXPECT_EQ (again.z, places.z);
}

TEST (DistinctPlaces, OfZerosAreOne)
{
  Coordinates zeros;
  zeros.resize (20);
  EXPECT_EQ (distinctPlaces (zeros, one_thread).size(), 1u);
}
