// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// How often kinds of planes are right, and how exact floor plans are, in simulated
// rooms and surveys of houses. To see the figures that the tests print:
// ctest --test-dir build -R lab_buildings_test -V
#include <gtest/gtest.h>

#include <pcl_ops/buildings/floor_plan.h>
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/detect_planes.h>
#include <simulation/scenes.h>

#include <array>
#include <cstdio>
#include <iostream>
#include <map>
#include <string>
#include <tuple>

using namespace pcl_ops;
using namespace pcl_ops::simulation;

namespace {

/** \brief Seed of the first room, as in scripts/compare. */
constexpr Seed first_seed = 401;

/** \brief A simulated cloud with the planes, extents and kinds found in it. */
struct Found {
  explicit Found (const Simulation& simulation) : Found (simulate (simulation)) {}

  explicit Found (SimulatedCloud of_scene)
  : simulated (std::move (of_scene)), cloud (simulated.cloud)
  {
    const Vector3d viewpoint = simulated.cloud.sensor_origin_.head<3>().cast<double>();
    planes = detectPlanes (cloud, OrientedPointSamplingParameters(), viewpoint);
    for (const PlaneSegment& plane : planes)
      extents.push_back (planeExtent (cloud, plane));
    kinds = planeKinds (planes, extents, Vector3d::UnitZ());
  }

  /** \brief Returns the true label that most inliers of a found plane have; 0: no
   * plane. */
  std::uint32_t
  truthOf (const PlaneSegment& plane) const
  {
    std::map<std::uint32_t, std::size_t> points;
    for (const pcl::index_t i : plane.inliers)
      ++points[simulated.cloud[static_cast<std::size_t> (i)].label];
    const auto most =
        std::max_element (points.begin(), points.end(), [] (auto& a, auto& b) {
          return a.second < b.second;
        });
    return most == points.end() ? 0 : most->first;
  }

  SimulatedCloud simulated;
  CloudView cloud;
  std::vector<PlaneSegment> planes;
  std::vector<PlaneExtent> extents;
  std::vector<PlaneKind> kinds;
};

/** \brief Areas of found planes that truly are of a kind, that are called so, and that
 * are both [m^2]. */
struct Areas {
  double truly = 0.0, called = 0.0, both = 0.0;

  void
  add (bool is_truly, bool is_called, double area)
  {
    truly += is_truly ? area : 0.0;
    called += is_called ? area : 0.0;
    both += is_truly && is_called ? area : 0.0;
  }
};

using TrueKind = std::function<PlaneKind (const Plane&)>;

/** \brief Adds up the areas of each kind (floors, ceilings, ...) and of all together.
 */
class AreasOfKinds {
public:
  explicit AreasOfKinds (std::vector<PlaneKind> kinds)
  : kinds_ (std::move (kinds)), areas_ (kinds_.size() + 1)
  {}

  void
  add (const Found& found, const TrueKind& true_kind)
  {
    for (std::size_t i = 0; i < found.planes.size(); ++i) {
      const std::uint32_t truth = found.truthOf (found.planes[i]);
      const PlaneKind truly =
          truth == 0 ? PlaneKind::Other : true_kind (found.simulated.planes[truth - 1]);
      const double area = found.extents[i].area;
      for (std::size_t k = 0; k < kinds_.size(); ++k)
        for (Areas* areas : {&areas_[k], &areas_.back()})
          areas->add (truly == kinds_[k], found.kinds[i] == kinds_[k], area);
    }
  }

  /** \brief Share of the area truly of a kind that is called so. */
  double
  recall () const
  {
    return areas_.back().both / areas_.back().truly;
  }

  /** \brief Share of the area called so that truly is of the kind. */
  double
  precision () const
  {
    return areas_.back().both / areas_.back().called;
  }

