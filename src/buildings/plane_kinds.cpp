// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "constants.h"
#include "continuation.h"
#include "stories.h"
#include "upright.h"
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
  /** \brief Whether the plane is below the sensor: seen from above. */
  bool is_below = false;
  /** \brief Solid angle that the plane fills [sr]: area * cosine / distance^2, which
   * holds for a plane that is small for its distance. 0 for a plane seen edge-on. */
  double solid_angle = 0.0;
};

/** \brief Measures of a plane that the rules use, in meters. */
struct PlaneShape {
  Orientation orientation = Orientation::Other;
  Vector3d normal, center, long_axis, short_axis;
  double length = 0.0, width = 0.0, area = 0.0;
  /** \brief Angle between the plane and the horizontal [rad]. */
  double slope = 0.0;
  /** \brief Heights of the centroid, and of the lowest and highest corner of the hull;
   * all three that of the centroid if there is no hull. */
  double middle = 0.0, low = 0.0, high = 0.0;
  bool faces_down = false; // by its normal
  Sight sight = {};

  /** \brief Horizontal length of a vertical plane: its mean over the height. */
  double
  span () const
  {
    const double rise = high - low;
    return rise > 0.0 ? area / rise : length;
  }
};

/** \brief Returns how a sensor saw a plane; is_below is false without a sensor.
 * \param[in] up unit vector
 * \param[in] meter length of a meter in the unit of the planes, as in all functions
 * below */
Sight
sightOf (const PlaneSegment& plane,
         const PlaneExtent& extent,
         const Vector3d& up,
         double meter,
         const Viewpoint& sensor)
{
  if (!sensor)
    return {};
  const Vector3d to_sensor = (*sensor - plane.centroid) / meter;
  const double distance = to_sensor.norm();
  // Signed distance of the sensor to the plane, positive on the upper side.
  const double above_plane =
      (plane.normal.dot (up) < 0.0 ? -1.0 : 1.0) * plane.normal.dot (to_sensor);
  const bool is_edge_on =
      std::abs (above_plane) <= constants.max_sine_of_edge_on * distance;
  Sight sight;
  if (is_edge_on) {
    sight.is_below = to_sensor.dot (up) > constants.min_drop_below_sensor;
    return sight;
  }
  sight.is_below = above_plane > 0.0;
  sight.solid_angle =
      extent.area / (meter * meter) * std::abs (above_plane) / std::pow (distance, 3);
  return sight;
}

/** \brief All planes, measured along one up axis. */
struct Scene {
  std::vector<PlaneShape> shapes;
  Vector3d up; // unit vector along which heights are measured
};

/** \brief Returns the position of the sensor; nothing if it is not given, or farther
 * away than sensors see, as the zero of map coordinates is. Distances are those from
 * the middle of the scene, which does not depend on the order of the planes. */
Viewpoint
nearSensor (const Viewpoint& sensor, const std::vector<PlaneExtent>& extents)
{
  if (!sensor || extents.empty())
    return {};
  Eigen::AlignedBox3d centers;
  for (const PlaneExtent& extent : extents)
    centers.extend (extent.center);
  const Vector3d middle = centers.center();
  double size = 0.0; // of the scene: how far its planes reach from the middle
  for (const PlaneExtent& extent : extents)
    size = std::max (size, (extent.center - middle).norm() + extent.length);
  const double distance = (*sensor - middle).norm();
  return distance > constants.max_distance_by_size * size ? std::nullopt : sensor;
}

PlaneShape
shapeOf (const PlaneSegment& plane,
         const PlaneExtent& extent,
         const Vector3d& up,
         double meter,
         const Viewpoint& sensor)
{
  PlaneShape shape;
  shape.orientation = plane.orientation;
  shape.normal = plane.normal;
  shape.center = extent.center / meter;
  shape.long_axis = extent.long_axis;
  shape.short_axis = extent.short_axis;
  shape.length = extent.length / meter;
  shape.width = extent.width / meter;
  shape.area = extent.area / (meter * meter);
  shape.slope = slopeOf (plane.normal, up);
  shape.faces_down = plane.normal.dot (up) < 0.0;
  shape.sight = sightOf (plane, extent, up, meter, sensor);
  shape.middle = plane.centroid.dot (up) / meter;
  shape.low = shape.high = shape.middle;
  for (const Vector3d& corner : extent.hull) {
    const double height = corner.dot (up) / meter;
    shape.low = std::min (shape.low, height);
    shape.high = std::max (shape.high, height);
  }
  return shape;
}

