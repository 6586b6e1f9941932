// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/plane_edges.h>

#include <stdexcept>

using Eigen::Vector3d;
using namespace pcl_ops;

namespace {

/** \brief The planes of a scene as a perfect detector returns them, in the order of the
 * surfaces. */
std::vector<PlaneSegment>
planesOf (const LabeledScene& scene)
{
  std::vector<pcl::Indices> inliers (scene.surfaces.size());
  for (std::size_t i = 0; i < scene.labels.size(); ++i)
    inliers[static_cast<std::size_t> (scene.labels[i])].push_back (
        static_cast<pcl::index_t> (i));
  std::vector<PlaneSegment> planes;
  for (std::size_t p = 0; p < inliers.size(); ++p)
    planes.push_back (
        planeOfPoints (*scene.cloud, inliers[p], scene.surfaces[p].normal()));
  return planes;
}

/** \brief The edges between the planes of a scene. */
PlaneEdges
edgesOf (const LabeledScene& scene, const PlaneEdgeParameters& parameters = {})
{
  return findPlaneEdges (*scene.cloud, planesOf (scene), parameters);
}

/** \brief Builds a scene whose last surface is a part of an earlier plane: its points
 * get the label of that plane. */
LabeledScene
withLastSurfaceOnPlane (int plane, Scene scene)
{
  LabeledScene built = scene.build();
  const int last_surface = static_cast<int> (built.surfaces.size()) - 1;
  std::replace (built.labels.begin(), built.labels.end(), last_surface, plane);
  built.surfaces.pop_back();
  return built;
}

/** \brief The corner of a room: a floor of 4 m x 3 m and two walls, 2.5 m high, along x
 * and along y. Their common corner is zero. */
Scene
corner ()
{
  return room().noise (0.0).clutter (0.0);
}

/** \brief The edge of two planes, by their indices; fails unless there is exactly one.
 */
PlaneEdge
edgeBetween (const PlaneEdges& found, std::size_t first, std::size_t second)
{
  PlaneEdge edge;
  int number = 0;
  for (const PlaneEdge& candidate : found.edges)
    if (candidate.planes == std::array<std::size_t, 2>{first, second}) {
      edge = candidate;
      ++number;
    }
  EXPECT_EQ (number, 1) << "edges of planes " << first << " and " << second;
  return edge;
}

/** \brief Fails unless the ends of an edge are near these two, in either order. */
void
expectRuns (const PlaneEdge& edge,
            const Vector3d& one_end,
            const Vector3d& other_end,
            double max_distance)
{
  const bool begins_at_other_end =
      (edge.from - one_end).norm() > (edge.from - other_end).norm();
  const Vector3d& from = begins_at_other_end ? other_end : one_end;
  const Vector3d& to = begins_at_other_end ? one_end : other_end;
  EXPECT_LT ((edge.from - from).norm(), max_distance) << edge.from.transpose();
  EXPECT_LT ((edge.to - to).norm(), max_distance) << edge.to.transpose();
}

/** \brief The default parameters, apart from this member. */
template <typename Member>
PlaneEdgeParameters
parametersWith (Member PlaneEdgeParameters::*member, double value)
{
  PlaneEdgeParameters parameters;
  parameters.*member = value;
  return parameters;
}

/** \brief A floor, and a ramp that rises from its side x = 2 m by an angle [rad].
 * \param[in] gap between the floor and the ramp [m] */
Scene
floorAndRamp (double angle, double gap = 0.0)
{
  const Vector3d upwards (2 * std::cos (angle), 0, 2 * std::sin (angle));
  return Scene().floor (2_m - gap, 2_m).surface ({2, 0, 0}, upwards, {0, 2, 0});
}

/** \brief A floor from x = 0 to 2 m, and over the line y = 0 of its side a wall 2 m
 * long that begins at x and at a height above the floor [m]. */
Scene
floorAndWall (double x, double height)
{
  return Scene().floor (2_m, 1_m).surface ({x, 0, height}, {2, 0, 0}, {0, 0, 1});
}

} // namespace

