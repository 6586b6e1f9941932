// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/buildings/plane_regularization.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

using Eigen::Vector3d;
using namespace pcl_ops;

namespace {

constexpr double noise = 3_mm; // of all points

/** \brief Noisy squares of 2 m x 2 m as a detector returns them. */
struct Squares {
  pcl::PointCloud<pcl::PointXYZ> cloud = {};
  std::vector<PlaneSegment> planes = {};
  RandomGenerator generator = RandomGenerator (seedOfTest());

  /** \brief Adds a square of steps x steps points and the plane fitted to them, whose
   * normal points to the same side as the given one. */
  Squares&
  add (const Vector3d& normal, const Vector3d& center, int steps = 40)
  {
    const Vector3d first = normal.unitOrthogonal();
    const Vector3d second = normal.cross (first).normalized();
    pcl::Indices inliers;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        inliers.push_back (static_cast<pcl::index_t> (cloud.size()));
        cloud.push_back (
            toPoint (center + (2.0 * i / steps - 1.0) * first +
                     (2.0 * j / steps - 1.0) * second +
                     noise * drawGaussian (generator) * normal.normalized()));
      }
    planes.push_back (planeOfPoints (cloud, inliers, normal.normalized()));
    const std::optional<PlaneFit> fit = fitPlane (planes.back().moments);
    planes.back().normal =
        fit->plane.normal.dot (normal) < 0.0 ? -fit->plane.normal : fit->plane.normal;
    planes.back().centroid = fit->centroid;
    return *this;
  }

  /** \brief The planes after regularizePlanes. */
  RegularizedPlanes
  regularized (const PlaneRegularizationParameters& parameters = {}) const
  {
    return regularizePlanes (planes, parameters);
  }
};

/** \brief A floor, two opposite walls and a wall at right angles to them, in this
 * order. */
Squares
box ()
{
  Squares box;
  box.add ({0, 0, 1}, {0, 0, 0})
      .add ({1, 0, 0}, {-2, 0, 1})
      .add ({-1, 0, 0}, {2, 0, 1});
  return box.add ({0, 1, 0}, {0, -2, 1});
}

/** \brief A plane of 100 points along y and z, at this x.
 * \param[in] side 1 if its normal points along +x, -1 if along -x
 * \param[in] rms distance of the points to it [m] */
PlaneSegment
uprightAt (double x, double side, double rms)
{
  PlaneSegment plane;
  plane.normal = {side, 0.0, 0.0};
  plane.centroid = {x, 0.0, 0.0};
  const Vector3d variances (rms * rms, 1.0, 1.0);
  plane.moments = Moments::of (100.0, plane.centroid, variances.asDiagonal());
  return plane;
}

/** \brief Fails unless the same planes become coplanar in reverse order of planes. */
void
expectSameLevelsInReverse (std::vector<PlaneSegment> planes)
{
  PlaneRegularizationParameters any_displacement;
  any_displacement.max_displacement = 1e3;
  const std::vector<PlaneMove> moves =
      regularizePlanes (planes, any_displacement).moves;
  std::reverse (planes.begin(), planes.end());
  std::vector<PlaneMove> reversed = regularizePlanes (planes, any_displacement).moves;
  std::reverse (reversed.begin(), reversed.end());
  for (std::size_t i = 0; i < moves.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_EQ (moves[i].level == moves[j].level,
                 reversed[i].level == reversed[j].level)
          << i << " and " << j;
}

/** \brief Cosine of the angle between the normals. */
double
cosine (const PlaneSegment& first, const PlaneSegment& second)
{
  return first.normal.dot (second.normal);
}

} // namespace

TEST (PlaneRegularization, MakesWallsAndFloorExactlyOrthogonalAndOppositeWallsParallel)
{
  const RegularizedPlanes found = box().regularized();
  EXPECT_NEAR (cosine (found.planes[0], found.planes[1]), 0.0, 1e-12);
  EXPECT_NEAR (cosine (found.planes[0], found.planes[3]), 0.0, 1e-12);
  EXPECT_NEAR (cosine (found.planes[1], found.planes[3]), 0.0, 1e-12);
  EXPECT_NEAR (cosine (found.planes[1], found.planes[2]), -1.0, 1e-12);
  EXPECT_EQ (found.moves[1].direction, found.moves[2].direction);
  EXPECT_NE (found.moves[1].level, found.moves[2].level);
}

TEST (PlaneRegularization, LeavesPointsWithinTheNoiseOfTheirPlanes)
{
  const Squares scene = box();
  const RegularizedPlanes found = scene.regularized();
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    EXPECT_TRUE (found.moves[i].is_moved) << i;
    EXPECT_LT (found.planes[i].rms(), 1.1 * scene.planes[i].rms()) << i;
  }
}

