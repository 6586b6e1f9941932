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
#include <iterator>
#include <numeric>

#if PCL_OPS_WITH_SURFACE
#include <pcl_ops/surface/concave_hull.h>
#endif

namespace pcl_ops::apps {

namespace {

std::vector<std::uint32_t>
numbersUpTo (std::size_t size)
{
  std::vector<std::uint32_t> numbers (size);
  std::iota (numbers.begin(), numbers.end(), 1U);
  return numbers;
}

/** \brief Has the pieces in place of the planes, beside what these are without them. */
void
divideIntoPieces (const SegmentOptions& options,
                  const XyzCloud& cloud,
                  Detected& detected)
{
  const auto threads = options.detector.numbers.find ("threads");
  PlanePieces found = findPlanePieces (cloud,
                                       detected.planes,
                                       options.of_pieces,
                                       threads == options.detector.numbers.end()
                                           ? 1
                                           : static_cast<unsigned> (threads->second));
  detected.whole_planes = std::move (detected.planes);
  for (PlaneSegment& plane : detected.whole_planes)
    plane.inliers.clear();
  detected.planes = std::move (found.pieces);
  detected.lies_on = std::move (found.planes);
  detected.settings["piece_gap"] = options.of_pieces.max_gap;
}

Detected
detectPlanes (const SegmentOptions& options,
              const ShiftedCloud& shifted,
              const FileCloud& cloud)
{
  Detected detected =
      runMethod (methodCalled (options.method), options.detector, shifted.cloud);
  // Of other clouds the detector knows.
  if (!shifted.shift.isZero (0.0) && cloud.origin.head<3>().isZero (0.0f))
    turnUnseenUp (*shifted.cloud,
                  shifted.cloud->sensor_origin_.head<3>().cast<double>(),
                  detected.up.cast<double>(),
                  detected.planes);
  if (options.pieces)
    divideIntoPieces (options, *shifted.cloud, detected);
  for (auto* planes : {&detected.planes, &detected.whole_planes}) {
    for (PlaneSegment& plane : *planes)
      plane.moveBy (shifted.shift);
    if (cloud.is_survey)
      turnUp (*planes, detected.up.cast<double>());
  }
  return detected;
}

/** \brief Refuses an output that cannot have all of the input and labels. */
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
  if (options.distances)
    fields.push_back (distance_field);
  if (options.pieces)
    fields.push_back (plane_field);
  const std::string problem = cloud.las->validate (fields);
  if (!problem.empty())
    throw WorkError (nameOfInput (task), problem);
}

PlanarRings
outlineOf (const PlanarPoints& points, [[maybe_unused]] const std::string& hull)
{
#if PCL_OPS_WITH_SURFACE
  if (hull == "concave")
    return concaveOutline (points);
#endif
  return {convexHull (points)};
}

/** \brief Where a plane ends, in the file's frame.
 * \param[in] shifted the cloud the plane was found in
 * \param[in] hull "convex" or "concave" */
PlaneExtent
extentInFile (const ShiftedCloud& shifted,
              const PlaneSegment& plane,
              const std::string& hull)
{
  const PlaneFrame in_cloud (plane.centroid - shifted.shift, plane.normal);
  const PlaneFrame in_file (plane.centroid, plane.normal);
  const PlanarPoints points = pointsOnPlane (*shifted.cloud, plane, in_cloud);
  return extentOf (outlineOf (points, hull), points, in_file);
}

/** \brief Moves planes to where they are exactly parallel, orthogonal and coplanar. */
void
regularize (Detected& detected)
{
  RegularizedPlanes found = regularizePlanes (detected.planes);
  detected.planes = std::move (found.planes);
  detected.moves = std::move (found.moves);
}

/** \brief Says what planes are, by their convex outlines, which are kept.
 * \param[in] meter its length in the unit of the cloud */
void
nameKinds (const FileCloud& cloud,
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

/** \brief Why so few points are on planes, with the fix. What is wrong with a cloud
 * comes before what might be wrong with parameters. */
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

/** \param[in] counts of the planes before any was left out */
void
drawPlan (const SegmentOptions& options,
          const ShiftedCloud& shifted,
          PlanCounts counts,
          Report& report)
{
  const Detected& detected = report.detected;
  report.plan = findFloorPlan (*shifted.cloud,
                               detected.planes,
                               detected.kinds,
                               detected.up.cast<double>(),
                               options.of_plan,
                               shifted.shift);
  counts.walls = report.plan->walls.size();
  counts.wall_planes_kept = countOf (PlaneKind::Wall, detected);
  putWarningOnPlan (counts, report.warnings);
}

/** \brief Has the reference system of a file name maps and say the unit, unless the
 * user does. */
SegmentOptions
withSystemOf (const FileCloud& cloud, SegmentOptions options)
{
  if (cloud.las == nullptr)
    return options;
  if (options.map.crs.empty())
    options.map.crs = crsOf (*cloud.las);
  const double meter = unitsInMeter (*cloud.las);
  if (!options.has_meter && meter != 1.0) {
    options.of_plan.meter = meter;
    options.has_meter = true;
  }
  return options;
}

} // namespace

std::string
nameOfInput (const Task& task)
{
  return task.input == standard_stream ? standard_input : task.input;
}

Report
segmentCloud (const SegmentOptions& given,
              const Task& task,
              const GiveIds& give_ids,
              StageLines* lines)
{
  const std::string name = nameOfInput (task);
  const auto begin = [&] (const std::string& stage) {
    stopIfInterrupted();
    if (lines != nullptr)
      lines->begin (name + ": " + stage);
  };
  begin ("reading");
  const bool is_piped = task.input == standard_stream;
  const FileCloud cloud = is_piped ? loadStandardInput() : loadCloud (task.input);
  const SegmentOptions options = withSystemOf (cloud, given);
  checkTakesLabels (options, task, cloud);
  begin ("finding planes in " + std::to_string (cloud.size()) + " points");
  const ShiftedCloud shifted = shiftedCloudOf (cloud, voxelStepOf (options.detector));
  Report report;
  report.input = name;
  report.method = options.method;
  report.points = cloud.size();
  report.damage = damageOf (shifted);
  report.detected = detectPlanes (options, shifted, cloud);
  turnToScanners (report.detected.planes, cloud.scans);
  if (!options.quiet || !task.outputs.planes.empty())
    report.warnings = warningsOn (options, task, cloud, shifted, report.detected);
  if (!report.detected.advice.empty())
    report.detected.advice = likeliestCause (report);
  if (options.regularize)
    regularize (report.detected);
  nameKinds (cloud, shifted, options.of_plan.meter, report.detected);
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  const auto extent_of = [&] (const PlaneSegment& plane) {
    return extentInFile (shifted, plane, options.hull);
  };
  PlanCounts counts;
  counts.wall_planes_found = countOf (PlaneKind::Wall, report.detected);
  counts.has_floor = countOf (PlaneKind::Floor, report.detected) > 0;
  report.dropped = keepChosen (options.choice, extent_of, report.detected);
  if (!task.outputs.plan.empty())
    drawPlan (options, shifted, counts, report);
  report.ids = numbersUpTo (planes.size());
  report.ids_of_whole = numbersUpTo (report.detected.whole_planes.size());
  const Eigen::Vector3d sensor = cloud.origin.head<3>().cast<double>();
  if (give_ids)
    give_ids (sensor.isZero (0.0) ? shifted.shift : sensor, report);
  if (options.hull == "convex")
    report.extents = report.detected.extents;
  else if (!task.outputs.planes.empty() || !task.outputs.mesh.empty() ||
           !task.outputs.view.empty())
    std::transform (
        planes.begin(), planes.end(), std::back_inserter (report.extents), extent_of);
  begin ("writing");
  report.written = saveOutputs (options, task.outputs, cloud, shifted, report);
  return report;
}

} // namespace pcl_ops::apps
