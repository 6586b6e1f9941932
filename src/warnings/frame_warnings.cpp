// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warnings/frame_warnings.h"

#include <Eigen/Geometry>

#include "warnings/constants.h"
#include <pcl_ops/orientation.h>
#include <pcl_ops/visibility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace pcl_ops::internal {

namespace {

/** \brief A vector as text, "0,0,1", each number with up to \p digits significant
 * digits. */
std::string
vectorText (const Eigen::Vector3d& vector, int digits)
{
  std::ostringstream text;
  text.imbue (std::locale::classic());
  text.precision (digits);
  // Adding 0 makes -0 positive.
  text << vector.x() + 0.0 << ',' << vector.y() + 0.0 << ',' << vector.z() + 0.0;
  return text.str();
}

/** \brief The parameter meter with the value \p length, the length of a meter in units
 * of the cloud; in Python also the functions that have this parameter. */
std::string
meterText (const std::string& length, const ParameterText& text)
{
  return text.of ("meter", length) +
         (text.isPython() ? " to plane_kinds and floor_plan" : "");
}

/** \brief Distance from |number|, rounded to single precision, to the next larger
 * number in single precision. */
double
stepOfSingle (double number)
{
  const auto single = static_cast<float> (std::abs (number));
  constexpr float upwards = std::numeric_limits<float>::infinity();
  return double (std::nextafter (single, upwards)) - double (single);
}

/** \brief Extent of the coordinates of points along one axis, without the stray_share
 * of smallest ones and of largest ones. */
double
extentWithoutStrays (std::vector<float> values)
{
  const auto strays = static_cast<std::ptrdiff_t> (warning_constants.stray_share *
                                                   static_cast<double> (values.size()));
  std::sort (values.begin(), values.end());
  return double (*(values.end() - 1 - strays)) - double (*(values.begin() + strays));
}

/** \brief Whether x and y look like degrees and z like meters. */
bool
looksLikeDegrees (const LabeledSample& sample)
{
  const Eigen::Array2d max_degrees (180.0, 90.0); // longitude, latitude
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < sample.labels.size(); ++i)
    box.extend (sample[i]);
  if (box.isEmpty())
    return false;
  const Eigen::Array3d sides = box.sizes();
  const double width = sides.head<2>().maxCoeff();
  const bool are_degrees = (box.min().head<2>().array() >= -max_degrees).all() &&
                           (box.max().head<2>().array() <= max_degrees).all();
  const bool is_narrow = sides.head<2>().minCoeff() > 0.0 &&
                         width < warning_constants.max_width_of_degrees;
  return are_degrees && is_narrow &&
         sides.z() > warning_constants.min_height_in_widths * width;
}

/** \brief Whether a plane is a floor for this up axis: level, with enough points, and
 * with hardly any points of the cloud below it. */
bool
isFloorAlong (const Eigen::Vector3d& up,
              const PlaneSegment& plane,
              const LabeledSample& sample)
{
  const std::optional<PlaneFit> fit = fitPlane (plane.moments);
  const double min_points =
      warning_constants.min_floor_share * static_cast<double> (sample.finite_points);
  if (!fit || plane.moments.count < min_points ||
      slopeOf (fit->plane.normal, up) > warning_constants.max_floor_slope)
    return false;
  // Turns signed distances to the plane into heights over it.
  const double sign = fit->plane.normal.dot (up) > 0.0 ? 1.0 : -1.0;
  const double rms = std::sqrt (fit->variances[0]);
  const double min_height = -warning_constants.rms_below_floor * rms;
  std::size_t points_below = 0;
  for (std::size_t i = 0; i < sample.labels.size(); ++i)
    points_below += sign * fit->plane.distance (sample[i]) < min_height ? 1 : 0;
  return static_cast<double> (points_below) <=
         warning_constants.max_share_below_floor *
             static_cast<double> (sample.labels.size());
}

/** \brief Whether nearly all points lie in the view of a depth camera at zero that
 * looks along z. */
bool
looksLikeCamera (const LabeledSample& sample)
{
  const double min_cosine = std::cos (warning_constants.max_angle_ahead);
  std::size_t ahead = 0;
  for (std::size_t i = 0; i < sample.labels.size(); ++i) {
    const Eigen::Vector3d position = sample[i];
    ahead += position.z() >= min_cosine * position.norm() ? 1 : 0;
  }
  return static_cast<double> (ahead) >=
         warning_constants.min_share_ahead * static_cast<double> (sample.labels.size());
}

} // namespace

std::optional<ResultWarning>
warnOfEmptyPlan (const ResultContext& context,
                 const std::optional<ResultWarning>& unit_warning,
                 const ParameterText& text)
{
  const std::optional<PlanCounts>& plan = context.plan;
  if (!plan || plan->walls > 0)
    return std::nullopt;
  const std::string wall_planes = std::to_string (plan->wall_planes_found);
  std::string reason;
  if (unit_warning)
    reason = unit_warning->text;
  else if (plan->wall_planes_found == 0)
    reason = std::string ("no plane is a wall") +
             (plan->has_floor ? "" : " and none a floor") + "; " +
             (context.tiles ? "z has to be up; give " // tiles are found along z
                            : "give " + text.of ("up", "") + ", or ") +
             text.of ("meter", "") + " for a cloud that is not in meters";
  else if (plan->wall_planes_kept == 0)
    reason =
        "filters drop all planes that are walls (" + wall_planes + "); leave them out";
  else
    reason = "none of the planes that are walls (" + wall_planes +
             ") is where it is cut; give another " +
             text.of (text.isPython() ? "cut-height" : "plan-height", "");
  return ResultWarning{"empty-plan", "the floor plan has 0 walls: " + reason};
}

