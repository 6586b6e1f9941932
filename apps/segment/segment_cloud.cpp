// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_cloud.h"

#include "outputs.h"
#include <cli/errors.h>
#include <cli/interruption.h>
#include <detection/methods.h>
#include <detection/plane_json.h>
#include <detection/plane_map.h>
#include <io/cloud_file.h>
#include <io/las_file.h>
#include <io/laz_file.h>
#include <io/output_file.h>
#include <io/shifted_cloud.h>
#include <picture/colors.h>
#include <picture/picture.h>

#include <cstdint>
#include <iostream>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#ifdef PCL_OPS_WITH_SURFACE
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
  const std::string problem = cloud.las->problemOf (fields);
  if (!problem.empty())
    throw WorkError (nameOfInput (task), problem);
}

/** \brief For each point of a cloud its signed distance to its plane, positive where
 * the normal points to [m]; NaN on no plane. \param[in] planes in the file's frame */
std::vector<float>
distancesOf (const FileCloud& cloud, const std::vector<PlaneSegment>& planes)
{
  const CoordinateReader place (cloud);
  std::vector<float> distances (cloud.size(), std::numeric_limits<float>::quiet_NaN());
  for (const PlaneSegment& plane : planes)
    for (const pcl::index_t inlier : plane.inliers) {
      const auto i = static_cast<std::size_t> (inlier);
      // From the centroid: an equation's offset has few digits left far from zero.
      distances[i] = static_cast<float> (plane.normal.dot (place (i) - plane.centroid));
    }
  return distances;
}

void
saveLabelled (const std::string& file,
              const FileCloud& cloud,
              const std::vector<PlaneSegment>& planes,
              const std::vector<std::uint32_t>& labels,
              const SegmentOptions& options)
{
  const std::vector<float> distances =
      options.distances ? distancesOf (cloud, planes) : std::vector<float>();
  if (isLasName (file))
    return saveLabelledLas (file, *cloud.las, labels, distances);
  saveLabelledCloud (file, cloud, labels, distances, options.keep_color);
}

Eigen::Isometry3d
poseOf (const FileCloud& cloud)
{
  return Eigen::Translation3d (cloud.origin.head<3>().cast<double>()) *
         cloud.orientation.cast<double>();
}

void
savePlanes (const std::string& file, const Report& report, const MapOptions& map)
{
  const std::string text = planesFor (file, toJson (report), map);
  if (file == standard_stream)
    std::cout << text;
  else
    writeTextFile (file, text);
}

void
saveOutputs (const SegmentOptions& options,
             const Outputs& outputs,
             const FileCloud& cloud,
             const ShiftedCloud& shifted,
             const Report& report)
{
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  const std::vector<std::uint32_t> labels = labelsOf (planes, cloud.size(), report.ids);
  if (!outputs.cloud.empty())
    saveLabelled (outputs.cloud, cloud, planes, labels, options);
  if (!outputs.image.empty())
    savePicture (outputs.image,
                 *shifted.cloud,
                 labelsOf (planes, cloud.size()),
                 planes,
                 report.detected.up,
                 report.ids);
  if (!outputs.mesh.empty())
    saveMesh (outputs.mesh,
              poseOf (cloud),
              planes,
              report.ids,
              report.extents,
              shifted.shift.isZero (0.0) ? Precision::Single : Precision::Double);
  if (!outputs.edges.empty())
    saveEdges (outputs.edges,
               poseOf (cloud),
               findPlaneEdges (*shifted.cloud, planes, {}, shifted.shift),
               report.ids);
  if (!outputs.rest.empty())
    saveRest (outputs.rest, cloud, shifted, labels);
  if (!outputs.planes_dir.empty())
    savePlaneClouds (
        outputs.planes_dir, cloud, planes, report.ids, options.fileFormat());
  // Last: a pipe gets its JSON when the files are there.
  if (!outputs.planes.empty())
    savePlanes (outputs.planes, report, options.map);
}

/** \brief Where a plane ends, in the file's frame; parameters as below. */
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

/** \brief Where each plane ends, in the file's frame.
 * \param[in] shifted the cloud the planes were found in
 * \param[in] planes in the file's frame
 * \param[in] hull one of \ref hulls that the build has */
std::vector<PlaneExtent>
extentsOf (const ShiftedCloud& shifted,
           const std::vector<PlaneSegment>& planes,
           const std::string& hull)
{
  std::vector<PlaneExtent> extents;
  extents.reserve (planes.size());
  for (const PlaneSegment& plane : planes)
    extents.push_back (extentInFile (shifted, plane, hull));
  return extents;
}

Report
segmentInMemory (const SegmentOptions& options,
                 const Task& task,
                 const IdsOfPlanes& ids_of,
                 const StageListener& begin_stage)
{
  const std::string name = nameOfInput (task);
  begin_stage (name + ": reading");
  const bool is_piped = task.input == standard_stream;
  const FileCloud cloud = is_piped ? loadStandardInput() : loadCloud (task.input);
  checkTakesLabels (options, task, cloud);
  stopIfInterrupted();
  begin_stage (name + ": finding planes in " + std::to_string (cloud.size()) +
               " points");
  const ShiftedCloud shifted = shiftedCloudOf (cloud, voxelStepOf (options.detector));
  Report report{name,
                options.method,
                cloud.size(),
                detectPlanes (options, shifted, cloud.is_survey),
                {},
                {},
                damageOf (shifted),
                {}};
  report.dropped = keepChosen (
      options.choice,
      [&] (const PlaneSegment& plane) {
        return extentInFile (shifted, plane, options.hull);
      },
      report.detected);
  const Eigen::Vector3d sensor = cloud.origin.head<3>().cast<double>();
  report.ids =
      ids_of (report.detected.planes, sensor.isZero (0.0) ? shifted.shift : sensor);
  if (!task.outputs.planes.empty() || !task.outputs.mesh.empty())
    report.extents = extentsOf (shifted, report.detected.planes, options.hull);
  stopIfInterrupted();
  begin_stage (name + ": writing");
  saveOutputs (options, task.outputs, cloud, shifted, report);
  return report;
}

} // namespace

const std::vector<std::string> hulls = {"convex", "concave"};

namespace {

PlanarRings
outlineOf (const PlanarPoints& points, [[maybe_unused]] const std::string& hull)
{
#ifdef PCL_OPS_WITH_SURFACE
  if (hull == "concave")
    return concaveOutline (points);
#endif
  return {convexHull (points)};
}

} // namespace

bool
hasHull ([[maybe_unused]] const std::string& hull)
{
#ifdef PCL_OPS_WITH_SURFACE
  return true;
#else
  return hull == "convex";
#endif
}

std::vector<std::uint32_t>
idsBySize (const std::vector<PlaneSegment>& planes, const Eigen::Vector3d& /*sensor*/)
{
  std::vector<std::uint32_t> ids (planes.size());
  std::iota (ids.begin(), ids.end(), 1U);
  return ids;
}

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
