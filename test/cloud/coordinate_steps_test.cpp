// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/coordinate_steps.h"
#include "scene.h"

using namespace pcl_ops::internal;
using namespace pcl_ops;

namespace {

/** \brief The nearest multiple of the step; the length itself if the step is 0. */
double
rounded (double length, double step)
{
  return step > 0.0 ? step * std::round (length / step) : length;
}

/** \brief Points drawn in a cube of 5 m, rounded to these steps along x, y and z [m];
 * an axis with a step of 0 is not rounded.
 * \param[in] offset of all coordinates, added after they are rounded [m] */
Coordinates
cubeRoundedTo (const Eigen::Vector3d& steps, double offset = 0.0)
{
  RandomGenerator generator (seedOfTest());
  Coordinates points;
  for (int i = 0; i < 3000; ++i) {
    std::array<float, 3> point;
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = static_cast<float> (
          offset + rounded (5.0 * drawUnit (generator), steps[axis]));
    points.add (point[0], point[1], point[2]);
  }
  return points;
}

} // namespace

TEST (CoordinateSteps, AreThoseOfEachAxis)
{
  for (const Eigen::Vector3d& steps :
       {Eigen::Vector3d (1_cm, 1_cm, 1_cm), {0.0, 0.0, 1_mm}, {2_mm, 5_mm, 0.0}})
    for (const double multiple_of_steps : {0.0, 100.04}) {
      const Coordinates points = cubeRoundedTo (steps, multiple_of_steps);
      EXPECT_LT ((coordinateSteps (points) - steps).norm(), 1e-4)
          << steps.transpose() << ", " << multiple_of_steps;
    }
}

TEST (CoordinateSteps, OfTwoHeightsOneStepApartAreThatStep)
{
  Coordinates floor = cubeRoundedTo ({1_cm, 1_cm, 0.0});
  for (std::size_t i = 0; i < floor.size(); ++i)
    floor.z[i] = i % 2 == 0 ? 2.93f : 2.94f;
  EXPECT_NEAR (coordinateSteps (floor).z(), 1_cm, 1e-4);
  // Heights 4 cm apart are both sides of a board and no steps.
  for (std::size_t i = 0; i < floor.size(); i += 2)
    floor.z[i] = 2.9f;
  EXPECT_EQ (coordinateSteps (floor).z(), 0.0);
}

TEST (CoordinateSteps, OfNoPointsAreZero)
{
  EXPECT_EQ (coordinateSteps ({}), Eigen::Vector3d (0.0, 0.0, 0.0));
}