  void
  print (const std::string& title) const
  {
    std::printf ("%s:", title.c_str());
    for (std::size_t k = 0; k < kinds_.size(); ++k)
      std::printf (" %s %.1f %%,",
                   toString (kinds_[k]),
                   100.0 * areas_[k].both / areas_[k].truly);
    std::printf (" together %.1f %%, so named and right %.1f %%\n",
                 100.0 * recall(),
                 100.0 * precision());
  }

private:
  std::vector<PlaneKind> kinds_;
  std::vector<Areas> areas_; // of each kind, then of all
};

/** \brief Returns a function that tells the kind of a true plane by the box of the
 * room.
 */
TrueKind
trueKindsIn (const Site& room)
{
  return [&room] (const Plane& plane) {
    constexpr double same_offset = 0.01;    // largest difference [m]
    constexpr double level_cosine = 0.99;   // between the normal of a level and z
    constexpr double along_cosine = 0.9999; // between the normal of a wall and x or y
    const Vector3d normal = turnZ (-room.yaw) * plane.normal;
    if (std::abs (normal.z()) > level_cosine) {
      const double height = -plane.offset / normal.z();
      return std::abs (height) < same_offset                   ? PlaneKind::Floor
             : std::abs (height - room.size.z()) < same_offset ? PlaneKind::Ceiling
                                                               : PlaneKind::Other;
    }
    for (const int axis : {0, 1})
      if (std::abs (normal[axis]) > along_cosine &&
          std::abs (std::abs (plane.offset) - 0.5 * room.size[axis]) < same_offset)
        return PlaneKind::Wall;
    return PlaneKind::Other;
  };
}

/** \brief Adds up areas in simulated rooms, and prints the shares.
 * \param[in] rooms number of rooms, with the seeds from first_seed on
 * \param[in] points of a scan from everywhere; nullopt: one depth image */
AreasOfKinds
areasInRooms (Seed rooms, std::optional<double> points)
{
  AreasOfKinds areas ({PlaneKind::Floor, PlaneKind::Ceiling, PlaneKind::Wall});
  for (Seed seed = first_seed; seed < first_seed + rooms; ++seed) {
    Simulation simulation;
    simulation.seed = seed;
    simulation.points = points;
    const Site room = makeRoom (seed);
    areas.add (Found (simulation), trueKindsIn (room));
  }
  areas.print (std::to_string (rooms) + " rooms");
  return areas;
}

struct Interval {
  double from, to; // [m]
};

/** \brief Returns the ranges along an axis in which a wall has a surface at a height,
 * in ascending order.
 * \param[in] wall coordinate of the wall on the other horizontal axis [m] */
std::vector<Interval>
solidParts (const Site& room, int axis, double wall, double height)
{
  constexpr double same = 1e-6;
  const Isometry3d to_room = turnZ (-room.yaw);
  std::vector<Interval> parts;
  // The first body is the shell of the room: floor, ceiling and walls.
  for (const Shape& shape : room.scene.bodies.front().shapes) {
    const Vector3d center = to_room * shape.center;
    const Vector3d half = (shape.half_u * (to_room.linear() * shape.u)).cwiseAbs() +
                          (shape.half_v * (to_room.linear() * shape.v)).cwiseAbs();
    if (half[1 - axis] < same && std::abs (center[1 - axis] - wall) < same &&
        std::abs (center.z() - height) <= half.z())
      parts.push_back ({center[axis] - half[axis], center[axis] + half[axis]});
  }
  std::sort (parts.begin(), parts.end(), [] (const Interval& a, const Interval& b) {
    return std::tie (a.from, a.to) < std::tie (b.from, b.to);
  });
  return parts;
}

/** \brief Widths of the doors and windows of a room at some height, ascending. */
std::vector<double>
trueOpenings (const Site& room, double height)
{
  constexpr double narrowest = 1e-3; // [m]
  std::vector<double> widths;
  for (const int axis : {0, 1})
    for (const double side : {-0.5, 0.5}) {
      double solid_to = -0.5 * room.size[axis];
      for (const auto& [from, to] :
           solidParts (room, axis, side * room.size[1 - axis], height)) {
        if (from > solid_to + narrowest)
          widths.push_back (from - solid_to);
        solid_to = std::max (solid_to, to);
      }
    }
  std::sort (widths.begin(), widths.end());
  return widths;
}

std::string
textOf (const std::vector<double>& lengths)
{
  std::string text;
  for (const double length : lengths) {
    std::array<char, 16> digits{};
    std::snprintf (digits.data(), digits.size(), "%.2f", length);
    text += (text.empty() ? "" : ", ") + std::string (digits.data());
  }
  return text.empty() ? "none" : text;
}

/** \brief Widths of the doors and windows of a plan, ascending. */
std::vector<double>
foundOpenings (const FloorPlan& plan)
{
  std::vector<double> widths;
  for (const PlanWall& wall : plan.walls)
    for (const PlanOpening& opening : wall.openings)
      widths.push_back (opening.width());
  std::sort (widths.begin(), widths.end());
  return widths;
}

/** \brief Whether there are equally many widths, which differ by less than 5 cm. */
bool
areAlike (const std::vector<double>& widths, const std::vector<double>& others)
{
  constexpr double same = 0.05; // [m]
  return std::equal (
      widths.begin(),
      widths.end(),
      others.begin(),
      others.end(),
      [] (double one, double other) { return std::abs (one - other) < same; });
}

/** \brief Returns PlanErrors::length. */
double
lengthErrorOf (const FloorPlan& plan, const Site& room)
{
  std::vector<double> lengths;
  for (const PlanWall& wall : plan.walls)
    lengths.push_back (wall.length());
  std::sort (lengths.rbegin(), lengths.rend());
  lengths.resize (4, 0.0); // the four longest: walls, not furniture
  std::vector<double> sides = {
      room.size.x(), room.size.x(), room.size.y(), room.size.y()};
  std::sort (sides.rbegin(), sides.rend());
  double error = 0.0;
  for (std::size_t i = 0; i < sides.size(); ++i)
    error = std::max (error, std::abs (lengths[i] / sides[i] - 1.0));
  return error;
}

/** \brief Errors of a floor plan. */
struct PlanErrors {
  double length = 0.0; // largest of the four longest walls, as a share of its length
  double area = 0.0;   // as a share of the area
  bool has_all_openings = false;
};

/** \brief Compares the floor plan of a simulated room with the room, and prints it. */
PlanErrors
planErrorsOf (Seed seed)
{
  Simulation simulation;
  simulation.seed = seed;
  simulation.points = 1e6;
  const Found found (simulation);
  const FloorPlan plan =
      findFloorPlan (found.cloud, found.planes, found.kinds, Vector3d::UnitZ());
  const Site room = makeRoom (seed);
  const std::vector<double> openings = foundOpenings (plan);
  const std::vector<double> true_openings = trueOpenings (room, plan.height);
  PlanErrors errors;
  errors.length = lengthErrorOf (plan, room);
  errors.has_all_openings = areAlike (openings, true_openings);
  const double true_area = room.size.x() * room.size.y();
  const double area = plan.rooms.empty() ? 0.0 : plan.rooms.front().area;
  errors.area = std::abs (area / true_area - 1.0);
  std::printf ("| %u | %.2f %% | %.2f m^2 | %.2f m^2 | %s | %s |\n",
               seed,
               100.0 * errors.length,
               area,
               true_area,
               textOf (openings).c_str(),
               textOf (true_openings).c_str());
  return errors;
}

struct Hardship {
  double hidden = 0.4;  // share of each wall that furniture hides up to 2 m height
  double missing = 0.1; // share of each wall without points
  double noise = 0.02;  // standard deviation of each coordinate [m]
};

/** \brief Returns the points of a simulated room as in a worse scan. The furniture that
 * hides walls has no points itself, like glass and black surfaces. */
SimulatedCloud
scannedWorse (SimulatedCloud simulated, const Site& room, const Hardship& hardship)
{
  // Largest distance of points from the plane of their wall, and a height [m].
  constexpr double same = 0.05, height_of_furniture = 2.0;
  Random random (7);
  struct Begins { // of the hidden and the missing part, as shares of the wall
    double hidden, missing;
  };
  std::array<Begins, 4> begins{}; // of each wall
  for (auto& [hidden, missing] : begins) {
    hidden = random.between (0.0, 1.0 - hardship.hidden);
    missing = random.between (0.0, 1.0 - hardship.missing);
  }
  const Isometry3d to_room = turnZ (-room.yaw);
  LabeledCloud kept;
  for (pcl::PointXYZL point : simulated.cloud) {
    const Vector3d position = to_room * point.getVector3fMap().cast<double>();
    bool is_seen = true;
    for (const int axis : {0, 1})
      for (const int side : {0, 1}) {
        if (std::abs (position[1 - axis] - (side - 0.5) * room.size[1 - axis]) > same)
          continue;
        const auto [hidden, missing] = begins[2 * axis + side];
        const double share = position[axis] / room.size[axis] + 0.5;
        const bool is_hidden = share > hidden && share < hidden + hardship.hidden &&
                               position.z() < height_of_furniture;
        is_seen = is_seen && !is_hidden &&
                  !(share > missing && share < missing + hardship.missing);
      }
    for (float* const coordinate : {&point.x, &point.y, &point.z})
      *coordinate += static_cast<float> (hardship.noise * random.gaussian());
    if (is_seen)
      kept.push_back (point);
  }
  kept.sensor_origin_ = simulated.cloud.sensor_origin_;
  simulated.cloud = kept;
  return simulated;
}

} // namespace

