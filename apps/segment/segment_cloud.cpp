// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_cloud.h"

#include "warnings.h"
#include <cli/errors.h>
#include <cli/program.h>
#include <detection/known_sensor.h>
#include <detection/warning_lines.h>
#include <io/las_crs.h>
#include <io/las_file.h>
#include <pcl_ops/visibility.h>

#include <algorithm>
#include <numeric>

#if PCL_OPS_WITH_SURFACE
#include <pcl_ops/surface/concave_hull.h>
#endif

namespace pcl_ops::apps {

namespace {

/** \brief Returns 1, 2, ... size. */
std::vector<std::uint32_t>
numbersUpTo (std::size_t size)
{
  std::vector<std::uint32_t> numbers (size);
  std::iota (numbers.begin(), numbers.end(), 1U);
  return numbers;
}

/** \brief Replaces the planes by their connected pieces. The planes themselves move to
 * Detected::whole_planes, without inliers. */
void
divideIntoPieces (const SegmentOptions& options,
                  const XyzCloud& cloud,
                  Detected& detected)
{
  const auto threads_option = options.detector.numbers.find ("threads");
  const unsigned threads = threads_option == options.detector.numbers.end()
                               ? 1
                               : static_cast<unsigned> (threads_option->second);
  PlanePieces found =
      findPlanePieces (cloud, detected.planes, options.piece_parameters, threads);
  detected.whole_planes = std::move (detected.planes);
  for (PlaneSegment& plane : detected.whole_planes)
    plane.inliers.clear();
  detected.planes = std::move (found.pieces);
  detected.lies_on = std::move (found.planes);
  detected.settings["piece_gap"] = options.piece_parameters.max_gap;
}

/** \brief Finds planes, or their pieces if asked for, and moves them to the frame of
 * the file. */
Detected
detectPlanes (const SegmentOptions& options,
              const ShiftedCloud& shifted,
              const FileCloud& cloud)
{
  Detected detected =
      runMethod (methodCalled (options.method), options.detector, shifted.cloud);
  // A file without a sensor position has the sensor at zero. In a shifted cloud that is
  // another position, so the detector takes it for known and does not turn normals up.
  if (!shifted.shift.isZero (0.0) && cloud.origin.head<3>().isZero (0.0f))
    turnUnseenUp (*shifted.cloud,
                  shifted.cloud->sensor_origin_.head<3>().cast<double>(),
                  detected.up.cast<double>(),
                  detected.planes);
  if (options.divides_into_pieces)
    divideIntoPieces (options, *shifted.cloud, detected);
  for (std::vector<PlaneSegment>* planes : {&detected.planes, &detected.whole_planes}) {
    for (PlaneSegment& plane : *planes)
      plane.moveBy (shifted.shift);
    if (cloud.is_survey)
      turnUp (*planes, detected.up.cast<double>());
  }
  return detected;
}

/** \brief Checks that a LAS output can hold the input with labels.
 * \throws UsageError if the input is no LAS, WorkError if labels cannot be added to it
 */
void
checkTakesLabels (const SegmentOptions& options,
                  const Task& task,
                  const FileCloud& cloud)
{
  const std::string& output = task.outputs.cloud;
  if (!isLasName (output))
    return;
  if (cloud.las == nullptr)
    throw UsageError (output, "is LAS, which the input is not; give a file .pcd");
  std::vector<LasField> fields = {label_field};
  if (options.has_distances)
    fields.push_back (distance_field);
  if (options.divides_into_pieces)
    fields.push_back (plane_field);
  const std::string problem = cloud.las->validate (fields);
  if (!problem.empty())
    throw WorkError (nameOfInput (task), problem);
}

/** \brief Returns the convex or concave hull of points on a plane.
 * \param[in] hull "convex" or "concave", the latter only with pcl_ops_surface */
PlanarRings
outlineOf (const PlanarPoints& points, [[maybe_unused]] const std::string& hull)
{
#if PCL_OPS_WITH_SURFACE
  if (hull == "concave")
    return concaveOutline (points);
#endif
  return {convexHull (points)};
}

/** \brief Returns the extent of a plane in the frame of the file.
 * \param[in] shifted the cloud that the plane was found in
 * \param[in] plane in the frame of the file
 * \param[in] hull "convex" or "concave" */
PlaneExtent
extentInFile (const ShiftedCloud& shifted,
              const PlaneSegment& plane,
              const std::string& hull)
{
  const PlaneFrame frame_in_cloud (plane.centroid - shifted.shift, plane.normal);
  const PlaneFrame frame_in_file (plane.centroid, plane.normal);
  const PlanarPoints points = pointsOnPlane (*shifted.cloud, plane, frame_in_cloud);
  return extentOf (outlineOf (points, hull), points, frame_in_file);
}

/** \brief Makes nearly parallel, orthogonal and coplanar planes exactly so. */
void
regularize (Detected& detected)
{
  RegularizedPlanes found = regularizePlanes (detected.planes);
  detected.planes = std::move (found.planes);
  detected.moves = std::move (found.moves);
}

/** \brief Sets the kinds of planes, such as floor and wall, and the convex outlines on
 * which the kinds depend.
 * \param[in] meter length of a meter in the unit of the cloud */
void
setKinds (const FileCloud& cloud,
          const ShiftedCloud& shifted,
          double meter,
          Detected& detected)
{
  for (const PlaneSegment& plane : detected.planes)
    detected.extents.push_back (extentInFile (shifted, plane, "convex"));
  detected.kinds = planeKinds (detected.planes,
                               detected.extents,
                               detected.up.cast<double>(),
                               meter,
                               knownSensor (cloud, shifted));
  if (meter != 1.0)
    detected.settings["meter"] = meter;
}

/** \brief Returns the likeliest reason for few points on planes: first damage of the
 * cloud, then coordinates in degrees, then parameters that do not suit the cloud. */
std::string
likeliestCause (const Report& report)
{
  if (!report.damage.empty())
    return "the cloud " + report.damage;
  for (const ResultWarning& warning : report.warnings)
    if (warning.code == "degrees")
      return warning.text;
  return report.detected.advice;
}

std::size_t
countOf (PlaneKind kind, const Detected& detected)
{
  return static_cast<std::size_t> (
      std::count (detected.kinds.begin(), detected.kinds.end(), kind));
}

/** \brief Finds the floor plan, and adds a warning if it has no wall.
 * \param[in] counts floors and wall planes before any plane was dropped */
void
findPlan (const SegmentOptions& options,
          const ShiftedCloud& shifted,
          PlanCounts counts,
          Report& report)
{
  const Detected& detected = report.detected;
  report.plan = findFloorPlan (*shifted.cloud,
                               detected.planes,
                               detected.kinds,
                               detected.up.cast<double>(),
                               options.plan_parameters,
                               shifted.shift);
  counts.walls = report.plan->walls.size();
  counts.wall_planes_kept = countOf (PlaneKind::Wall, detected);
  constexpr bool is_in_tiles = false;
  putWarningOnPlan (counts, is_in_tiles, report.warnings);
}

/** \brief Returns the options, with the reference system and the unit of a LAS file
 * where the user gave none. */
SegmentOptions
withCrsAndUnitOf (const FileCloud& cloud, SegmentOptions options)
{
  if (cloud.las == nullptr)
    return options;
  if (options.map.crs.empty())
    options.map.crs = crsOf (*cloud.las);
  const double meter = unitsInMeter (*cloud.las);
  if (!options.has_meter && meter != 1.0) {
    options.plan_parameters.meter = meter;
    options.has_meter = true;
  }
  return options;
}

/** \brief Finds the planes of a cloud and the warnings on them, before any plane is
 * regularized or dropped. */
Report
reportOn (const SegmentOptions& options,
          const Task& task,
          const FileCloud& cloud,
          const ShiftedCloud& shifted)
{
  Report report;
  report.input = nameOfInput (task);
  report.method = options.method;
  report.points = cloud.size();
  report.damage = damageOf (shifted);
  report.detected = detectPlanes (options, shifted, cloud);
  turnToScanners (report.detected.planes, cloud.scans);
  if (!options.quiet || !task.outputs.planes.empty())
    report.warnings = warningsOn (options, task, cloud, shifted, report.detected);
  if (!report.detected.advice.empty())
    report.detected.advice = likeliestCause (report);
  return report;
}

/** \brief Regularizes planes if asked for, sets their kinds, drops planes that are not
 * chosen, and finds the floor plan if asked for. */
void
regularizeAndChoosePlanes (const SegmentOptions& options,
                           const Outputs& outputs,
                           const FileCloud& cloud,
                           const ShiftedCloud& shifted,
                           Report& report)
{
  if (options.regularizes)
    regularize (report.detected);
  setKinds (cloud, shifted, options.plan_parameters.meter, report.detected);
  PlanCounts counts;
  counts.wall_planes_found = countOf (PlaneKind::Wall, report.detected);
  counts.has_floor = countOf (PlaneKind::Floor, report.detected) > 0;
  const auto extent_of = [&] (const PlaneSegment& plane) {
    return extentInFile (shifted, plane, options.hull);
  };
  report.dropped = keepChosen (options.choice, extent_of, report.detected);
  if (!outputs.floor_plan.empty())
    findPlan (options, shifted, counts, report);
}

/** \brief Sets Report::extents. \ref setKinds has computed convex ones; concave ones
 * are computed only if an output needs them. */
void
setExtents (const SegmentOptions& options,
            const Outputs& outputs,
            const ShiftedCloud& shifted,
            Report& report)
{
  if (options.hull == "convex")
    report.extents = report.detected.extents;
  else if (!outputs.planes.empty() || !outputs.mesh.empty() || !outputs.view.empty())
    for (const PlaneSegment& plane : report.detected.planes)
      report.extents.push_back (extentInFile (shifted, plane, options.hull));
}

FileCloud
loadInput (const Task& task)
{
  if (task.input == standard_stream)
    return loadStandardInput();
  return loadCloud (task.input);
}

} // namespace

std::string
nameOfInput (const Task& task)
{
  return task.input == standard_stream ? standard_input : task.input;
}

Report
segmentCloud (const SegmentOptions& given_options,
              const Task& task,
              const GiveIds& give_ids,
              StageLines* progress)
{
  const auto begin = [&] (const std::string& stage) {
    stopIfInterrupted();
    if (progress != nullptr)
      progress->begin (nameOfInput (task) + ": " + stage);
  };
  begin ("reading");
  const FileCloud cloud = loadInput (task);
  const SegmentOptions options = withCrsAndUnitOf (cloud, given_options);
  checkTakesLabels (options, task, cloud);
  begin ("finding planes in " + std::to_string (cloud.size()) + " points");
  const ShiftedCloud shifted = shiftedCloudOf (cloud, voxelStepOf (options.detector));
  Report report = reportOn (options, task, cloud, shifted);
  regularizeAndChoosePlanes (options, task.outputs, cloud, shifted, report);
  report.ids = numbersUpTo (report.detected.planes.size());
  report.whole_plane_ids = numbersUpTo (report.detected.whole_planes.size());
  const Eigen::Vector3d sensor = cloud.origin.head<3>().cast<double>();
  if (give_ids)
    give_ids (sensor.isZero (0.0) ? shifted.shift : sensor, report);
  setExtents (options, task.outputs, shifted, report);
  begin ("writing");
  report.file_notes = saveOutputs (options, task.outputs, cloud, shifted, report);
  return report;
}

} // namespace pcl_ops::apps
