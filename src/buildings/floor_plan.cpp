// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "arguments.h"
#include "constants.h"
#include "grid_square.h"
#include "plan_rooms.h"
#include "plan_walls.h"
#include "room_graph.h"
#include "upright.h"
#include "wall_faces.h"
#include "wall_fronts.h"
#include <pcl_ops/buildings/floor_plan.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

namespace pcl_ops {
namespace {

using namespace internal::buildings;
using Eigen::Vector3d;

/** \brief The finite points of a cloud in the frame of the plan [m], but without the
 * shift of findFloorPlan, which \ref moveBy adds to the finished plan. */
class PlanCloud {
public:
  /** \param[in] to_plan rotates and scales from the unit of the cloud to meters */
  PlanCloud (const CloudView& cloud, const Eigen::Matrix3d& to_plan)
  : cloud_ (cloud), to_plan_ (to_plan)
  {}

  /** \brief Returns the finite inliers of a plane. */
  PlanPoints
  pointsOf (const PlaneSegment& plane) const
  {
    PlanPoints points;
    points.reserve (plane.inliers.size());
    for (const pcl::index_t i : plane.inliers)
      if (const auto point = finitePoint (static_cast<std::size_t> (i)))
        points.push_back (*point);
    return points;
  }

  /** \brief Returns the points within half_band_of_cloud of a height [m]. */
  PlanPoints
  pointsAt (double height) const
  {
    PlanPoints points;
    for (std::size_t i = 0; i < cloud_.size; ++i)
      if (const auto point = finitePoint (i);
          point && std::abs (point->z() - height) <= constants.half_band_of_cloud)
        points.push_back (*point);
    return points;
  }

private:
  /** \brief Returns a point of the cloud; nothing if it is not finite. */
  std::optional<Vector3d>
  finitePoint (std::size_t i) const
  {
    const float* const point = cloud_[i];
    const Vector3d in_cloud (point[0], point[1], point[2]);
    if (!in_cloud.allFinite())
      return {};
    return to_plan_ * in_cloud;
  }