TEST (PlaneEdges, OfTheCornerOfARoomAreThreeThatMeetThere)
{
  // With a max_gap of 100 m the corner is near enough to both ends of each edge.
  PlaneEdgeParameters usual, far_reaching;
  far_reaching.max_gap = 100_m;
  for (const PlaneEdgeParameters& parameters : {usual, far_reaching}) {
    const PlaneEdges found = edgesOf (corner().build(), parameters);
    EXPECT_EQ (found.edges.size(), 3u);
    expectRuns (edgeBetween (found, 0, 1), {0, 0, 0}, {4, 0, 0}, 5_cm);
    expectRuns (edgeBetween (found, 0, 2), {0, 0, 0}, {0, 3, 0}, 5_cm);
    expectRuns (edgeBetween (found, 1, 2), {0, 0, 0}, {0, 0, 2.5}, 5_cm);
    ASSERT_EQ (found.corners.size(), 1u);
    EXPECT_EQ (found.corners[0].planes, (std::array<std::size_t, 3>{0, 1, 2}));
    const Vector3d position = found.corners[0].position;
    EXPECT_LT (position.norm(), 1e-6);
    for (const PlaneEdge& edge : found.edges)
      EXPECT_EQ (std::min ((edge.from - position).norm(), (edge.to - position).norm()),
                 0.0)
          << "an edge ends at the corner";
  }
}

TEST (PlaneEdges, NeedPointsOfBothPlanesBesideTheLine)
{
  Scene table;
  table.floor (4_m, 4_m).surface ({1, 1, 0.7}, {1, 0, 0}, {0, 1, 0}); // its top
  table.surface ({1, 1, 0.4}, {1, 0, 0}, {0, 0, 0.3});                // an apron
  const PlaneEdges found = edgesOf (table.build());
  ASSERT_EQ (found.edges.size(), 1u)
      << "of apron and top; the apron ends 40 cm above the floor";
  expectRuns (edgeBetween (found, 1, 2), {1, 1, 0.7}, {2, 1, 0.7}, 5_cm);
  EXPECT_TRUE (found.corners.empty());
}

TEST (PlaneEdges, DoNotBelieveTheHullOfAnL)
{
  // The floor is an L. The wall begins at (3, 2), where the convex hull of the L ends
  // but no floor is.
  Scene scene;
  scene.surface ({0, 0, 0}, {4, 0, 0}, {0, 1, 0}).wall ({3, 2}, {4, 2}, 2_m);
  scene.surface ({0, 1, 0}, {1, 0, 0}, {0, 3, 0});
  EXPECT_TRUE (edgesOf (withLastSurfaceOnPlane (0, scene)).edges.empty());
}

TEST (PlaneEdges, AreTwoWhereADoorOpens)
{
  // A wall with a door from x = 1 m to 2 m; both of its parts are plane 1.
  Scene scene;
  scene.floor (4_m, 3_m).wall ({0, 1}, {1, 1}, 2.5_m).wall ({2, 1}, {4, 1}, 2.5_m);
  const LabeledScene built = withLastSurfaceOnPlane (1, scene);
  const PlaneEdges found = edgesOf (built);
  ASSERT_EQ (found.edges.size(), 2u);
  const bool is_left_first = found.edges[0].from.x() < found.edges[1].from.x();
  const PlaneEdge& left_of_door = found.edges[is_left_first ? 0 : 1];
  const PlaneEdge& right_of_door = found.edges[is_left_first ? 1 : 0];
  expectRuns (left_of_door, {0, 1, 0}, {1, 1, 0}, 10_cm);
  expectRuns (right_of_door, {2, 1, 0}, {4, 1, 0}, 10_cm);

  PlaneEdgeParameters across_door;
  across_door.max_gap = 1.2_m;
  EXPECT_EQ (edgesOf (built, across_door).edges.size(), 1u);
}

TEST (PlaneEdges, GoOnWhereAWallMeetsTheMiddleOfAnother)
{
  Scene scene;
  scene.floor (4_m, 3_m).wall ({0, 0}, {4, 0}, 2.5_m).wall ({2, 0}, {2, 3}, 2.5_m);
  const PlaneEdges found = edgesOf (scene.build());
  EXPECT_EQ (found.edges.size(), 3u);
  expectRuns (edgeBetween (found, 0, 1), {0, 0, 0}, {4, 0, 0}, 10_cm);
  expectRuns (edgeBetween (found, 1, 2), {2, 0, 0}, {2, 0, 2.5}, 10_cm);
  ASSERT_EQ (found.corners.size(), 1u);
  EXPECT_LT ((found.corners[0].position - Vector3d (2, 0, 0)).norm(), 1e-6);
}