std::optional<ResultWarning>
warnOfPoses (const ResultContext& context, const ParameterText& text)
{
  if (!context.has_camera_poses)
    return std::nullopt;
  const std::string fix =
      text.isPython() ? "inverse (Tr) @ pose @ Tr with the (4, 4) Tr of calib.txt"
                      : text.of ("calib", "calib.txt") + " of the same sequence";
  return ResultWarning{"camera-poses",
                       "the poses move along z as those of KITTI's camera do, and are "
                       "used as the lidar's; give " +
                           fix};
}

std::optional<ResultWarning>
warnOfUnit (const LabeledSample& sample,
            const ResultContext& context,
            const ParameterText& text)
{
  if (context.unit == CoordinateUnit::Degree)
    return ResultWarning{"degrees",
                         "x and y are degrees, which are no lengths; project the cloud "
                         "to meters, as UTM does"};
  if (context.has_meter || context.unit == CoordinateUnit::Meter)
    return std::nullopt;
  if (context.unit == CoordinateUnit::Foot)
    return ResultWarning{
        "feet",
        "the reference system of the file is in feet, kinds and floor plans are made "
        "by rules in meters; give " +
            meterText ("3.2808", text)}; // feet per meter
  if (sample.labels.empty())
    return std::nullopt;
  if (looksLikeDegrees (sample))
    return ResultWarning{"degrees",
                         "x and y look like degrees beside a z in meters; project the "
                         "cloud to meters, as UTM does"};
  const double extents[] = {extentWithoutStrays (sample.points.x),
                            extentWithoutStrays (sample.points.y),
                            extentWithoutStrays (sample.points.z)};
  if (*std::min_element (std::begin (extents), std::end (extents)) <
      warning_constants.min_extent_of_millimeters)
    return std::nullopt;
  return ResultWarning{
      "millimeters",
      "the cloud is " + roundedLength (extents[0]) + " x " +
          roundedLength (extents[1]) + " x " + roundedLength (extents[2]) +
          " wide, which looks like millimeters; give " + meterText ("1000", text)};
}

std::optional<ResultWarning>
warnOfPrecision (const LabeledSample& sample, const ResultContext& context)
{
  if (sample.labels.empty() || context.tiles) // tiles are in a frame of their own
    return std::nullopt;
  // The origin of the sample in the frame of the cloud, as its coordinates were
  // rounded.
  const Eigen::Vector3d origin_in_cloud = sample.origin - context.shift;
  const std::vector<float>* const axes[] = {
      &sample.points.x, &sample.points.y, &sample.points.z};
  std::array<double, 3> extents;
  double step = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> values = *axes[axis];
    step = std::max (step, stepOfSingle (origin_in_cloud[axis] + medianOf (values)));
    extents[axis] = extentWithoutStrays (std::move (values));
  }
  std::sort (extents.begin(), extents.end());
  // The spacing as if the points covered a rectangle with the two largest extents.
  const double spacing =
      std::sqrt (extents[1] * extents[2] / static_cast<double> (sample.finite_points));
  const bool spans_an_area = extents[1] > 0.0;
  if (!spans_an_area || step <= warning_constants.max_step_of_spacing * spacing)
    return std::nullopt;
  return ResultWarning{"coarse-coordinates",
                       "coordinates in single precision are " + roundedLength (step) +
                           " apart so far from zero, points about " +
                           roundedLength (spacing) +
                           "; keep them in double precision from the start, or "
                           "subtract an offset before"};
}

std::optional<ResultWarning>
warnOfViewpoint (const CloudView& cloud,
                 const ResultContext& context,
                 const ParameterText& text)
{
  if (!context.viewpoint || isSeenFrom (*context.viewpoint, cloud))
    return std::nullopt;
  constexpr int digits = 10; // UTM to the millimeter
  const std::string position = vectorText (*context.viewpoint + context.shift, digits);
  return ResultWarning{
      "viewpoint",
      text.isPython()
          ? "the points were not seen from viewpoint=(" + position +
                "), which normals are turned to; give the position of the sensor, or "
                "leave it out"
          : "the cloud was not seen from its VIEWPOINT " + position +
                ", which normals are turned to; write the position of the sensor into "
                "the file, or 0 0 0 if it is not known"};
}

std::optional<ResultWarning>
warnOfUp (const LabeledSample& sample,
          const std::vector<PlaneSegment>& planes,
          const ResultContext& context,
          const ParameterText& text)
{
  if (!context.uses_kinds || context.up_knowledge == UpKnowledge::Known ||
      planes.empty())
    return std::nullopt;
  constexpr int digits = 3;
  const std::string used_up = vectorText (context.up, digits);
  const std::string up_parameter = text.ofAxis ("up");
  if (context.up_knowledge == UpKnowledge::NotFound)
    return ResultWarning{"unknown-up",
                         "the planes cannot tell which way is up, and kinds of planes "
                         "are those of " +
                             used_up + "; give " + up_parameter};
  const auto isFloor = [&] (const PlaneSegment& plane) {
    return isFloorAlong (context.up, plane, sample);
  };
  const auto isUpAheadOfCamera = [&] {
    return looksLikeCamera (sample) &&
           std::none_of (planes.begin(), planes.end(), isFloor);
  };
  const bool is_doubtful = context.suggested_up || isUpAheadOfCamera();
  if (!is_doubtful)
    return std::nullopt;
  return ResultWarning{
      "unknown-up",
      "kinds of planes need to know which way is up, and " + used_up +
          (context.suggested_up ? " is not what the planes suggest"
                                : " is ahead in a cloud that looks like a depth "
                                  "camera's, without a floor") +
          "; give " + text.ofWord ("up", "auto") + " or " + up_parameter};
}

} // namespace pcl_ops::internal