  const CloudView& cloud_;
  Eigen::Matrix3d to_plan_;
};

/** \brief A plane with its kind, in the frame of the plan. */
struct PlanPlane {
  PlaneKind kind;
  Vector3d normal;
  PlanPoints points; // finite inliers
  double height;     // mean height of these points [m]; 0 without points
};

/** \brief Returns the planes in the frame of the plan.
 * \param[in] rotation from the frame of the planes to that of the plan */
std::vector<PlanPlane>
planesInPlan (const PlanCloud& cloud,
              const std::vector<PlaneSegment>& planes,
              const std::vector<PlaneKind>& kinds,
              const Eigen::Matrix3d& rotation)
{
  std::vector<PlanPlane> all;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    PlanPlane plane{
        kinds[i], rotation * planes[i].normal, cloud.pointsOf (planes[i]), 0.0};
    for (const Vector3d& point : plane.points)
      plane.height += point.z() / static_cast<double> (plane.points.size());
    all.push_back (std::move (plane));
  }
  return all;
}

/** \brief Returns the height of the lowest point of all walls [m]; 0 without walls. */
double
lowestWallPoint (const std::vector<PlanPlane>& planes)
{
  std::optional<double> lowest;
  for (const PlanPlane& plane : planes)
    if (plane.kind == PlaneKind::Wall)
      for (const Vector3d& point : plane.points)
        lowest = std::min (lowest.value_or (point.z()), point.z());
  return lowest.value_or (0.0);
}

/** \brief Returns the number of points of the smallest floors that count: the share
 * min_share_of_largest_floor of the points of the largest floor, at least one. */
double
minPointsOfFloor (const std::vector<PlanPlane>& planes)
{
  std::size_t points_of_largest = 0;
  for (const PlanPlane& plane : planes)
    if (plane.kind == PlaneKind::Floor)
      points_of_largest = std::max (points_of_largest, plane.points.size());
  return std::max (1.0,
                   constants.min_share_of_largest_floor *
                       static_cast<double> (points_of_largest));
}

/** \brief Returns the height [m] of the lowest floor with \ref minPointsOfFloor.
 * Without a floor that has points it is the height of the lowest point of a wall, or 0
 * without walls. */
double
lowestFloor (const std::vector<PlanPlane>& planes)
{
  const double min_points = minPointsOfFloor (planes);
  std::optional<double> lowest;
  for (const PlanPlane& plane : planes)
    if (plane.kind == PlaneKind::Floor &&
        static_cast<double> (plane.points.size()) >= min_points)
      lowest = std::min (lowest.value_or (plane.height), plane.height);
  return lowest ? *lowest : lowestWallPoint (planes);
}

/** \brief Returns the height of the highest floor below the cut [m], with \ref
 * minPointsOfFloor; \p lowest if that floor is less than a step above it.
 * \param[in] lowest height of the \ref lowestFloor [m] */
double
floorBelow (const std::vector<PlanPlane>& planes, double height_of_cut, double lowest)
{
  const double min_points = minPointsOfFloor (planes);
  double floor = lowest;
  for (const PlanPlane& plane : planes)
    if (plane.kind == PlaneKind::Floor && plane.height < height_of_cut &&
        static_cast<double> (plane.points.size()) >= min_points)
      floor = std::max (floor, plane.height);
  // Parts of one floor differ in height by less than a step.
  return floor - lowest < constants.max_step ? lowest : floor;
}

/** \brief Returns the height of the lowest floor of the stories above [m], with \ref
 * minPointsOfFloor; infinite if there is none.
 * \param[in] floor height of the floor below the cut [m] */
double
floorAbove (const std::vector<PlanPlane>& planes, double floor)
{
  const double min_points = minPointsOfFloor (planes);
  double above = std::numeric_limits<double>::infinity();
  for (const PlanPlane& plane : planes)
    if (plane.kind == PlaneKind::Floor && plane.height >= floor + constants.headroom &&
        static_cast<double> (plane.points.size()) >= min_points)
      above = std::min (above, plane.height);
  return above;
}

void
append (PlanPoints& points, const PlanPoints& others)
{
  points.insert (points.end(), others.begin(), others.end());
}

/** \brief Returns whether planes of a kind, other than floors, are inside of rooms and
 * cover their floors: tables, slabs and ramps. */
bool
coversFloor (PlaneKind kind)
{
  return kind == PlaneKind::Table || kind == PlaneKind::Slab || kind == PlaneKind::Ramp;
}

/** \brief Returns the points of all planes for which \p predicate is true. */
template <typename Predicate>
PlanPoints
pointsOf (const std::vector<PlanPlane>& planes, const Predicate& predicate)
{
  PlanPoints points;
  for (const PlanPlane& plane : planes)
    if (predicate (plane))
      append (points, plane.points);
  return points;
}

/** \brief Squares of a grid with edges of length max_eaves. */
using EavesSquares = std::set<GridSquare>;

GridSquare
eavesSquareAt (const Vector3d& point)
{
  return squareAt (point.head<2>(), constants.max_eaves);
}

/** \brief Returns the squares with points of roofs, and the squares next to them, which
 * may be under eaves. */
EavesSquares
squaresUnder (const PlanPoints& roofs)
{
  EavesSquares with_points;
  for (const Vector3d& point : roofs)
    with_points.insert (eavesSquareAt (point));
  EavesSquares under;
  for (const auto& [x, y] : with_points)
    for (const long dx : {-1, 0, 1})
      for (const long dy : {-1, 0, 1})
        under.emplace (x + dx, y + dy);
  return under;
}

/** \brief Returns whether a building stands under roofs: most wall points are in
 * squares under the roofs or their eaves. A sloping part of a room's ceiling, which is
 * a roof by its kind, covers few wall points. */
bool
roofsCoverWalls (const PlanPoints& roofs, const std::vector<PlanPlane>& planes)
{
  const EavesSquares under_roofs = squaresUnder (roofs);
  double wall_points = 0.0;
  double covered_points = 0.0;
  for (const PlanPlane& plane : planes)
    if (plane.kind == PlaneKind::Wall)
      for (const Vector3d& point : plane.points) {
        wall_points += 1.0;
        covered_points +=
            static_cast<double> (under_roofs.count (eavesSquareAt (point)));
      }
  return covered_points > constants.min_walls_under_roofs * wall_points;
}

/** \brief Heights [m] at squares of a grid with edges of edge_of_height_square. */
using Heights = std::map<GridSquare, double>;

GridSquare
heightSquareAt (const Vector3d& point)
{
  return squareAt (point.head<2>(), constants.edge_of_height_square);
}

/** \brief Makes the height at a square at most this one. */
void
lower (Heights& heights, const GridSquare& square, double height)
{
  double& lowest = heights.emplace (square, height).first->second;
  lowest = std::min (lowest, height);
}

/** \brief The floors of the stories above a cut. A story may cover only a part of the
 * plan, beside a hall or a stairwell, so it is decided at each place apart what belongs
 * to a story above. */
class FloorsAbove {
public:
  /** \param[in] floor_above height of the \ref floorAbove [m] */
  FloorsAbove (const std::vector<PlanPlane>& planes, double floor_above)
  {
    Heights heights;
    for (const PlanPlane& plane : planes)
      if (plane.kind == PlaneKind::Floor && plane.height >= floor_above)
        for (const Vector3d& point : plane.points)
          lower (heights, heightSquareAt (point), plane.height);
    for (const auto& [square, height] : heights)
      for (const long dx : {-1, 0, 1})
        for (const long dy : {-1, 0, 1})
          lower (lowest_, {square.first + dx, square.second + dy}, height);
  }

