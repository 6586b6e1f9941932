// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "continuation.h"
#include "heights.h"
#include "stories.h"
#include <pcl_ops/buildings/plane_kinds.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace pcl_ops {
namespace {

using namespace internal::buildings;
using Eigen::Vector3d;

using Viewpoint = std::optional<Vector3d>;

/** \brief How a sensor saw a plane. */
struct Sight {
  bool is_below = false;
  double solid_angle = 0.0; // [sr], of a plane that is small for its distance
};

/** \brief A plane as the rules see it, in meters. */
struct PlaneShape {
  Orientation orientation;
  Vector3d normal, center, long_axis, short_axis;
  double length, width, area;
  /** \brief Between the plane and the horizontal [rad]. */
  double slope;
  /** \brief Heights of the middle and of the lowest and highest corner. */
  double middle, low, high;
  bool faces_down;
  Sight sight;

  /** \brief Of a vertical plane: its level side. */
  double
  span () const
  {
    const double rise = high - low;
    return rise > 0.0 ? area / rise : length;
  }
};

Sight
sightOf (const PlaneSegment& plane,
         const PlaneExtent& extent,
         const Vector3d& up,
         double meter,
         const Viewpoint& sensor)
{
  constexpr double min_sine = 0.02; // of the angle at which a surface is seen
  constexpr double min_drop = 0.1;  // of what was seen at a lower one [m]
  if (!sensor)
    return {};
  const Vector3d to_sensor = (*sensor - plane.centroid) / meter;
  const double distance = to_sensor.norm();
  const double height =
      (plane.normal.dot (up) < 0.0 ? -1.0 : 1.0) * plane.normal.dot (to_sensor);
  const bool is_edge_on = std::abs (height) <= min_sine * distance;
  Sight sight{is_edge_on ? to_sensor.dot (up) > min_drop : height > 0.0};
  if (!is_edge_on)
    sight.solid_angle =
        extent.area / (meter * meter) * std::abs (height) / std::pow (distance, 3);
  return sight;
}

struct Scene {
  std::vector<PlaneShape> shapes;
  /** \brief Unit vector that their heights are along. */
  Vector3d up;
};

/** \brief Nothing where a sensor is farther away than any sees, as zero is from a map.
 */
Viewpoint
nearSensor (const Viewpoint& sensor, const std::vector<PlaneExtent>& extents)
{
  constexpr double max_distance_by_reach = 500.0; // as turnUnseenUp has it
  double reach = 0.0;
  for (const PlaneExtent& extent : extents)
    reach = std::max (reach,
                      (extent.center - extents.front().center).norm() + extent.length);
  const bool is_far =
      !sensor || extents.empty() ||
      (*sensor - extents.front().center).norm() > max_distance_by_reach * reach;
  return is_far ? std::nullopt : sensor;
}

PlaneShape
shapeOf (const PlaneSegment& plane,
         const PlaneExtent& extent,
         const Vector3d& up,
         double meter,
         const Viewpoint& sensor)
{
  PlaneShape shape{plane.orientation,
                   plane.normal,
                   extent.center / meter,
                   extent.long_axis,
                   extent.short_axis,
                   extent.length / meter,
                   extent.width / meter,
                   extent.area / (meter * meter),
                   slopeOf (plane.normal, up),
                   plane.centroid.dot (up) / meter,
                   0.0,
                   0.0,
                   plane.normal.dot (up) < 0.0,
                   sightOf (plane, extent, up, meter, sensor)};
  shape.low = shape.high = shape.middle;
  for (const Vector3d& corner : extent.hull) {
    const double height = corner.dot (up) / meter;
    shape.low = std::min (shape.low, height);
    shape.high = std::max (shape.high, height);
  }
  return shape;
}

/** \brief Heights that are no numbers have no order, and make stories without end. */
void
checkIsFinite (const PlaneShape& shape)
{
  const Vector3d all = shape.normal + shape.center + shape.long_axis + shape.short_axis;
  const double sum = shape.length + shape.width + shape.area + shape.slope +
                     shape.middle + shape.low + shape.high;
  if (!all.allFinite() || !std::isfinite (sum))
    throw std::invalid_argument ("planes and their extents must be finite in meters");
}

std::vector<PlaneShape>
shapesOf (const std::vector<PlaneSegment>& planes,
          const std::vector<PlaneExtent>& extents,
          const Vector3d& up,
          double meter,
          const Viewpoint& sensor)
{
  std::vector<PlaneShape> shapes;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    shapes.push_back (shapeOf (planes[i], extents[i], up, meter, sensor));
    checkIsFinite (shapes.back());
  }
  return shapes;
}