/** \brief Throws if a shape or a corner of its hull is not finite: levelsOf would loop
 * forever for NaN. */
void
checkIsFinite (const PlaneShape& shape, const PlaneExtent& extent, double meter)
{
  // A sum is not finite if one of its terms is not.
  const Vector3d sum_of_vectors =
      shape.normal + shape.center + shape.long_axis + shape.short_axis;
  const double sum = shape.length + shape.width + shape.area + shape.slope +
                     shape.middle + shape.low + shape.high;
  // std::min and std::max leave NaN out of shape.low and shape.high.
  const bool has_finite_hull = std::all_of (
      extent.hull.begin(), extent.hull.end(), [meter] (const Vector3d& corner) {
        return (corner / meter).allFinite();
      });
  if (!sum_of_vectors.allFinite() || !std::isfinite (sum) || !has_finite_hull)
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
    checkIsFinite (shapes.back(), extents[i], meter);
  }
  return shapes;
}

/** \brief Returns whether a plane fills a larger solid angle than another one. Of two
 * that fill the same, as two sides of a street beside the sensor do, their normals
 * decide, so that the order of the planes changes nothing. */
bool
fillsMore (const PlaneShape& a, const PlaneShape& b)
{
  if (a.sight.solid_angle != b.sight.solid_angle)
    return a.sight.solid_angle > b.sight.solid_angle;
  const Vector3d& of_a = a.normal;
  const Vector3d& of_b = b.normal;
  return std::lexicographical_compare (
      of_b.data(), of_b.data() + of_b.size(), of_a.data(), of_a.data() + of_a.size());
}

/** \brief Returns the ground under a sensor that leans: the plane below the sensor with
 * the largest solid angle, which slopes by min_lean to max_lean. Returns nullptr if the
 * sensor saw no such plane, or saw much of one that is more level. */
const PlaneShape*
leaningGround (const std::vector<PlaneShape>& shapes)
{
  const PlaneShape* ground = nullptr;
  for (const PlaneShape& shape : shapes) {
    const bool may_be_ground =
        shape.sight.is_below && shape.slope <= constants.max_lean &&
        shape.area >= constants.min_area_of_leaning_ground &&
        shape.sight.solid_angle > constants.min_solid_angle_of_leaning_ground;
    if (may_be_ground && (ground == nullptr || fillsMore (shape, *ground)))
      ground = &shape;
  }
  if (ground == nullptr || ground->slope < constants.min_lean)
    return nullptr;
  const auto shows_no_lean = [&] (const PlaneShape& shape) {
    return shape.slope <= constants.max_slope_share_of_level_plane * ground->slope &&
           shape.sight.solid_angle >= constants.min_solid_angle_share_of_level_plane *
                                          ground->sight.solid_angle;
  };
  return std::any_of (shapes.begin(), shapes.end(), shows_no_lean) ? nullptr : ground;
}

/** \brief Returns the height of the lowest shape with an area of
 * min_area_of_lowest_plane or more; if all shapes are smaller, of the lowest one; 0
 * without shapes [m]. */
double
lowestHeight (const std::vector<PlaneShape>& shapes)
{
  // A long road may slope by more than a step, but its lower end is no lower floor: the
  // middle of horizontal planes counts.
  const auto bottom = [] (const PlaneShape& shape) {
    return shape.orientation == Orientation::Horizontal ? shape.middle : shape.low;
  };
  const auto comes_before = [&] (const PlaneShape& a, const PlaneShape& b) {
    const bool is_small_a = a.area < constants.min_area_of_lowest_plane;
    const bool is_small_b = b.area < constants.min_area_of_lowest_plane;
    return is_small_a != is_small_b ? is_small_b : bottom (a) < bottom (b);
  };
  const auto lowest = std::min_element (shapes.begin(), shapes.end(), comes_before);
  return lowest == shapes.end() ? 0.0 : bottom (*lowest);
}

/** \brief Returns the stories of a scene, from its horizontal planes. */
std::vector<Story>
storiesIn (const std::vector<PlaneShape>& shapes)
{
  std::vector<LevelPlane> level_planes;
  for (const PlaneShape& shape : shapes)
    if (shape.orientation == Orientation::Horizontal)
      level_planes.push_back (
          {shape.middle, shape.area, shape.faces_down, shape.sight.is_below});
  return storiesOf (levelsOf (std::move (level_planes)), lowestHeight (shapes));
}