TEST (PlaneEdges, EndAtTheNearerOfTwoCornersWithinTheGap)
{
  // The wall along x ends at a wall at x = 4 m; another one meets it at x = 2.5 m.
  Scene scene;
  scene.floor (4_m, 3_m).wall ({0, 0}, {4, 0}, 2.5_m);
  scene.wall ({4, 0}, {4, 3}, 2.5_m).wall ({2.5, 0}, {2.5, 3}, 2.5_m);
  const PlaneEdges found =
      edgesOf (scene.build(), parametersWith (&PlaneEdgeParameters::max_gap, 2_m));
  ASSERT_EQ (found.corners.size(), 2u);
  expectRuns (edgeBetween (found, 0, 1), {0, 0, 0}, {4, 0, 0}, 5_cm);
}

TEST (PlaneEdges, EndAtTheCornersAtBothOfTheirEnds)
{
  // A wall along x from a wall at x = 0 to one at x = 4 m.
  Scene scene;
  scene.floor (4_m, 3_m).wall ({0, 0}, {4, 0}, 2.5_m);
  scene.wall ({0, 0}, {0, 3}, 2.5_m).wall ({4, 0}, {4, 3}, 2.5_m);
  const PlaneEdges found = edgesOf (scene.build());
  expectRuns (edgeBetween (found, 0, 1), {0, 0, 0}, {4, 0, 0}, 1e-6);
}

TEST (PlaneEdges, EndAtACornerWithTheirNearerEndInWhateverOrderThePlanesAre)
{
  // The gap of 100 m allows both ends of an edge to move to the corner.
  const LabeledScene built = corner().build();
  std::vector<PlaneSegment> planes = planesOf (built);
  std::reverse (planes.begin(), planes.end());
  const PlaneEdges found = findPlaneEdges (
      *built.cloud, planes, parametersWith (&PlaneEdgeParameters::max_gap, 100_m));
  expectRuns (edgeBetween (found, 1, 2), {0, 0, 0}, {4, 0, 0}, 5_cm);
  expectRuns (edgeBetween (found, 0, 2), {0, 0, 0}, {0, 3, 0}, 5_cm);
  for (const PlaneEdge& edge : found.edges)
    EXPECT_LT (std::min (edge.from.norm(), edge.to.norm()), 1e-6);
}

TEST (PlaneEdges, GoOnOverGapsUpToTwiceTheReach)
{
  for (const double gap : {15_cm, 30_cm}) {
    Scene scene;
    scene.floor (4_m, 3_m).spacing (2_cm).wall ({0, 1}, {2, 1}, 1_m);
    scene.wall ({2 + gap, 1}, {4, 1}, 1_m);
    const PlaneEdges found =
        edgesOf (withLastSurfaceOnPlane (1, scene),
                 parametersWith (&PlaneEdgeParameters::reach, 10_cm));
    EXPECT_EQ (found.edges.size(), gap < 20_cm ? 1u : 2u) << gap;
  }
}

TEST (PlaneEdges, HaveNoCornerWhereOneEndsEarlier)
{
  // The second wall ends 1 m before the first one, but from 1.5 m up it reaches the
  // first one.
  Scene scene;
  scene.floor (4_m, 3_m).wall ({0, 0}, {4, 0}, 2.5_m).wall ({0, 1}, {0, 3}, 2.5_m);
  scene.surface ({0, 0, 1.5}, {0, 1, 0}, {0, 0, 1}); // this upper part
  const LabeledScene built = withLastSurfaceOnPlane (2, scene);
  std::vector<PlaneSegment> planes = planesOf (built);
  for (int order = 0; order < 3; ++order) {
    const PlaneEdges found = findPlaneEdges (*built.cloud, planes);
    EXPECT_EQ (found.edges.size(), 3u);
    EXPECT_TRUE (found.corners.empty())
        << "the edges of each two planes end at different positions";
    std::rotate (planes.begin(), planes.begin() + 1, planes.end());
  }
}

