// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/las_file.h>
#include <io/shifted_cloud.h>
#include <nlohmann/json.hpp>
#include <page/point_sample.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl_ops::apps {

/** \brief Calls a function with each point of a survey and its label. The points are
 * never all in memory. */
using ForEachLabeledPoint = std::function<void (const VisitLabeledPosition&)>;

/** \brief The planes of a survey with some of their points. */
struct PlaneSample {
  /** \brief The sample as a cloud: plane after plane, then the points on no plane. */
  ShiftedCloud shifted;
  /** \brief The planes in the frame of the survey. Inliers are indices into the cloud.
   * Moments have the centroid and covariance of all points of the plane, but the number
   * of sampled points as their count. */
  std::vector<PlaneSegment> planes;
  /** \brief The points of the cloud in the frame of the survey: a group for each plane,
   * then one for the points on no plane. */
  std::vector<SampledPoints> groups;
};

/** \brief Reads normal, centroid, number of points and orientation of a plane.
 * \return a plane without inliers; the number of points is the count of its moments
 * \param[in] plane as \ref planeObject has written it */
PlaneSegment
segmentIn (const nlohmann::ordered_json& plane);

/** \brief Samples the points of a survey by the planes in a list (\ref PointSample).
 * A point is on the plane whose id is its label; if the list has none, it counts as a
 * point on no plane.
 * \param[in] list as \ref toJson writes it for joined planes: "points" is the number of
 * points of the survey, "planes" an array of \ref planeObject, each with "moments"
 * \param[in] max_points largest number of points of the sample
 * \throws WorkError as \p for_each_point does */
PlaneSample
samplePlanes (const nlohmann::ordered_json& list,
              const ForEachLabeledPoint& for_each_point,
              std::size_t max_points);

} // namespace pcl_ops::apps