/** \brief Returns whether the projection of a point onto a plane is in the rectangle
 * around the outline of the plane. */
bool
isInRectangle (const PlaneShape& shape, const Vector3d& point)
{
  const Vector3d off = point - shape.center;
  return std::abs (off.dot (shape.long_axis)) <= 0.5 * shape.length &&
         std::abs (off.dot (shape.short_axis)) <= 0.5 * shape.width;
}

/** \brief Returns whether most of a vertical plane stands close before a larger one
 * that reaches at least as high and faces the same way, as the front of a cupboard
 * before a wall. */
bool
standsBefore (const PlaneShape& front, const PlaneShape& wall)
{
  constexpr int steps = constants.steps_to_side_of_front;
  constexpr double half_share = 0.5 * constants.sampled_share_of_front;
  const double cosine = front.normal.dot (wall.normal);
  if (cosine < constants.min_cosine_of_front || wall.area <= front.area ||
      wall.high < front.high)
    return false;
  int samples_before = 0;
  int samples = 0;
  for (int i = -steps; i <= steps; ++i)
    for (int j = -steps; j <= steps; ++j) {
      const Vector3d sample = front.center +
                              half_share * front.length * i / steps * front.long_axis +
                              half_share * front.width * j / steps * front.short_axis;
      const double distance = wall.normal.dot (sample - wall.center);
      const bool is_before = distance >= constants.min_before_wall &&
                             distance <= constants.max_before_wall &&
                             isInRectangle (wall, sample);
      samples_before += is_before ? 1 : 0;
      ++samples;
    }
  return 2 * samples_before > samples;
}

/** \brief Returns whether a vertical plane reaches a ceiling, or is wide and high and
 * stands before no other. */
bool
isWall (const PlaneShape& shape,
        const std::vector<PlaneShape>& shapes,
        const std::vector<Story>& stories)
{
  const double rise = shape.high - shape.low;
  const auto is_reached_ceiling = [&] (const Story& story) {
    return story.ceiling && rise >= constants.min_height_at_ceiling &&
           shape.high >= *story.ceiling - constants.max_gap_above_wall &&
           shape.low <= *story.ceiling - constants.min_height_at_ceiling;
  };
  if (std::any_of (stories.begin(), stories.end(), is_reached_ceiling))
    return true;
  if (rise < constants.min_wall_height || shape.span() < constants.min_wall_width)
    return false;
  return std::none_of (shapes.begin(), shapes.end(), [&] (const PlaneShape& other) {
    return other.orientation == Orientation::Vertical && standsBefore (shape, other);
  });
}

/** \brief Returns whether an upper floor at a height [m] is a roof: no vertical plane
 * rises from it by headroom. */
bool
isRoofAt (double height, const std::vector<PlaneShape>& shapes)
{
  return std::none_of (shapes.begin(), shapes.end(), [&] (const PlaneShape& shape) {
    return shape.orientation == Orientation::Vertical &&
           shape.low <= height + constants.max_step &&
           shape.high >= height + constants.headroom;
  });
}

/** \brief Returns whether a horizontal plane is a ceiling of its story or a part of it.
 */
bool
isCeiling (const PlaneShape& shape, const Story& story)
{
  const double rise = shape.middle - story.floor;
  if (rise < constants.headroom || shape.sight.is_below)
    return false;
  if (!story.ceiling) {
    const double min_area = rise < constants.high_ceiling
                                ? constants.min_area_of_low_ceiling
                                : constants.min_area_of_high_ceiling;
    return shape.faces_down && shape.area >= min_area;
  }
  const double drop = *story.ceiling - shape.middle;
  const double max_drop =
      shape.faces_down ? constants.max_drop_of_ceiling : constants.same_level;
  return shape.area >= constants.min_area_of_ceiling_part && drop <= max_drop;
}

/** \brief Returns whether a horizontal plane is a table.
 * \param[in] rise its height over the floor [m] */
bool
isTable (const PlaneShape& shape, double rise)
{
  return !shape.faces_down && rise >= constants.min_table_height &&
         rise <= constants.max_table_height && shape.area >= constants.min_table_area &&
         shape.area <= constants.max_table_area &&
         shape.width >= constants.min_table_width;
}