  /** \brief Returns whether one of these floors is below a point: in its square or a
   * neighboring one, as floors end before their walls and under furniture.
   * \param[in] tolerance how far the point may be below that floor [m] */
  bool
  areBelow (const Vector3d& point, double tolerance) const
  {
    const auto lowest = lowest_.find (heightSquareAt (point));
    return lowest != lowest_.end() && point.z() >= lowest->second - tolerance;
  }

private:
  Heights lowest_; // of these floors in each square and in those next to it
};

/** \brief Leaves out the points that are above a floor of a story above.
 * \param[in] tolerance how far they may be below that floor [m] */
void
leaveOutAbove (const FloorsAbove& floors_above, double tolerance, PlanPoints& points)
{
  points.erase (std::remove_if (points.begin(),
                                points.end(),
                                [&] (const Vector3d& point) {
                                  return floors_above.areBelow (point, tolerance);
                                }),
                points.end());
}

/** \brief Leaves out ceilings that are over lower ones by headroom: they are of a story
 * above, also where its floor is hidden, as under a bed. */
void
leaveOutHigherCeilings (PlanPoints& ceilings)
{
  Heights lowest;
  for (const Vector3d& point : ceilings)
    lower (lowest, heightSquareAt (point), point.z());
  const auto is_higher = [&lowest] (const Vector3d& point) {
    return point.z() >= lowest.at (heightSquareAt (point)) + constants.headroom;
  };
  ceilings.erase (std::remove_if (ceilings.begin(), ceilings.end(), is_higher),
                  ceilings.end());
}

/** \brief Returns the points that cover the rooms at a cut. If there is no ceiling and
 * a building stands under roofs, they are those of the roofs, because floors are then
 * the ground around it; otherwise those of floors, ceilings, tables, slabs and ramps.
 * \param[in] floor height of the floor below the cut [m] */
Cover
coverAt (const std::vector<PlanPlane>& planes,
         double floor,
         double height_of_cut,
         const FloorsAbove& floors_above)
{
  const auto is_at_or_below_cut = [&] (const PlanPlane& plane) {
    return plane.height <= height_of_cut &&
           plane.height > floor - constants.max_below_floor;
  };
  Cover cover;
  cover.floor = pointsOf (planes, [&] (const PlanPlane& plane) {
    return plane.kind == PlaneKind::Floor && is_at_or_below_cut (plane);
  });
  cover.ceiling = pointsOf (planes, [&] (const PlanPlane& plane) {
    return plane.kind == PlaneKind::Ceiling && plane.height > height_of_cut &&
           plane.height < height_of_cut + constants.max_ceiling_over_cut;
  });
  PlanPoints roofs = pointsOf (planes, [&] (const PlanPlane& plane) {
    return plane.kind == PlaneKind::Roof && plane.height > height_of_cut;
  });
  if (cover.ceiling.empty() && roofsCoverWalls (roofs, planes)) {
    cover.points = std::move (roofs);
    return cover;
  }
  // One plane may be the ceiling of a hall and of the story above beside it.
  leaveOutAbove (floors_above, 0.0, cover.ceiling);
  leaveOutHigherCeilings (cover.ceiling);
  const PlanPoints above_floor = pointsOf (planes, [&] (const PlanPlane& plane) {
    return coversFloor (plane.kind) && is_at_or_below_cut (plane);
  });
  append (cover.points, cover.floor);
  append (cover.points, cover.ceiling);
  append (cover.points, above_floor);
  return cover;
}

/** \brief Changes walls over which the ceiling goes on to PlaneKind::Other: they are
 * fronts and sides of furniture, however large. */
void
excludeFurniture (const Cover& cover, std::vector<PlanPlane>& planes)
{
  const RoomSides ceilings ({&cover.ceiling});
  for (PlanPlane& plane : planes)
    if (plane.kind == PlaneKind::Wall &&
        ceilings.goOnOver (plane.normal.head<2>().normalized(), plane.points))
      plane.kind = PlaneKind::Other;
}

/** \brief Flips normals of walls so that they point to the rooms whose floors and
 * ceilings end at the walls. */
void
turnToRooms (const RoomSides& rooms, std::vector<PlanPlane>& planes)
{
  for (PlanPlane& plane : planes)
    if (plane.kind == PlaneKind::Wall &&
        rooms.areBehind (plane.normal.head<2>().normalized(), plane.points))
      plane.normal = -plane.normal;
}

/** \brief Returns whether a story lies below the floor: another floor is lower by
 * headroom, or a ceiling lower than the floor. */
bool
hasStoryBelow (const std::vector<PlanPlane>& planes, double floor)
{
  return std::any_of (planes.begin(), planes.end(), [floor] (const PlanPlane& plane) {
    if (plane.points.empty())
      return false;
    return (plane.kind == PlaneKind::Floor &&
            plane.height <= floor - constants.headroom) ||
           (plane.kind == PlaneKind::Ceiling &&
            plane.height < floor - constants.same_level);
  });
}

/** \brief Leaves out the points of walls of other stories, which may reach farther than
 * the walls at the cut. Noise puts the foot of a wall below its floor by up to
 * same_level.
 * \param[in] floor height of the floor below the cut [m] */
void
leaveOutOtherStories (double floor,
                      const FloorsAbove& floors_above,
                      std::vector<PlanPlane>& planes)
{
  // Without a story below, walls may begin below the floor, as in a pit.
  const double low = hasStoryBelow (planes, floor)
                         ? floor - constants.same_level
                         : -std::numeric_limits<double>::infinity();
  const auto is_below = [low] (const Vector3d& point) { return point.z() < low; };
  for (PlanPlane& plane : planes)
    if (plane.kind == PlaneKind::Wall) {
      PlanPoints& points = plane.points;
      points.erase (std::remove_if (points.begin(), points.end(), is_below),
                    points.end());
      leaveOutAbove (floors_above, constants.same_level, points);
    }
}

/** \brief Sets WallFace::ends_rooms: true for a wall that is seen above the furniture
 * before it and at which floors and ceilings end.
 * \param[in,out] faces not yet joined: each has one plane */
void
findFacesThatEndRooms (const RoomSides& rooms,
                       const std::vector<PlanPlane>& planes,
                       double height_of_cut,
                       std::vector<WallFace>& faces)
{
  for (WallFace& face : faces) {
    const PlanPlane& plane = planes[face.firstPlane()];
    const auto is_over_furniture = [height_of_cut] (const Vector3d& point) {
      const double over_cut = point.z() - height_of_cut;
      return over_cut > constants.half_band_of_cloud &&
             over_cut < constants.max_furniture_over_cut;
    };
    const auto points_over_furniture =
        std::count_if (plane.points.begin(), plane.points.end(), is_over_furniture);
    const bool is_seen_over_furniture =
        static_cast<double> (points_over_furniture) >
        constants.min_share_over_furniture * static_cast<double> (plane.points.size());
    face.ends_rooms = is_seen_over_furniture &&
                      rooms.endAt (plane.normal.head<2>().normalized(), plane.points);
  }
}

/** \brief Returns a face for each plane that has points and for which \p predicate is
 * true. */
template <typename Predicate>
std::vector<WallFace>
facesOf (const std::vector<PlanPlane>& planes,
         double height_of_cut,
         const Predicate& predicate)
{
  std::vector<WallFace> faces;
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (predicate (planes[i]) && !planes[i].points.empty())
      faces.push_back (faceOf (planes[i].normal, planes[i].points, i, height_of_cut));
  return faces;
}

bool
isWall (const PlanPlane& plane)
{
  return plane.kind == PlaneKind::Wall;
}

/** \brief Returns whether a plane may be a door leaf or a window pane. */
bool
mayBeLeaf (const PlanPlane& plane)
{
  return plane.kind == PlaneKind::Other &&
         std::abs (plane.normal.z()) < constants.max_sine_of_upright;
}

/** \brief Returns a test whether points hide a gap of a wall. A gap is hidden if more
 * than half of its length has points in front of it or in it, and at most half of its
 * length has points behind it, which are seen through the gap.
 * \param[in] points near the height of the cut */
IsHidden
hiddenBy (PlanPoints points)
{
  return [points = std::move (points)] (const PlanLine& line, const Interval& gap) {
    const std::size_t bins =
        static_cast<std::size_t> (gap.length() / constants.length_of_gap_bin) + 1;
    std::vector<char> is_hidden (bins, 0); // by points in front of the bin or in it
    std::vector<char> is_seen_through (bins, 0); // has points behind it
    for (const Vector3d& point : points) {
      const double distance = line.distance (point.head<2>());
      const double position = line.positionOf (point.head<2>());
      const bool is_beside_gap = std::abs (distance) <= constants.max_off_gap &&
                                 position >= gap.from && position <= gap.to;
      if (!is_beside_gap)
        continue;
      const auto bin = static_cast<std::size_t> ((position - gap.from) /
                                                 constants.length_of_gap_bin);
      const bool is_behind = distance <= -constants.max_depth_of_hiding;
      (is_behind ? is_seen_through : is_hidden)[bin] = 1;
    }
    const auto hidden = std::count (is_hidden.begin(), is_hidden.end(), 1);
    const auto seen_through =
        std::count (is_seen_through.begin(), is_seen_through.end(), 1);
    const auto half = static_cast<std::ptrdiff_t> (bins) / 2;
    return hidden > half && seen_through <= half;
  };
}

/** \brief Moves a plan by a shift in its frame [m]. */
void
moveBy (const Vector3d& shift, FloorPlan& plan)
{
  const Eigen::Vector2d horizontal = shift.head<2>();
  plan.floor += shift.z();
  plan.height += shift.z();
  for (PlanWall& wall : plan.walls) {
    wall.from += horizontal;
    wall.to += horizontal;
    for (PlanOpening& opening : wall.openings) {
      opening.from += horizontal;
      opening.to += horizontal;
    }
  }
  for (PlanRoom& room : plan.rooms) {
    room.middle += horizontal;
    for (PlanarPoints& ring : room.rings)
      for (Eigen::Vector2d& corner : ring)
        corner += horizontal;
    for (auto& [from, to] : room.unseen) {
      from += horizontal;
      to += horizontal;
    }
    for (std::optional<double>* height : {&room.floor, &room.ceiling})
      if (*height)
        **height += shift.z();
  }
}

void
checkInput (const CloudView& cloud,
            const std::vector<PlaneSegment>& planes,
            const std::vector<PlaneKind>& kinds,
            const Vector3d& up,
            const FloorPlanParameters& parameters,
            const Vector3d& shift)
{
  throwIfWrong (validate (parameters));
  if (planes.size() != kinds.size())
    throw std::invalid_argument ("each plane has to have its kind");
  if (!up.allFinite() || up.isZero (0.0))
    throw std::invalid_argument ("the up axis must be a direction");
  if (!shift.allFinite())
    throw std::invalid_argument ("the shift must be finite");
  for (const PlaneSegment& plane : planes)
    checkInliers (cloud, plane);
}

} // namespace

