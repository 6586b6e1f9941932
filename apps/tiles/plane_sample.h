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

/** \brief Visits all labelled points of a survey, which are never all in memory. */
using LabelledPoints = std::function<void (const VisitLabelled&)>;

/** \brief Planes with some of their points. */
struct PlaneSample {
  /** \brief The sample as a cloud: plane after plane, then the points on no plane. */
  ShiftedCloud shifted;
  /** \brief In the frame of the survey. Inliers are indices into the sample; moments
   * count the sample's points alone. */
  std::vector<PlaneSegment> planes;
  /** \brief The same points in the frame of the survey, grouped as in the cloud. */
  std::vector<SampledPoints> points;
};

/** \brief Reads normal, centroid, number of points and orientation of a plane in a
 * list. */
PlaneSegment
segmentIn (const nlohmann::ordered_json& plane);

/** \brief Samples the points of the planes in a list (\ref PointSample). Points of
 * planes that are not in the list count as points on no plane.
 * \throws WorkError as \p points does */
PlaneSample
samplePlanes (const nlohmann::ordered_json& list,
              const LabelledPoints& points,
              std::size_t max_points);

} // namespace pcl_ops::apps
