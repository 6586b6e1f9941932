// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/scenes.h>

#include <map>
#include <set>

using namespace pcl_ops::simulation;

namespace {

/** Returns the bounding box of a body after a rotation about z [rad]. */
Eigen::AlignedBox3d
boxAround (const Body& body, double turn)
{
  Body turned;
  turned.addPart (body, turnZ (turn));
  Eigen::AlignedBox3d box;
  for (const Shape& shape : turned.shapes)
    box.extend (bounding_box (shape));
  return box;
}

bool
areInOnePlane (const Shape& a, const Shape& b)
{
  constexpr double slightest_offset = 0.015; // below that of board furniture, 0.02 [m]
  return std::abs (a.normal().dot (b.normal())) > 0.99 &&
         std::abs (a.normal().dot (b.center - a.center)) < slightest_offset;
}

/** A shape at the origin, and how the points that are drawn on it are spread. */
struct PointSpread {
  Shape::Kind kind;
  double radius, height, share; // Shape::half_v, half_u and share
  double (*measure) (const Vector3d&);
  double lowest, limit, highest; // of what is measured
  double share_below;            // share of points below the limit
};

void
expectSpread (const PointSpread& spread)
{
  Shape shape{spread.kind, origin.translation(), Vector3d::UnitZ()};
  shape.half_u = spread.height;
  shape.half_v = spread.radius;
  shape.share = spread.share;
  Random random (7);
  int below = 0;
  for (int i = 0; i < 10000; ++i) {
    const SurfacePoint point = drawPoint (shape, random);
    const double measured = spread.measure (point.position);
    EXPECT_GE (measured, spread.lowest - 1e-9);
    EXPECT_LE (measured, spread.highest + 1e-9);
    below += measured < spread.limit;
    // Normals point away from the origin, but those of the inner half of a torus.
    const double outwards = point.normal.dot (point.position);
    EXPECT_TRUE (spread.kind == Shape::Kind::Torus || outwards >= -1e-9) << outwards;
  }
  EXPECT_NEAR (below, 1e4 * spread.share_below, 200) << spread.limit;
}

/** Position and label of the points of all tiles. */
std::set<std::array<double, 4>>
allPoints (const Town& town)
{
  std::set<std::array<double, 4>> points;
  for (std::uint32_t row = 0; row < town.tiles; ++row)
    for (std::uint32_t column = 0; column < town.tiles; ++column)
      for (const auto& [position, label] : surveyTile (town, column, row, 1.0))
        points.insert ({position.x(), position.y(), position.z(), double (label)});
  return points;
}

} // namespace

TEST (Scene, RayMeetsTheNearestShapeOnItsSkin)
{
  Scene scene = wallsAt ({{0, 0, 8}, {-20, 0, 6}});
  Body round;
  round.addSphere ({1, 0, 3}, 0.5);
  round.addCylinder ({3, 0, 3}, Vector3d::UnitY(), 1.0, 0.5);
  round.addCylinder ({6, 0, 3}, Vector3d::UnitZ(), 1.0, 0.5);
  scene.add (round, origin);
  const ShapeTree tree = treeOf (scene);
  const struct {
    double x, y, slant, distance;
    SurfaceId surface;
  } rows[] = {{0, 0, -0.1, 6.0, 2},
              {0, 0, 0.01, 8.0, 1},
              {1, 0, 0, 2.5, no_surface},
              {3, 0.9, 0, 2.5, no_surface},
              {3, 1.1, 0, 8.0, 1},
              {6.2, 0, 0.01, 2.0, no_surface}}; // the end of a cylinder
  for (const auto& row : rows) {
    const Hit hit = castRay (tree, {row.x, row.y, 0}, {row.slant, 0, 1});
    EXPECT_NEAR (hit.distance, row.distance, 1e-12) << row.x;
    EXPECT_EQ (hit.surface, row.surface) << row.x;
  }
  EXPECT_TRUE (std::isinf (castRay (tree, {0, 0, 0}, {0, 0, -1}).distance));
}

TEST (Scene, RayMeetsTheNearestOfAllShapesOneByOne)
{
  const Scene scene = makeRoom (7).scene;
  const ShapeTree tree = treeOf (scene);
  const Vector3d eye (0.0, 0.0, 1.5);
  Random random (7);
  for (int i = 0; i < 500; ++i) {
    const Vector3d ray = random.inBox ({-1, -1, -1}, {1, 1, 1});
    double nearest = std::numeric_limits<double>::infinity();
    for (const Body& body : scene.bodies)
      for (const Shape& shape : body.shapes) {
        const ShapeTree alone (&shape, &shape + 1);
        nearest = std::min (nearest, castRay (alone, eye, ray).distance);
      }
    EXPECT_EQ (castRay (tree, eye, ray).distance, nearest);
  }
}

TEST (Scene, FacesOfABoxAreSurfacesOfTheirOwnUnlessNarrow)
{
  Body board;
  board.addBox (origin, {1.0, 0.6, 0.03});
  EXPECT_EQ (board.shapes.size(), 6u);
  EXPECT_EQ (board.surface_count, 2u);
}

TEST (BoardFurniture, EveryFaceIsAPlaneOfItsOwn)
{
  Random random (7);
  for (const auto draw : {drawBoardTable, drawBoardBench, drawBoardRack}) {
    const Shapes faces = draw (random).shapes;
    ASSERT_GT (faces.size(), 1u);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      EXPECT_EQ (faces[i].surface, i + 1);
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE (areInOnePlane (faces[i], faces[j])) << i << ' ' << j;
    }
  }
}