std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>
PlanWall::solidParts() const
{
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> parts;
  Eigen::Vector2d begin = from;
  const auto add = [&] (const Eigen::Vector2d& end) {
    constexpr double shortest = 1e-3; // [m]: shorter parts are rounding errors
    if ((end - begin).norm() > shortest)
      parts.emplace_back (begin, end);
  };
  for (const PlanOpening& opening : openings) {
    add (opening.from);
    begin = opening.to;
  }
  add (to);
  return parts;
}

std::string
validate (const FloorPlanParameters& parameters)
{
  const auto is_length = [] (double length) {
    return length > 0.0 && std::isfinite (length);
  };
  if (!std::isfinite (parameters.cut_height))
    return "the height of the cut must be a number";
  if (!is_length (parameters.min_opening) || !is_length (parameters.max_opening) ||
      parameters.min_opening > parameters.max_opening)
    return "openings must have lengths above 0, the largest not below the smallest";
  if (!is_length (parameters.max_snap))
    return "how far ends of walls are moved must be a length above 0";
  if (!is_length (parameters.min_room))
    return "the smallest room must have an area above 0";
  // Beyond these limits lengths in meters would become zero or infinite.
  constexpr double longest = 1e9;
  if (!(parameters.meter <= longest && parameters.meter >= 1.0 / longest))
    return "a meter must be a length from 1e-9 to 1e9";
  return {};
}