bool
isRamp (const PlaneShape& shape, const Story& story)
{
  return !shape.faces_down && shape.slope >= constants.min_ramp_slope &&
         shape.slope <= constants.max_ramp_slope &&
         shape.area >= constants.min_ramp_area &&
         shape.high - shape.low >= constants.min_ramp_rise &&
         std::abs (shape.low - story.floor) <= constants.max_ramp_off_floor;
}

bool
isSlopingRoof (const PlaneShape& shape, const Story& story)
{
  return shape.area >= constants.min_roof_area &&
         shape.middle - story.floor >= constants.headroom &&
         (!story.ceiling ||
          shape.high >= *story.ceiling - constants.max_gap_above_wall);
}

PlaneKind
kindOfHorizontal (const PlaneShape& shape,
                  const std::vector<PlaneShape>& shapes,
                  const std::vector<Story>& stories)
{
  const Story& story = storyAt (stories, shape.middle);
  const double rise = shape.middle - story.floor;
  const bool is_at_floor =
      rise < constants.same_floor ||
      (rise < constants.max_step && shape.area >= constants.min_step_area);
  if (is_at_floor) {
    const bool is_upper = &story != &stories.front();
    return is_upper && isRoofAt (story.floor, shapes) ? PlaneKind::Roof
                                                      : PlaneKind::Floor;
  }
  if (isCeiling (shape, story))
    return PlaneKind::Ceiling;
  // Up to the angle tolerance a horizontal plane may slope as a ramp does.
  if (isRamp (shape, story))
    return PlaneKind::Ramp;
  if (isTable (shape, rise))
    return PlaneKind::Table;
  if (rise < constants.max_step || shape.area < constants.min_slab_area)
    return PlaneKind::Other;
  const bool is_higher_ground = shape.sight.is_below &&
                                shape.area >= constants.min_ground_area &&
                                rise < constants.headroom; // beyond a curb or a slope
  if (is_higher_ground)
    return PlaneKind::Floor;
  const bool is_outdoors =
      rise >= constants.headroom && !story.ceiling && !shape.faces_down;
  return is_outdoors ? PlaneKind::Roof : PlaneKind::Slab;
}

PlaneKind
kindOf (const PlaneShape& shape,
        const std::vector<PlaneShape>& shapes,
        const std::vector<Story>& stories)
{
  if (shape.orientation == Orientation::Horizontal)
    return kindOfHorizontal (shape, shapes, stories);
  if (shape.orientation == Orientation::Vertical)
    return isWall (shape, shapes, stories) ? PlaneKind::Wall : PlaneKind::Other;
  const Story& story = storyAt (stories, shape.low);
  if (isRamp (shape, story))
    return PlaneKind::Ramp;
  return isSlopingRoof (shape, story) ? PlaneKind::Roof : PlaneKind::Other;
}

/** \brief Returns whether the rms distance of the points of a plane to it is too large
 * for a part of a building, as that of a hillside is. */
bool
hasRelief (const PlaneSegment& plane, double meter)
{
  const double rms = plane.rms();
  return rms > constants.max_rms_of_roof * meter ||
         (plane.noise && rms > constants.max_noises_of_roof * *plane.noise);
}

/** \brief Returns all planes in a frame whose z is up [m]. Planes steeper than 60
 * degrees (min_cosine_from_above) get no outline. */
std::vector<PlaneFromAbove>
planesFromAbove (const Scene& scene,
                 const std::vector<PlaneExtent>& extents,
                 double meter)
{
  const Eigen::Matrix3d turn = turnUpright (scene.up);
  std::vector<PlaneFromAbove> planes;
  for (std::size_t i = 0; i < extents.size(); ++i) {
    const PlaneShape& shape = scene.shapes[i];
    const Vector3d normal = turn * shape.normal;
    PlaneFromAbove& plane = planes.emplace_back();
    plane.normal = normal.z() < 0.0 ? -normal : normal;
    plane.center = turn * shape.center;
    plane.area = shape.area;
    if (plane.normal.z() >= constants.min_cosine_from_above)
      for (const Vector3d& corner : extents[i].hull)
        plane.hull.push_back (turn * corner / meter);
  }
  return planes;
}

/** \brief Returns whether a vertical plane reaches down from a level plane, as a wall
 * does from a ceiling. */