TEST (PlaneRegularization, SaysByHowMuchPlanesWereMoved)
{
  const Squares scene = box();
  const RegularizedPlanes found = scene.regularized();
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    const double angle = angleBetween (scene.planes[i], found.planes[i]);
    EXPECT_NEAR (found.moves[i].angle, angle, 1e-9);
    EXPECT_GT (found.moves[i].displacement, 0.0);
  }
}

TEST (PlaneRegularization, MakesPartsOfOneWallCoplanar)
{
  Squares scene;
  scene.add ({1, 0, 0}, {0, 0, 1})
      .add ({1, 0, 0}, {2_mm, 5, 1})
      .add ({1, 0, 0}, {0.2, 9, 1});
  const RegularizedPlanes found = scene.regularized();
  const PlaneSegment &first = found.planes[0], &second = found.planes[1];
  EXPECT_NEAR (first.normal.dot (second.centroid - first.centroid), 0.0, 1e-12);
  EXPECT_EQ (found.moves[0].level, found.moves[1].level);
  EXPECT_NE (found.moves[0].level, found.moves[2].level) << "20 cm before it";
  EXPECT_EQ (found.moves[0].direction, found.moves[2].direction);
}

TEST (PlaneRegularization, MakesPartsOfOneWallCoplanarThoughOneBeforeItIsOfASizeBetween)
{
  Squares scene;
  scene.add ({1, 0, 0}, {0, 0, 1}, 60)
      .add ({1, 0, 0}, {0.2, 9, 1}, 50)
      .add ({1, 0, 0}, {1_mm, 5, 1}, 40);
  const RegularizedPlanes found = scene.regularized();
  EXPECT_EQ (found.moves[0].level, found.moves[2].level);
  EXPECT_NE (found.moves[0].level, found.moves[1].level) << "20 cm before it";
}

TEST (PlaneRegularization, KeepsPartsApartThatAreThreeTimesTheNoiseOfBothFromEachOther)
{
  // The noise of both is sqrt (2) * 3 mm; three times that are 13 mm.
  PlaneRegularizationParameters any_displacement;
  any_displacement.max_displacement = 1e3;
  const auto areOnOneLevel = [&] (double distance) {
    Squares parts;
    parts.add ({1, 0, 0}, {0, 0, 1}).add ({1, 0, 0}, {distance, 5, 1});
    const RegularizedPlanes found = parts.regularized (any_displacement);
    return found.moves[0].level == found.moves[1].level;
  };
  EXPECT_TRUE (areOnOneLevel (10_mm));
  EXPECT_FALSE (areOnOneLevel (16_mm));
}

TEST (PlaneRegularization, HasTheSameLevelsInReverseOrderOfPlanes)
{
  // Of three planes in a row, each 10 mm behind the one before, two neighbors can
  // become coplanar, not all three: three times the noise of two planes are 13 mm.
  expectSameLevelsInReverse ({uprightAt (0.0, 1.0, noise),
                              uprightAt (10_mm, 1.0, noise),
                              uprightAt (20_mm, -1.0, noise)});
  // Of two planes at one position, the one with more noise is near enough to the third.
  expectSameLevelsInReverse ({uprightAt (0.0, 1.0, noise),
                              uprightAt (16_mm, 1.0, noise),
                              uprightAt (16_mm, 1.0, 3 * noise)});
}

TEST (PlaneRegularization, LeavesARoofOf30DegreesAsItIs)
{
  Squares scene = box();
  scene.add ({0, std::sin (30_deg), std::cos (30_deg)}, {0, 0, 4});
  const RegularizedPlanes found = scene.regularized();
  EXPECT_NEAR (angleBetween (found.planes[4], scene.planes[4]), 0.0, 0.2_deg);
  EXPECT_NEAR (cosine (found.planes[4], found.planes[1]), 0.0, 1e-12)
      << "its eaves are level";
}

TEST (PlaneRegularization, SaysThatAPlaneAloneStaysWhereItIs)
{
  for (const Vector3d& normal : {Vector3d (1, 2, 3), {-3, 1, 1}, {1, 5, -2}}) {
    Squares alone;
    alone.add (normal, {100, 20, 3});
    EXPECT_FALSE (alone.regularized().moves[0].is_moved) << normal.transpose();
  }
}