/** \brief The ground under a sensor that leans: what it saw most of below it, level but
 * for some degrees, where it saw hardly anything that is more level. */
const PlaneShape*
leaningGround (const std::vector<PlaneShape>& shapes)
{
  constexpr double smallest = 4.0;      // [m^2]
  constexpr double smallest_seen = 0.1; // [sr], a hundredth of what is around
  constexpr double min_lean = 3.0 * M_PI / 180.0;
  constexpr double max_lean =
      12.0 * M_PI / 180.0;               // a car on a kerb, a lidar on a stick
  constexpr double smallest_level = 0.2; // of what was seen of the ground
  const PlaneShape* ground = nullptr;
  double most_seen = smallest_seen;
  for (const PlaneShape& shape : shapes)
    if (shape.sight.is_below && shape.slope <= max_lean && shape.area >= smallest &&
        shape.sight.solid_angle > most_seen) {
      most_seen = shape.sight.solid_angle;
      ground = &shape;
    }
  if (ground == nullptr || ground->slope < min_lean)
    return nullptr;
  const auto is_level = [&] (const PlaneShape& shape) {
    return shape.slope <= 0.5 * ground->slope &&
           shape.sight.solid_angle >= smallest_level * most_seen;
  };
  return std::any_of (shapes.begin(), shapes.end(), is_level) ? nullptr : ground;
}

std::vector<Story>
storiesOf (const std::vector<PlaneShape>& shapes)
{
  constexpr double smallest = 0.3; // that says how far down the scene reaches [m^2]
  std::vector<LevelPlane> level;
  double lowest = shapes.empty() ? 0.0 : shapes.front().low;
  for (const PlaneShape& shape : shapes) {
    if (shape.orientation == Orientation::Horizontal)
      level.push_back (
          {shape.middle, shape.area, shape.faces_down, shape.sight.is_below});
    // A road falls by more than a step, and lies no deeper for it.
    const double bottom =
        shape.orientation == Orientation::Horizontal ? shape.middle : shape.low;
    if (shape.area >= smallest)
      lowest = std::min (lowest, bottom);
  }
  return internal::buildings::storiesOf (levelsOf (std::move (level)), lowest);
}

bool
isInRectangle (const PlaneShape& shape, const Vector3d& point)
{
  const Vector3d off = point - shape.center;
  return std::abs (off.dot (shape.long_axis)) <= 0.5 * shape.length &&
         std::abs (off.dot (shape.short_axis)) <= 0.5 * shape.width;
}

/** \brief Whether most of a vertical plane stands close before a larger one that faces
 * the same way, as the front of a cupboard before a wall. */
