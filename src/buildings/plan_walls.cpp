// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plan_walls.h"

#include "constants.h"
#include "planar_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl_ops::internal::buildings {
namespace {

/** \brief Returns the position along \p line where \p other crosses it [m]; nothing for
 * nearly parallel lines. */
std::optional<double>
crossingWith (const PlanLine& line, const PlanLine& other)
{
  const double sine = cross (line.along, other.along);
  if (std::abs (sine) < constants.min_sine_of_meeting)
    return {};
  return cross (other.origin - line.origin, other.along) / sine;
}

/** \brief Returns the position at which another wall meets an end of a wall, and to
 * which the end is moved: the nearest crossing with the line of another face, within \p
 * max_snap [m] of the end and of points of that face. Nothing if no wall meets the end.
 */
std::optional<double>
meetingAt (double end,
           const WallFace& face,
           const std::vector<WallFace>& faces,
           double max_snap)
{
  std::optional<double> nearest;
  double least_distance = max_snap;
  for (const WallFace& other : faces) {
    const std::optional<double> position = crossingWith (face.line, other.line);
    if (!position || std::abs (*position - end) > least_distance)
      continue;
    const double on_other = other.line.positionOf (face.line.at (*position));
    const bool has_points_at_crossing = std::any_of (
        other.seen.begin(), other.seen.end(), [&] (const Interval& interval) {
          return on_other >= interval.from - max_snap &&
                 on_other <= interval.to + max_snap;
        });
    if (has_points_at_crossing) {
      nearest = *position;
      least_distance = std::abs (*position - end);
    }
  }
  return nearest;
}

/** \brief Returns the walls on a face, with the ends of their points. A wall includes
 * gaps that are no longer than max_opening and have no end that another wall meets. */
Intervals
wallsOn (const WallFace& face,
         const std::vector<WallFace>& faces,
         const FloorPlanParameters& parameters)
{
  Intervals walls;
  for (const Interval& seen : face.seen) {
    bool begins_wall =
        walls.empty() || seen.from - walls.back().to > parameters.max_opening;
    if (!begins_wall)
      for (const double end : {walls.back().to, seen.from}) {
        const bool meets_wall =
            meetingAt (end, face, faces, parameters.max_snap).has_value();
        begins_wall = begins_wall || meets_wall;
      }
    if (begins_wall)
      walls.push_back (seen);
    else
      walls.back().to = seen.to;
  }
  return walls;
}

/** \brief Returns the parts of a wall without points at the height of the cut. */
Intervals
gapsOf (const Interval& whole, const Intervals& at_cut)
{
  Intervals gaps;
  double covered_to = whole.from;
  for (const Interval& part : at_cut) {
    if (part.to <= whole.from || part.from >= whole.to)
      continue;
    if (part.from > covered_to)
      gaps.push_back ({covered_to, part.from});
    covered_to = std::max (covered_to, part.to);
  }
  if (covered_to < whole.to)
    gaps.push_back ({covered_to, whole.to});
  return gaps;
}

/** \brief Returns the opening of a gap. Its sill and head are the heights over the
 * floor of the wall points next below and above the cut, in the middle of the gap. */
PlanOpening
openingOf (const WallFace& face,
           const Interval& gap,
           double floor,
           double height_of_cut)
{
  const double margin = constants.margin_of_opening * gap.length();
  const Interval middle{gap.from + margin, gap.to - margin};
  PlanOpening opening;
  opening.from = face.line.at (gap.from);
  opening.to = face.line.at (gap.to);
  for (const FacePoint& point : face.points) {
    if (point.position < middle.from || point.position > middle.to)
      continue;
    const double over_floor = point.height - floor;
    if (point.height < height_of_cut)
      opening.sill = std::max (opening.sill.value_or (over_floor), over_floor);
    else
      opening.head = std::min (opening.head.value_or (over_floor), over_floor);
  }
  return opening;
}

/** \brief Returns the distance from a wall to the nearest wall behind it that faces the
 * other way [m]; nothing if there is none within min_thickness and max_thickness. */
std::optional<double>
thicknessOf (const WallSpan& wall,
             const std::vector<WallFace>& faces,
             const std::vector<WallSpan>& spans)
{
  const PlanLine& line = faces[wall.face].line;
  std::optional<double> thickness;
  for (const WallSpan& other : spans) {
    const PlanLine& other_line = faces[other.face].line;
    if (line.along.dot (other_line.along) > constants.max_cosine_of_opposite)
      continue;
    // The other wall as an interval of the line of this wall. It runs the opposite way.
    const Interval opposite{line.positionOf (other_line.at (other.whole.to)),
                            line.positionOf (other_line.at (other.whole.from))};
    const double from = std::max (wall.whole.from, opposite.from);
    const double to = std::min (wall.whole.to, opposite.to);
    if (to - from < constants.min_common_length)
      continue;
    const Eigen::Vector2d middle = line.at (0.5 * (from + to));
    const double distance = -other_line.distance (middle);
    if (distance >= constants.min_thickness &&
        distance <= std::min (constants.max_thickness,
                              thickness.value_or (constants.max_thickness)))
      thickness = distance;
  }
  return thickness;
}

} // namespace