FloorPlan
findFloorPlan (const CloudView& cloud,
               const std::vector<PlaneSegment>& planes,
               const std::vector<PlaneKind>& kinds,
               const Eigen::Vector3d& up,
               const FloorPlanParameters& parameters,
               const Eigen::Vector3d& shift)
{
  checkInput (cloud, planes, kinds, up, parameters, shift);
  FloorPlan plan;
  const Eigen::Matrix3d rotation = turnUpright (up);
  plan.to_plan = rotation / parameters.meter;
  const PlanCloud points (cloud, plan.to_plan);
  std::vector<PlanPlane> plan_planes = planesInPlan (points, planes, kinds, rotation);
  const double lowest = lowestFloor (plan_planes);
  plan.height = lowest + parameters.cut_height;
  plan.floor = floorBelow (plan_planes, plan.height, lowest);
  const FloorsAbove floors_above (plan_planes, floorAbove (plan_planes, plan.floor));
  const Cover cover = coverAt (plan_planes, plan.floor, plan.height, floors_above);
  excludeFurniture (cover, plan_planes);
  const RoomSides rooms ({&cover.floor, &cover.ceiling});
  turnToRooms (rooms, plan_planes);
  leaveOutOtherStories (plan.floor, floors_above, plan_planes);
  std::vector<WallFace> walls = facesOf (plan_planes, plan.height, isWall);
  findFacesThatEndRooms (rooms, plan_planes, plan.height, walls);
  const std::vector<WallFace> faces =
      withoutRecesses (withoutFurniture (joinFaces (std::move (walls))),
                       facesOf (plan_planes, plan.height, mayBeLeaf));
  std::vector<WallSpan> spans = spansOf (faces, parameters);
  addOpenings (faces, parameters, hiddenBy (points.pointsAt (plan.height)), spans);
  plan.walls = toWalls (faces, spans, plan.floor, plan.height);
  plan.rooms = roomsOf (faces, spans, cover, parameters.min_room);
  findRoomsOfOpenings (plan.rooms, plan.walls);
  moveBy (plan.to_plan * shift, plan);
  return plan;
}

} // namespace pcl_ops