bool
standsBefore (const PlaneShape& front, const PlaneShape& wall)
{
  constexpr double min_cosine = 0.9; // some 25 degrees
  constexpr double nearest = 0.1;
  constexpr double farthest = 1.0; // relief of a wall, furniture [m]
  constexpr int steps = 4;         // of samples from the middle
  const double cosine = front.normal.dot (wall.normal);
  if (cosine < min_cosine || wall.area <= front.area || wall.high < front.high)
    return false;
  int before = 0;
  int all = 0;
  for (int i = -steps; i <= steps; ++i)
    for (int j = -steps; j <= steps; ++j) {
      const Vector3d sample = front.center +
                              0.4 * front.length * i / steps * front.long_axis +
                              0.4 * front.width * j / steps * front.short_axis;
      const double distance = wall.normal.dot (sample - wall.center);
      const bool is_before =
          distance >= nearest && distance <= farthest && isInRectangle (wall, sample);
      before += is_before ? 1 : 0;
      ++all;
    }
  return 2 * before > all;
}

bool
isWall (const PlaneShape& shape,
        const std::vector<PlaneShape>& shapes,
        const std::vector<Story>& stories)
{
  constexpr double smallest_at_ceiling = 0.5;
  constexpr double smallest = 1.0;    // [m]
  constexpr double lowest_wall = 1.3; // [m]
  const double rise = shape.high - shape.low;
  for (const Story& story : stories)
    if (story.ceiling && rise >= smallest_at_ceiling &&
        shape.high >= *story.ceiling - gap_above_wall &&
        shape.low <= *story.ceiling - smallest_at_ceiling)
      return true;
  if (rise < lowest_wall || shape.span() < smallest)
    return false;
  return std::none_of (shapes.begin(), shapes.end(), [&] (const PlaneShape& other) {
    return other.orientation == Orientation::Vertical && standsBefore (shape, other);
  });
}

/** \brief Whether a floor above others has no wall that rises from it. */
bool
isRoofAt (double height, const std::vector<PlaneShape>& shapes)
{
  return std::none_of (shapes.begin(), shapes.end(), [&] (const PlaneShape& shape) {
    return shape.orientation == Orientation::Vertical && shape.low <= height + step &&
           shape.high >= height + headroom;
  });
}

bool
isCeiling (const PlaneShape& shape, const Story& story)
{
  constexpr double smallest_part = 0.3;
  constexpr double smallest_alone = 1.0; // [m^2]
  constexpr double smallest_high = 0.1;
  constexpr double high = 2.3; // above cupboards [m^2], [m]
  const double rise = shape.middle - story.floor;
  if (rise < headroom || shape.sight.is_below)
    return false;
  if (!story.ceiling)
    return shape.faces_down &&
           shape.area >= (rise < high ? smallest_alone : smallest_high);
  const double below = *story.ceiling - shape.middle;
  return shape.area >= smallest_part &&
         below <= (shape.faces_down ? drop_of_ceiling : same_level);
}

bool
isTable (const PlaneShape& shape, double rise)
{
  constexpr double lowest = 0.3;
  constexpr double highest = 1.3; // [m]
  constexpr double smallest = 0.1;
  constexpr double largest = 6.0;   // [m^2]
  constexpr double narrowest = 0.2; // [m]
  return !shape.faces_down && rise >= lowest && rise <= highest &&
         shape.area >= smallest && shape.area <= largest && shape.width >= narrowest;
}

bool
isRamp (const PlaneShape& shape, const Story& story)
{
  constexpr double flattest = 2.5 * M_PI / 180.0;
  constexpr double steepest = 35.0 * M_PI / 180.0;
  constexpr double smallest = 0.5; // [m^2]
  constexpr double min_rise = 0.15;
  constexpr double max_below = 0.2; // [m]
  return !shape.faces_down && shape.slope >= flattest && shape.slope <= steepest &&
         shape.area >= smallest && shape.high - shape.low >= min_rise &&
         std::abs (shape.low - story.floor) <= max_below;
}

bool
isSlopingRoof (const PlaneShape& shape, const Story& story)
{
  constexpr double smallest = 2.0; // [m^2]
  return shape.area >= smallest && shape.middle - story.floor >= headroom &&
         (!story.ceiling || shape.high >= *story.ceiling - gap_above_wall);
}