TEST (Corner, HasPiecesApartFromEachOtherWithinTheWalls)
{
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE (seed);
    const Site corner = makeFurnishedCorner (seed);
    EXPECT_GE (corner.scene.bodies.size(), 4u);
    const Vector3d half (0.5 * corner.size.x(), 0.5 * corner.size.y(), 1e9);
    const Eigen::AlignedBox3d room (Vector3d (-half.x(), -half.y(), 0.0), half);
    std::vector<Eigen::AlignedBox3d> placed;
    for (std::size_t i = 1; i < corner.scene.bodies.size(); ++i) { // 0: floor, walls
      const Eigen::AlignedBox3d piece = boxAround (corner.scene.bodies[i], -corner.yaw);
      EXPECT_TRUE (room.intersection (piece).sizes().isApprox (piece.sizes(), 1e-6));
      for (const Eigen::AlignedBox3d& other : placed)
        EXPECT_GT (other.exteriorDistance (piece), 0.05);
      placed.push_back (piece);
    }
  }
}

TEST (Survey, HasNoGroundInAHouseAndNothingOutOfTheRoof)
{
  constexpr double margin = 0.1; // [m]
  const House house;             // in the middle of its ground, with a ridge along x
  const double rise = 2.0 * (house.ridge - house.eaves) / house.width;
  const LabeledCloud cloud = scanSurvey ({{house}, 30.0}, 5000, 0.0, 7).cloud;
  ASSERT_FALSE (cloud.empty());
  for (const auto& point : cloud) {
    EXPECT_GT (point.label, 0u);
    const bool is_inside = std::abs (point.x) < 0.5 * house.length - margin &&
                           std::abs (point.y) < 0.5 * house.width - margin;
    EXPECT_FALSE (is_inside && point.z < house.eaves - margin);
    const double roof = house.ridge - rise * std::abs (point.y);
    EXPECT_TRUE (point.z == 0.0f || point.z < roof + 5.0 * rounding) << point.z;
  }
}

TEST (Town, HasTheSamePointsInAnyNumberOfTilesAboutAsManyAsAskedFor)
{
  constexpr double asked = 3e5;
  const auto points = allPoints (makeTown (1, asked, 1));
  EXPECT_TRUE (points == allPoints (makeTown (1, asked, 8))); // that is 9
  EXPECT_NEAR (double (points.size()) / asked, 1.0, 0.2);
}

TEST (Town, HasAPlaneForEachLabel)
{
  constexpr double enough_points = 500;
  std::map<std::uint32_t, pcl_ops::Moments> planes;
  const Town town = makeTown (2, 1e5, 1);
  for (const TownPoint& point : surveyTile (town, 0, 0, 1.0)) {
    const Vector3d local = point.position - town.corner;
    planes[point.label].add (local.x(), local.y(), local.z());
  }
  EXPECT_GT (planes.size(), 10u);
  for (const auto& [label, moments] : planes)
    if (moments.count >= enough_points) {
      const auto fit = pcl_ops::fitPlane (moments);
      ASSERT_TRUE (fit);
      EXPECT_NEAR (std::sqrt (fit->variances[0]), survey_sigma, 0.002) << label;
    }
}

TEST (Street, WindowsOfAHouseAreOnePlaneBehindTheFacade)
{
  constexpr int max_faces_of_a_car = 10;
  int houses = 0;
  for (const Body& body : makeStreet (7).scene.bodies) {
    int flat = 0;
    std::set<SurfaceId> facing; // surfaces parallel to the facade, the first shape
    for (const Shape& shape : body.shapes) {
      flat += shape.surface != no_surface;
      if (std::abs (shape.normal().dot (body.shapes[0].normal())) > 0.99)
        facing.insert (shape.surface);
    }
    if (flat <= max_faces_of_a_car)
      continue;
    ++houses;
    EXPECT_EQ (facing.size(), 3u); // facade, windows, door
  }
  EXPECT_GT (houses, 10);
}

TEST (SurfacePoints, AreEvenlyDenseWithinTheirShape)
{
  using Kind = Shape::Kind;
  const auto heightOf = [] (const Vector3d& p) { return p.z(); };
  const auto radiusOf = [] (const Vector3d& p) { return p.head<2>().norm(); };
  const auto aroundOf = [] (const Vector3d& p) { // from +y
    return std::abs (std::atan2 (p.x(), p.y()));
  };
  const PointSpread rows[] = {
      // The upper half of a cone, with its apex at zero, has a quarter of the area.
      {Kind::Cone, 0.5, 1.0, 1.0, heightOf, -1.0, -0.5, 0.0, 0.75},
      // Slices of a sphere with the same height have the same area (Archimedes).
      {Kind::Dome, 1.0, 0.2, 1.0, heightOf, 0.8, 0.9, 1.0, 0.5},
      // The centroid of the inner half circle is 2 * 0.15 / pi nearer to the axis than
      // 0.5, and areas are as the radii of centroids (Pappus).
      {Kind::Torus, 0.5, 0.15, 1.0, radiusOf, 0.35, 0.5, 0.65, 0.5 - 0.3 / pi},
      // A quarter of a cylinder extends 45 degrees to either side of +y.
      {Kind::Cylinder, 0.1, 0.5, 0.25, aroundOf, 0, pi / 8, pi / 4, 0.5}};
  for (const PointSpread& spread : rows)
    expectSpread (spread);
}