bool
hasWallsBelow (const PlaneShape& level, const std::vector<PlaneShape>& shapes)
{
  const double reach = 0.5 * std::hypot (level.length, level.width);
  return std::any_of (shapes.begin(), shapes.end(), [&] (const PlaneShape& wall) {
    return wall.orientation == Orientation::Vertical &&
           std::abs (wall.high - level.middle) <= constants.max_gap_above_wall &&
           wall.low <= level.middle - constants.headroom &&
           (wall.center - level.center).norm() <= reach;
  });
}

/** \brief Returns whether a level plane is ground: less than half of it has another
 * plane below it, and no wall reaches down from it. */
bool
isGround (const PlaneShape& level,
          PlaneKind kind,
          const PlaneFromAbove& from_above,
          const std::vector<PlaneFromAbove>& all,
          const std::vector<PlaneShape>& shapes)
{
  // A slab may be a platform a step above the ground, a ceiling is headroom above it.
  const double min_drop =
      kind == PlaneKind::Slab ? constants.max_step : constants.headroom;
  return isLowest (from_above, all, min_drop) && !hasWallsBelow (level, shapes);
}

/** \brief Changes ceilings and slabs that are ground, such as a field on a hill far
 * above another field, to Floor. Those with the relief of a hillside become Other. */
void
nameGround (const std::vector<PlaneSegment>& planes,
            const Scene& scene,
            const std::vector<PlaneFromAbove>& from_above,
            double meter,
            std::vector<PlaneKind>& kinds)
{
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const PlaneShape& shape = scene.shapes[i];
    const bool is_overhead =
        kinds[i] == PlaneKind::Ceiling || kinds[i] == PlaneKind::Slab;
    if (!is_overhead || shape.faces_down || shape.area < constants.min_ground_area)
      continue;
    if (hasRelief (planes[i], meter))
      kinds[i] = PlaneKind::Other;
    else if (isGround (shape, kinds[i], from_above[i], from_above, scene.shapes))
      kinds[i] = PlaneKind::Floor;
  }
}

/** \brief Changes roofs that are hillsides to Other. Walls are not tested: in depth
 * images they bend by as much as hillsides, so that only 17 % of the walls of 20 rooms
 * would remain walls. */
void
excludeHills (const std::vector<PlaneSegment>& planes,
              const std::vector<PlaneFromAbove>& from_above,
              double meter,
              std::vector<PlaneKind>& kinds)
{
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (kinds[i] == PlaneKind::Roof &&
        (hasRelief (planes[i], meter) || isPartOfGround (from_above[i], from_above)))
      kinds[i] = PlaneKind::Other;
}

/** \brief Returns whether a vertical plane lies in the plane of a wall and faces the
 * same way. */
bool
isPartOfWall (const PlaneShape& part, const PlaneShape& wall)
{
  return part.normal.dot (wall.normal) >= constants.min_cosine_of_part &&
         std::abs (wall.normal.dot (part.center - wall.center)) <=
             constants.max_off_wall;
}

/** \brief Changes vertical planes in the plane of a wall to Wall: parts of a wall may
 * be too small for \ref isWall. Planes named here do not make walls of others. */
void
nameWallParts (const std::vector<PlaneShape>& shapes, std::vector<PlaneKind>& kinds)
{
  const std::vector<PlaneKind> given_kinds = kinds;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (std::size_t j = 0; j < shapes.size(); ++j)
      if (shapes[i].orientation == Orientation::Vertical &&
          given_kinds[j] == PlaneKind::Wall && isPartOfWall (shapes[i], shapes[j]))
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

/** \brief Returns the shapes with heights along \p up, or along the normal of the
 * ground if the sensor leans. Then the orientations are named anew, with the default
 * tolerance of the detectors.
 * \param[in] up unit vector */
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
  const std::vector<Story> stories = storiesIn (shapes);
  std::vector<PlaneKind> kinds;
  for (const PlaneShape& shape : shapes)
    kinds.push_back (kindOf (shape, shapes, stories));
  nameWallParts (shapes, kinds);
  const std::vector<PlaneFromAbove> from_above =
      planesFromAbove (scene, extents, meter);
  excludeHills (planes, from_above, meter, kinds);
  nameGround (planes, scene, from_above, meter, kinds);
  return kinds;
}

} // namespace pcl_ops