PlaneKind
levelKind (const PlaneShape& shape,
           const std::vector<PlaneShape>& shapes,
           const std::vector<Story>& stories)
{
  constexpr double smallest_step = 1.0;
  constexpr double smallest_slab = 2.0; // [m^2]
  constexpr double same_floor = 0.1;    // [m]
  const Story& story = storyAt (stories, shape.middle);
  const double rise = shape.middle - story.floor;
  if (rise < same_floor || (rise < step && shape.area >= smallest_step)) {
    const bool is_upper = &story != &stories.front();
    return is_upper && isRoofAt (story.floor, shapes) ? PlaneKind::Roof
                                                      : PlaneKind::Floor;
  }
  if (isCeiling (shape, story))
    return PlaneKind::Ceiling;
  if (isRamp (shape, story))
    return PlaneKind::Ramp;
  if (isTable (shape, rise))
    return PlaneKind::Table;
  if (rise < step || shape.area < smallest_slab)
    return PlaneKind::Other;
  if (shape.sight.is_below && shape.area >= smallest_ground && rise < headroom)
    return PlaneKind::Floor; // the ground beyond a kerb or a slope
  const bool is_outdoors = rise >= headroom && !story.ceiling && !shape.faces_down;
  return is_outdoors ? PlaneKind::Roof : PlaneKind::Slab;
}

PlaneKind
kindOf (const PlaneShape& shape,
        const std::vector<PlaneShape>& shapes,
        const std::vector<Story>& stories)
{
  if (shape.orientation == Orientation::Horizontal)
    return levelKind (shape, shapes, stories);
  if (shape.orientation == Orientation::Vertical)
    return isWall (shape, shapes, stories) ? PlaneKind::Wall : PlaneKind::Other;
  const Story& story = storyAt (stories, shape.low);
  if (isRamp (shape, story))
    return PlaneKind::Ramp;
  return isSlopingRoof (shape, story) ? PlaneKind::Roof : PlaneKind::Other;
}

/** \brief Whether a plane has a relief of its own, as a hillside has: it is no part of
 * a building. */
bool
hasRelief (const PlaneSegment& plane, double meter)
{
  constexpr double max_noises = 3.0;
  constexpr double max_rms = 0.35; // of a roof with its chimneys [m]
  const double rms = plane.rms();
  return rms > max_rms * meter || (plane.noise && rms > max_noises * *plane.noise);
}

/** \brief One for each plane, in a frame whose z is up; walls without an outline. */
std::vector<PlaneFromAbove>
planesFromAbove (const Scene& scene,
                 const std::vector<PlaneExtent>& extents,
                 double meter)
{
  constexpr double min_cosine = 0.5; // 60 degrees
  const auto turn = Eigen::Quaterniond::FromTwoVectors (scene.up, Vector3d::UnitZ());
  std::vector<PlaneFromAbove> planes;
  for (std::size_t i = 0; i < extents.size(); ++i) {
    const PlaneShape& shape = scene.shapes[i];
    const Vector3d normal = turn * shape.normal;
    PlaneFromAbove& plane = planes.emplace_back();
    plane.normal = normal.z() < 0.0 ? -normal : normal;
    plane.center = turn * shape.center;
    plane.area = shape.area;
    if (plane.normal.z() >= min_cosine)
      for (const Vector3d& corner : extents[i].hull)
        plane.hull.push_back (turn * corner / meter);
  }
  return planes;
}

/** \brief Has hillsides be no roofs. Walls keep their names: in depth images they bend
 * by as much; of 20 rooms .17 of the walls were left. */
void
denyHills (const std::vector<PlaneSegment>& planes,
           const std::vector<PlaneFromAbove>& from_above,
           double meter,
           std::vector<PlaneKind>& kinds)
{
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (kinds[i] == PlaneKind::Roof &&
        (hasRelief (planes[i], meter) || isContinued (from_above[i], from_above)))
      kinds[i] = PlaneKind::Other;
}