TEST (Kinds, AreMostlyRightInRoomsScannedFromEverywhere)
{
  const AreasOfKinds areas = areasInRooms (8, 300'000.0);
  EXPECT_GT (areas.recall(), 0.98);
  EXPECT_GT (areas.precision(), 0.95);
}

TEST (Kinds, AreMostlyRightInRoomsInOneDepthImage)
{
  const AreasOfKinds areas = areasInRooms (20, std::nullopt);
  EXPECT_GT (areas.recall(), 0.95);
  EXPECT_GT (areas.precision(), 0.93);
}

TEST (Kinds, AreMostlyRightOfHousesInASurvey)
{
  constexpr Seed surveys = 3;
  AreasOfKinds areas ({PlaneKind::Floor, PlaneKind::Wall, PlaneKind::Roof});
  for (Seed seed = 1; seed <= surveys; ++seed) {
    Simulation simulation;
    simulation.scene = "survey";
    simulation.seed = seed;
    areas.add (Found (simulation), [] (const Plane& plane) {
      // Cosines of the angle from the normal to the up axis.
      constexpr double of_level_planes = 0.99;
      constexpr double of_upright_planes = 1.0 - of_level_planes;
      const double cosine = std::abs (plane.normal.z());
      return cosine > of_level_planes     ? PlaneKind::Floor
             : cosine < of_upright_planes ? PlaneKind::Wall
                                          : PlaneKind::Roof;
    });
  }
  areas.print ("3 surveys of 36 houses");
  EXPECT_GT (areas.recall(), 0.98);
  EXPECT_GT (areas.precision(), 0.98);
}

TEST (Plans, OfRoomsHaveLengthsWithin1PercentAreasWithin2AndMostlyAllOpenings)
{
  constexpr Seed rooms = 6;
  constexpr Seed rooms_with_all_openings = 4;
  Seed with_all_openings = 0;
  for (Seed seed = first_seed; seed < first_seed + rooms; ++seed) {
    const PlanErrors errors = planErrorsOf (seed);
    EXPECT_LT (errors.length, 0.01) << seed;
    EXPECT_LT (errors.area, 0.02) << seed;
    with_all_openings += errors.has_all_openings ? 1 : 0;
  }
  EXPECT_GE (with_all_openings, rooms_with_all_openings);
}

TEST (Plans, OfRoomsScannedWorseHaveTheRoomWithin3PercentAndNoOther)
{
  constexpr Seed rooms = 6;
  Seed within_3_percent = 0;
  for (Seed seed = first_seed; seed < first_seed + rooms; ++seed) {
    Simulation simulation;
    simulation.seed = seed;
    simulation.points = 1e6;
    const Site room = makeRoom (seed);
    const Found found (scannedWorse (simulate (simulation), room, {}));
    const FloorPlan plan =
        findFloorPlan (found.cloud, found.planes, found.kinds, Vector3d::UnitZ());
    const double true_area = room.size.x() * room.size.y();
    const double area = plan.rooms.empty() ? 0.0 : plan.rooms.front().area;
    std::printf ("| %u | %.2f m^2 | %.2f m^2 | %zu |\n",
                 seed,
                 area,
                 true_area,
                 plan.rooms.size());
    EXPECT_EQ (plan.rooms.size(), 1u) << seed;
    within_3_percent += std::abs (area / true_area - 1.0) < 0.03 ? 1 : 0;
  }
  EXPECT_EQ (within_3_percent, rooms);
}
