// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "up_search.h"

#include "number_options.h"
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/up_axis.h>
#include <pcl_ops/visibility.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace pcl_ops::apps {

namespace {

/** \brief The axis, or why there is none. */
struct UpSearch {
  std::optional<UpAxis> found;
  std::string problem;
};

UpSearch
findUp (const DetectorOptions& options, const XyzCloud::ConstPtr& cloud)
{
  if (!isSeenFromItsOrigin (*cloud))
    return {std::nullopt, "the cloud was not seen from its VIEWPOINT"};
  OrientedPointSamplingParameters given;
  apply (options.numbers, given);
  OrientedPointSampling<pcl::PointXYZ> ops;
  ops.setSeed (given.seed);
  ops.setNumberOfThreads (given.threads);
  ops.setInputCloud (cloud);
  std::vector<PlaneSegment> planes;
  ops.segment (planes);
  return {estimateUpAxis (planes, cloud->sensor_origin_.head<3>().cast<double>()),
          "the planes cannot tell"};
}

std::string
textOf (const Eigen::Vector3f& vector)
{
  const Eigen::IOFormat with_commas (4, Eigen::DontAlignCols, ",", ",");
  std::ostringstream text;
  text << vector.transpose().format (with_commas);
  return text.str();
}

std::string
noteOn (const UpSearch& search, const Eigen::Vector3f& used)
{
  std::ostringstream note;
  if (search.found)
    note << "Up axis: " << textOf (used) << ", confidence " << std::fixed
         << std::setprecision (2) << search.found->confidence;
  else
    note << "Up axis: " << search.problem << ", " << textOf (used)
         << " is used; give --up x,y,z";
  return note.str();
}

std::string
roundedTextOf (const Eigen::Vector3d& vector)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision (2);
  for (const double number : {vector.x(), vector.y(), vector.z()}) {
    constexpr double hundred = 100.0;
    // The sum turns -0 into 0.
    text << (text.tellp() > 0 ? ", " : "")
         << std::round (hundred * number) / hundred + 0.0;
  }
  return text.str();
}

/** \brief Names another axis than the one used where the planes are sure of it. Costs
 * no second search: the planes have to be those of the default preset. */
void
hintOnUp (const DetectorOptions& options, const XyzCloud& cloud, Detected& detected)
{
  OrientedPointSamplingParameters given;
  apply (options.numbers, given);
  const auto found =
      estimateUpAxis (detected.planes, cloud.sensor_origin_.head<3>().cast<double>());
  if (!found)
    return;
  // Planes have the same names upside down.
  const double cosine =
      std::abs (found->direction.dot (detected.up.cast<double>().normalized()));
  if (cosine >= std::cos (given.angle_tolerance) || !isSeenFromItsOrigin (cloud))
    return;
  detected.suggested_up = found->direction;
  detected.hints.push_back ("planes suggest that up is " +
                            roundedTextOf (found->direction) + ": --up auto");
}

/** \brief Whether estimates are as sure of the planes as they say. */
bool
findsPlanesByDefault (const Method& method, const DetectorOptions& options)
{
  return method.name == allMethods().front().name && options.preset == "default";
}

} // namespace

Detected
runMethod (const Method& method,
           const DetectorOptions& options,
           const XyzCloud::ConstPtr& cloud)
{
  if (!options.finds_up) {
    Detected detected = method.detect (options, cloud);
    if (!options.up && findsPlanesByDefault (method, options))
      hintOnUp (options, *cloud, detected);
    return detected;
  }
  const UpSearch search = findUp (options, cloud);
  const std::optional<UpAxis>& found = search.found;
  DetectorOptions known = options;
  if (found)
    known.up = found->direction.cast<float>();
  Detected detected = method.detect (known, cloud);
  detected.up_note = noteOn (search, detected.up);
  detected.settings["up_confidence"] =
      found ? Settings (found->confidence) : Settings();
  return detected;
}

} // namespace pcl_ops::apps