std::vector<WallSpan>
spansOf (const std::vector<WallFace>& faces, const FloorPlanParameters& parameters)
{
  std::vector<WallSpan> spans;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (const Interval& wall : wallsOn (faces[i], faces, parameters)) {
      const auto moved = [&] (double end) {
        return meetingAt (end, faces[i], faces, parameters.max_snap).value_or (end);
      };
      const Interval whole{moved (wall.from), moved (wall.to)};
      const bool is_seen_at_cut = coveredLength (whole, faces[i].at_cut) >
                                  constants.min_share_at_cut * whole.length();
      // A part no longer than the distance by which ends may be moved is no wall.
      if (whole.length() > parameters.max_snap &&
          (is_seen_at_cut || faces[i].ends_rooms))
        spans.push_back ({i, wall, whole, {}, !is_seen_at_cut});
    }
  return spans;
}

void
addOpenings (const std::vector<WallFace>& faces,
             const FloorPlanParameters& parameters,
             const IsHidden& is_hidden,
             std::vector<WallSpan>& spans)
{
  for (WallSpan& span : spans) {
    if (span.is_hidden)
      continue;
    const WallFace& face = faces[span.face];
    const double min_length = std::max (parameters.min_opening, face.longest_spacing);
    for (const Interval& gap : gapsOf (span.whole, face.at_cut)) {
      const bool has_length_of_opening =
          coveredLength (gap, {span.seen}) >= min_length &&
          gap.length() <= parameters.max_opening;
      const bool has_leaf = 2.0 * coveredLength (gap, face.leaves) > gap.length();
      if (has_length_of_opening && (has_leaf || !is_hidden (face.line, gap)))
        span.openings.push_back (gap);
    }
  }
}

std::vector<PlanWall>
toWalls (const std::vector<WallFace>& faces,
         const std::vector<WallSpan>& spans,
         double floor,
         double height_of_cut)
{
  std::vector<PlanWall> walls;
  for (const WallSpan& span : spans) {
    const WallFace& face = faces[span.face];
    PlanWall wall;
    wall.from = face.line.at (span.whole.from);
    wall.to = face.line.at (span.whole.to);
    wall.thickness = thicknessOf (span, faces, spans);
    for (const Interval& gap : span.openings)
      wall.openings.push_back (openingOf (face, gap, floor, height_of_cut));
    for (const auto& [plane, extent] : face.extent_of_plane)
      if (extent.from < span.whole.to && extent.to > span.whole.from)
        wall.planes.push_back (plane);
    walls.push_back (std::move (wall));
  }
  return walls;
}

} // namespace pcl_ops::internal::buildings
