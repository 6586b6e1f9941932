// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/detection_report.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief Tells an observer what stages made of places, as of points. Without an
 * observer it does nothing. */
class StageReports {
public:
  /** \param[in] place_of_point both have to outlive this */
  StageReports (const StageObserver& observer, const Indices& place_of_point)
  : observer_ (observer), place_of_point_ (place_of_point)
  {}

  /** \param[in] is_flat of each place; none: the stage has no labels */
  void operator() (Stage stage,
                   const std::vector<float>& values,
                   const std::vector<char>& is_flat = {}) const;

  /** \param[in] is_kept of each label; none: all are */
  void operator() (Stage stage,
                   const Labels& labels,
                   const std::vector<char>& is_kept = {}) const;

private:
  const StageObserver& observer_;
  const Indices& place_of_point_;
};

/** \brief Takes results of points and hands them on as those of their cloud; empty as
 * the observer is.
 * \param[in] observer it and the points have to outlive this */
StageObserver
observerOfPoints (const StageObserver& observer,
                  const Points& points,
                  std::size_t size_of_cloud);

/** \brief Tells an observer, if there is one, which plane each point of a cloud is on.
 */
void
reportLabels (const StageObserver& observer,
              const std::vector<PlaneSegment>& planes,
              std::size_t size_of_cloud);

} // namespace pcl_ops::internal