/** \brief Whether a vertical plane is a part of another one, in its plane. */
bool
continues (const PlaneShape& part, const PlaneShape& wall)
{
  constexpr double min_cosine = 0.985; // 10 degrees
  constexpr double farthest = 0.1;     // from the plane of the wall [m]
  return part.normal.dot (wall.normal) >= min_cosine &&
         std::abs (wall.normal.dot (part.center - wall.center)) <= farthest;
}

/** \brief Parts of walls that are too small to be told by themselves. */
void
nameParts (const std::vector<PlaneShape>& shapes, std::vector<PlaneKind>& kinds)
{
  const std::vector<PlaneKind> before = kinds;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (std::size_t j = 0; j < shapes.size(); ++j)
      if (shapes[i].orientation == Orientation::Vertical &&
          before[j] == PlaneKind::Wall && continues (shapes[i], shapes[j]))
        kinds[i] = PlaneKind::Wall;
}

void
checkArguments (const std::vector<PlaneSegment>& planes,
                const std::vector<PlaneExtent>& extents,
                const Vector3d& up,
                double meter,
                const Viewpoint& viewpoint)
{
  if (planes.size() != extents.size())
    throw std::invalid_argument ("each plane has to have its extent");
  if (!up.allFinite() || up.isZero (0.0))
    throw std::invalid_argument ("the up axis must be a direction");
  if (!(meter > 0.0 && std::isfinite (meter)))
    throw std::invalid_argument ("a meter must be a length above 0");
  if (viewpoint && !viewpoint->allFinite())
    throw std::invalid_argument ("the viewpoint must be finite");
}

/** \brief Over the ground where a sensor leans. \param[in] up unit vector */
Scene
uprightScene (const std::vector<PlaneSegment>& planes,
              const std::vector<PlaneExtent>& extents,
              const Vector3d& up,
              double meter,
              const Viewpoint& sensor)
{
  Scene scene{shapesOf (planes, extents, up, meter, sensor), up};
  const PlaneShape* const ground = leaningGround (scene.shapes);
  if (ground == nullptr)
    return scene;
  const Vector3d upright =
      ground->normal.dot (up) < 0.0 ? -ground->normal : ground->normal;
  scene = {shapesOf (planes, extents, upright, meter, sensor), upright};
  for (PlaneShape& shape : scene.shapes)
    shape.orientation = orientationOf (shape.normal, upright, paper_angle_tolerance);
  return scene;
}

} // namespace

const char*
toString (PlaneKind kind)
{
  switch (kind) {
  case PlaneKind::Floor:
    return "floor";
  case PlaneKind::Ceiling:
    return "ceiling";
  case PlaneKind::Wall:
    return "wall";
  case PlaneKind::Slab:
    return "slab";
  case PlaneKind::Roof:
    return "roof";
  case PlaneKind::Ramp:
    return "ramp";
  case PlaneKind::Table:
    return "table";
  case PlaneKind::Other:
    break;
  }
  return "other";
}

std::vector<PlaneKind>
planeKinds (const std::vector<PlaneSegment>& planes,
            const std::vector<PlaneExtent>& extents,
            const Eigen::Vector3d& up,
            double meter,
            const std::optional<Eigen::Vector3d>& viewpoint)
{
  checkArguments (planes, extents, up, meter, viewpoint);
  const Scene scene = uprightScene (
      planes, extents, up.stableNormalized(), meter, nearSensor (viewpoint, extents));
  const std::vector<PlaneShape>& shapes = scene.shapes;
  const std::vector<Story> stories = storiesOf (shapes);
  std::vector<PlaneKind> kinds;
  for (const PlaneShape& shape : shapes)
    kinds.push_back (kindOf (shape, shapes, stories));
  nameParts (shapes, kinds);
  denyHills (planes, planesFromAbove (scene, extents, meter), meter, kinds);
  return kinds;
}

} // namespace pcl_ops
