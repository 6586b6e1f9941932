// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"
#include <cli/errors.h>
#include <cli/program.h>
#include <io/las_file.h>
#include <io/shifted_cloud.h>

#include <algorithm>
#include <iterator>
#include <numeric>

#if PCL_OPS_WITH_SURFACE
#include <pcl_ops/surface/concave_hull.h>
#endif

namespace pcl_ops::apps {

namespace {

Detected
detectPlanes (const SegmentOptions& options,
              const ShiftedCloud& shifted,
              bool is_survey)
{
  Detected detected =
      runMethod (methodCalled (options.method), options.detector, shifted.cloud);
  for (PlaneSegment& plane : detected.planes)
    plane.moveBy (shifted.shift);
  if (is_survey)
    turnUp (detected.planes, detected.up.cast<double>());
  return detected;
}

std::string
nameOfInput (const Task& task)
{
  return task.input == standard_stream ? standard_input : task.input;
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

Report
segmentInMemory (const SegmentOptions& options,
                 const Task& task,
                 const IdsOfPlanes& ids_of,
                 const StageListener& begin_stage)
{
  const std::string name = nameOfInput (task);
  const auto begin = [&] (const std::string& stage) {
    stopIfInterrupted();
    if (begin_stage)
      begin_stage (name + ": " + stage);
  };
  begin ("reading");
  const bool is_piped = task.input == standard_stream;
  const FileCloud cloud = is_piped ? loadStandardInput() : loadCloud (task.input);
  checkTakesLabels (options, task, cloud);
  begin ("finding planes in " + std::to_string (cloud.size()) + " points");
  const ShiftedCloud shifted = shiftedCloudOf (cloud, voxelStepOf (options.detector));
  Report report;
  report.input = name;
  report.method = options.method;
  report.points = cloud.size();
  report.damage = damageOf (shifted);
  report.detected = detectPlanes (options, shifted, cloud.is_survey);
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  const auto extent_of = [&] (const PlaneSegment& plane) {
    return extentInFile (shifted, plane, options.hull);
  };
  report.dropped = keepChosen (options.choice, extent_of, report.detected);
  report.ids.resize (planes.size());
  std::iota (report.ids.begin(), report.ids.end(), 1U);
  const Eigen::Vector3d sensor = cloud.origin.head<3>().cast<double>();
  if (ids_of)
    report.ids = ids_of (planes, sensor.isZero (0.0) ? shifted.shift : sensor);
  if (!task.outputs.planes.empty() || !task.outputs.mesh.empty())
    std::transform (
        planes.begin(), planes.end(), std::back_inserter (report.extents), extent_of);
  begin ("writing");
  saveOutputs (options, task.outputs, cloud, shifted, report);
  return report;
}

} // namespace

Report
segmentCloud (const SegmentOptions& options,
              const Task& task,
              const IdsOfPlanes& ids_of,
              const StageListener& begin_stage)
{
  return inMemory (
      nameOfInput (task),
      options.jobs == 1 ? "give a smaller cloud" : "give fewer --jobs",
      [&] { return segmentInMemory (options, task, ids_of, begin_stage); });
}

} // namespace pcl_ops::apps