TEST (PlaneRegularization, LeavesPlanesThatWouldMoveFartherThanTheirNoise)
{
  Squares scene = box();
  // A wall that is 2.5 degrees off the right angle to another wall.
  scene.add ({1, std::tan (2.5_deg), 0}, {5, 0, 1});
  const RegularizedPlanes found = scene.regularized();
  EXPECT_FALSE (found.moves[4].is_moved);
  EXPECT_EQ (found.moves[4].angle, 0.0);
  EXPECT_GT (found.moves[4].displacement, 1.0);
  EXPECT_EQ (found.planes[4].normal, scene.planes[4].normal);
  EXPECT_NEAR (cosine (found.planes[0], found.planes[1]), 0.0, 1e-12) << "the others";
}

TEST (PlaneRegularization, MakesWallsParallelThatLeanToBothSidesOfOneRightAngle)
{
  // Two walls with an angle of 7 degrees between them, each 3.5 degrees off the right
  // angle to the floor.
  PlaneRegularizationParameters parameters;
  parameters.max_angle = 5_deg;
  parameters.max_displacement = 1e3;
  Squares scene;
  scene.add ({0, 0, 1}, {0, 0, 0}, 60).add ({0, 1, 0}, {0, 2, 1}, 60);
  scene.add ({1, 0, std::tan (3.5_deg)}, {-2, 0, 1});
  scene.add ({1, 0, -std::tan (3.5_deg)}, {2, 0, 1});
  const RegularizedPlanes found = scene.regularized (parameters);
  EXPECT_NEAR (cosine (found.planes[2], found.planes[3]), 1.0, 1e-12);
  EXPECT_EQ (found.moves[2].direction, found.moves[3].direction);
}

TEST (PlaneRegularization, KeepsTheSidesThatNormalsPointTo)
{
  const Squares scene = box();
  const RegularizedPlanes found = scene.regularized();
  for (std::size_t i = 0; i < scene.planes.size(); ++i)
    EXPECT_GT (cosine (found.planes[i], scene.planes[i]), 0.99);
}

TEST (PlaneRegularization, IsTheSameInUtmCoordinates)
{
  const Squares scene = box();
  const Vector3d shift (500'000, 5'400'000, 100);
  std::vector<PlaneSegment> moved = scene.planes;
  for (PlaneSegment& plane : moved)
    plane.moveBy (shift);
  const RegularizedPlanes here = scene.regularized();
  const RegularizedPlanes there = regularizePlanes (moved);
  EXPECT_NEAR (cosine (there.planes[0], there.planes[1]), 0.0, 1e-12);
  for (std::size_t i = 0; i < moved.size(); ++i)
    EXPECT_LT ((here.planes[i].normal - there.planes[i].normal).norm(), 1e-9);
}

TEST (PlaneRegularization, LeavesPlanesWithoutPointsAsTheyAre)
{
  std::vector<PlaneSegment> planes = box().planes;
  for (const double y : {0.0, 1e-3}) { // nearly parallel to each other and to a wall
    PlaneSegment& empty = planes.emplace_back();
    empty.normal = Vector3d (1, y, 0).normalized();
    empty.centroid = {5, 0, 1};
  }
  const RegularizedPlanes found = regularizePlanes (planes);
  for (const std::size_t i : {4u, 5u}) {
    EXPECT_FALSE (found.moves[i].is_moved) << i;
    EXPECT_EQ (found.planes[i].normal, planes[i].normal) << i;
    EXPECT_EQ (found.planes[i].centroid, planes[i].centroid) << i;
  }
  EXPECT_NE (found.moves[4].level, found.moves[5].level);
  EXPECT_NEAR (cosine (found.planes[1], found.planes[2]), -1.0, 1e-12) << "the others";
}

TEST (PlaneRegularization, OfNoPlanesIsEmpty)
{
  EXPECT_TRUE (Squares().regularized().planes.empty());
}

TEST (PlaneRegularization, RefusesInvalidParameters)
{
  const Squares scene = box();
  PlaneRegularizationParameters wrong;
  wrong.max_angle = 1.0;
  EXPECT_THROW (scene.regularized (wrong), std::invalid_argument);
  wrong = {};
  wrong.max_displacement = 0.0;
  EXPECT_THROW (scene.regularized (wrong), std::invalid_argument);
  wrong = {};
  wrong.max_offset = -1.0;
  EXPECT_THROW (scene.regularized (wrong), std::invalid_argument);
}

TEST (PlaneRegularization, RefusesPlanesThatAreNotFinite)
{
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double length : {1e200, infinite}) {
    std::vector<PlaneSegment> planes = box().planes;
    planes[0].normal = Vector3d (0.0, 0.0, length);
    EXPECT_THROW (regularizePlanes (planes), std::invalid_argument) << length;
  }
  std::vector<PlaneSegment> planes = box().planes;
  planes[0].centroid.x() = infinite;
  EXPECT_THROW (regularizePlanes (planes), std::invalid_argument);
}