TEST (PlaneEdges, AreAsManyAsPlanesMeet)
{
  const PlaneEdgeParameters only_steep =
      parametersWith (&PlaneEdgeParameters::min_angle, 15_deg);
  const Scene parallel = Scene().wall ({0, 0}, {4, 0}, 2).wall ({0, 1}, {4, 1}, 2);
  const Scene wall_7_cm_above = floorAndWall (0.0, 0.07).spacing (1_cm);
  const struct {
    const char* planes; // of the scene
    Scene scene;
    PlaneEdgeParameters parameters;
    std::size_t edges;
  } rows[] = {
      {"parallel walls", parallel, {}, 0},
      {"a slope of 10 degrees", floorAndRamp (10_deg), only_steep, 0},
      {"a slope of 20 degrees", floorAndRamp (20_deg), only_steep, 1},
      {"a wall on the line of the floor's side, but beside the floor",
       floorAndWall (2.5, 0.0),
       {},
       0},
      {"a wall that begins 30 cm above the floor", floorAndWall (0.0, 0.3), {}, 0},
      {"the same with a reach of 40 cm",
       floorAndWall (0.0, 0.3),
       parametersWith (&PlaneEdgeParameters::reach, 0.4),
       1},
      {"a wall 7 cm above the floor", Scene (wall_7_cm_above).noise (1_mm), {}, 0},
      {"the same where noise explains the gap",
       Scene (wall_7_cm_above).noise (2_cm),
       {},
       1},
      {"a wall 10 cm above the floor, beyond three standard deviations of 1 cm each",
       floorAndWall (0.0, 0.1).spacing (1_cm).noise (1_cm),
       {},
       0},
      {"a ramp 9 cm beside a floor, where noise of 1 cm moves the line by more",
       floorAndRamp (30_deg, 9_cm).spacing (1_cm).noise (1_cm),
       {},
       1},
      {"a corner of a room, of whose edges one is too short",
       corner(),
       parametersWith (&PlaneEdgeParameters::min_length, 2.8),
       2}};
  for (const auto& row : rows) {
    const PlaneEdges found = edgesOf (Scene (row.scene).build(), row.parameters);
    EXPECT_EQ (found.edges.size(), row.edges) << row.planes;
    EXPECT_TRUE (found.corners.empty()) << row.planes << ": a corner has three edges";
  }
  const PlaneEdge below_ramp = edgesOf (floorAndRamp (20_deg).build()).edges.at (0);
  EXPECT_NEAR (below_ramp.angle, 20_deg, 1e-9);
  EXPECT_NEAR (below_ramp.length(), 2_m, 10_cm);
}

TEST (PlaneEdges, AreExactAThousandKilometersFromZero)
{
  const LabeledScene built = corner().build();
  std::vector<PlaneSegment> planes = planesOf (built);
  const Vector3d shift (4.5e5, 5.4e6, 1e3);
  for (PlaneSegment& plane : planes)
    plane.centroid += shift;
  const PlaneEdges found = findPlaneEdges (*built.cloud, planes, {}, shift);
  EXPECT_EQ (found.edges.size(), 3u);
  ASSERT_EQ (found.corners.size(), 1u);
  EXPECT_LT ((found.corners[0].position - shift).norm(), 1e-6);
}

TEST (PlaneEdges, AreTheSameInWhateverOrderThePointsAre)
{
  const LabeledScene built = corner().noise (1_cm).build();
  std::vector<PlaneSegment> planes = planesOf (built);
  const auto endsOf = [&] {
    std::vector<Vector3d> ends;
    for (const PlaneEdge& edge : findPlaneEdges (*built.cloud, planes).edges)
      ends.insert (ends.end(), {edge.from, edge.to});
    return ends;
  };
  const std::vector<Vector3d> ends = endsOf();
  ASSERT_GE (ends.size(), 6u) << "two of each edge";
  for (PlaneSegment& plane : planes)
    std::reverse (plane.inliers.begin(), plane.inliers.end());
  EXPECT_EQ (endsOf(), ends);
}

TEST (PlaneEdges, OfNothingOrOfAPlaneThatIsNotFiniteAreNone)
{
  const pcl::PointCloud<pcl::PointXYZ> empty;
  EXPECT_TRUE (findPlaneEdges (empty, {}).edges.empty());
  EXPECT_TRUE (findPlaneEdges (empty, std::vector<PlaneSegment> (3)).edges.empty());
  const LabeledScene built = corner().build();
  std::vector<PlaneSegment> planes = planesOf (built);
  planes[1].normal.setConstant (NAN);
  EXPECT_EQ (findPlaneEdges (*built.cloud, planes).edges.size(), 1u)
      << "of the other two planes";
  planes[0].centroid.setConstant (NAN);
  EXPECT_TRUE (findPlaneEdges (*built.cloud, planes).edges.empty());
}

TEST (PlaneEdges, OfWrongParametersOrAnotherCloudAreRefused)
{
  const LabeledScene built = corner().build();
  PlaneEdgeParameters wrong;
  wrong.reach = -1.0;
  EXPECT_THROW (edgesOf (built, wrong), std::invalid_argument);
  EXPECT_THROW (findPlaneEdges (pcl::PointCloud<pcl::PointXYZ>(), planesOf (built)),
                std::invalid_argument);
}
