// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"
#include "report.h"
#include <common/cloud_file.h>
#include <common/output_file.h>
#include <common/program.h>
#include <detection/up_search.h>
#include <picture/colors.h>
#include <picture/picture.h>

#include <cstdint>
#include <iostream>
#include <vector>

namespace pcl_ops::apps {

namespace {

Detected
detectPlanes (const SegmentOptions& options, const Positions& positions)
{
  Detected detected =
      runMethod (methodCalled (options.method), options.detector, positions.cloud);
  for (PlaneSegment& plane : detected.planes)
    plane.centroid += positions.shift;
  return detected;
}

/** \brief For each point the id of its plane, 0 for none. */
std::vector<std::uint32_t>
labelsOf (const std::vector<PlaneSegment>& planes, std::size_t points)
{
  std::vector<std::uint32_t> labels (points, 0);
  std::uint32_t id = 0;
  for (const PlaneSegment& plane : planes) {
    ++id;
    for (const pcl::index_t index : plane.inliers)
      labels[static_cast<std::size_t> (index)] = id;
  }
  return labels;
}

void
saveLabelled (const std::string& file,
              Cloud cloud,
              const std::vector<std::uint32_t>& labels,
              bool keeps_color)
{
  setLabels (cloud, labels);
  if (!keeps_color || !(hasField (cloud, "rgb") || hasField (cloud, "rgba"))) {
    std::vector<pcl::RGB> colors;
    colors.reserve (labels.size());
    for (const std::uint32_t label : labels)
      colors.push_back (colorOfLabel (label));
    setColors (cloud, colors);
  }
  savePcd (file, cloud);
}

void
saveOutputs (const SegmentOptions& options,
             const Cloud& cloud,
             const Positions& positions,
             const Report& report)
{
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  const std::vector<std::uint32_t> labels = labelsOf (planes, cloud.size());
  if (!options.output.empty())
    saveLabelled (options.output, cloud, labels, options.keep_color);
  if (!options.planes.empty())
    writeTextFile (options.planes,
                   extensionOf (options.planes) == ".csv" ? toCsv (report)
                                                          : toJson (report));
  if (!options.image.empty())
    savePicture (options.image, *positions.cloud, labels, planes, report.detected.up);
}

int
segment (int argc, const char* const* argv)
{
  SegmentOptions options;
  if (!readOptions (argc, argv, options))
    return kDone;
  const Cloud cloud = loadCloud (options.input);
  const Positions positions = positionsOf (cloud);
  const Report report{
      options.input, options.method, cloud.size(), detectPlanes (options, positions)};
  saveOutputs (options, cloud, positions, report);
  if (!options.quiet) {
    printTable (report, std::cout);
    if (!options.image.empty())
      std::cout << options.image << ": left each plane in its colour; right horizontal "
                << "green, vertical blue, other orange; no plane grey\n";
  }
  return kDone;
}

} // namespace

} // namespace pcl_ops::apps

int
main (int argc, char** argv)
{
  using namespace pcl_ops::apps;
  return runProgram ("pcl_ops_segment", [&] { return segment (argc, argv); });
}
