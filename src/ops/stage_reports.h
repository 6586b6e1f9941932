// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/detection_report.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief Reports the results of stages to an observer: converts the values of places
 * (distinct points) to values of points. Does nothing if the observer is empty. */
class StageReports {
public:
  /** \brief Keeps references to both arguments.
   * \param[in] place_of_point for each point the index of its place */
  StageReports (const StageObserver& observer, const Indices& place_of_point)
  : observer_ (observer), place_of_point_ (place_of_point)
  {}

  /** \brief Reports values of places.
   * \param[in] is_flat for each place, whether its support is flat: reported as label 0
   * if so, else as no_plane. If the list is empty, no labels are reported */
  void operator() (Stage stage,
                   const std::vector<float>& values,
                   const std::vector<char>& is_flat = {}) const;

  /** \brief Reports labels of places.
   * \param[in] is_kept for each label, whether it is reported; if not, no_plane is
   * reported instead. If the list is empty, all labels are reported */
  void operator() (Stage stage,
                   const Labels& labels,
                   const std::vector<char>& is_kept = {}) const;

private:
  const StageObserver& observer_;
  const Indices& place_of_point_;
};

/** \brief Returns an observer of results that have a value for each of \p points. It
 * converts them to results for all points of the input cloud, and passes these to \p
 * observer. The returned observer is empty if \p observer is, and keeps references to
 * \p observer and \p points.
 * \param[in] size_of_cloud number of points of the input cloud */
StageObserver
observerOfPoints (const StageObserver& observer,
                  const Points& points,
                  std::size_t size_of_cloud);

/** \brief Reports Stage::Labels to \p observer, unless that is empty: for each point
 * of the cloud the index of its plane in \p planes, or no_plane. */
void
reportLabels (const StageObserver& observer,
              const std::vector<PlaneSegment>& planes,
              std::size_t size_of_cloud);

} // namespace pcl_ops::internal
