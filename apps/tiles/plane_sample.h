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
  /** \brief The sample as a cloud: plane after plane, then what is on none. */
  ShiftedCloud shifted;
  /** \brief In the frame of the survey; moments are as of the sample alone. */
  std::vector<PlaneSegment> planes;
  /** \brief The same points, of each plane, then of none. */
  std::vector<SampledPoints> points;
};

/** \brief A plane of a list, as far as it can be chosen by. */
PlaneSegment
segmentIn (const nlohmann::ordered_json& plane);

/** \brief Keeps points of the planes in a list (\ref PointSample); those of planes that
 * are not in it are on none.
 * \throws WorkError as \p points does */
PlaneSample
samplePlanes (const nlohmann::ordered_json& list,
              const LabelledPoints& points,
              std::size_t max_points);

} // namespace pcl_ops::apps
