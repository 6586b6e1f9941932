// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/detection_report.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief Tells an observer the results of stages. Stages have them by place, the
 * observer gets them by point. Without an observer it does nothing. */
class StageReports {
public:
  /** \brief Keeps references to both. */
  StageReports (const StageObserver& observer, const Indices& place_of_point)
  : observer_ (observer), place_of_point_ (place_of_point)
  {}

  /** \brief Reports values of places.
   * \param[in] is_flat of each place, reported as labels; none: the stage has no labels */
  void operator() (Stage stage,
                   const std::vector<float>& values,
                   const std::vector<char>& is_flat = {}) const;

  /** \brief Reports labels of places.
   * \param[in] is_kept of each label, whether it is reported; none: all are */
  void operator() (Stage stage,
                   const Labels& labels,
                   const std::vector<char>& is_kept = {}) const;

private:
  const StageObserver& observer_;
  const Indices& place_of_point_;
};

/** \brief An observer that takes results by point of \p points and hands them on by
 * point of the input cloud; empty if the other observer is. Keeps references to both.
 */
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
