// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/detection_report.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief Reports the results of stages to an observer: converts values of places to
 * values of points. Does nothing if the observer is empty. */
class StageReports {
public:
  /** \brief Keeps references to both arguments. */
  StageReports (const StageObserver& observer, const Indices& place_of_point)
  : observer_ (observer), place_of_point_ (place_of_point)
  {}

  /** \brief Reports values of places.
   * \param[in] is_flat for each place, reported as label 0 if flat, else no_plane;
   * empty: no labels are reported */
  void operator() (Stage stage,
                   const std::vector<float>& values,
                   const std::vector<char>& is_flat = {}) const;

  /** \brief Reports labels of places.
   * \param[in] is_kept for each label, whether it is reported or replaced by no_plane;
   * empty: all labels are reported */
  void operator() (Stage stage,
                   const Labels& labels,
                   const std::vector<char>& is_kept = {}) const;

private:
  const StageObserver& observer_;
  const Indices& place_of_point_;
};

/** \brief Returns an observer that converts results for \p points to results for the
 * input cloud and passes them to \p observer; empty if \p observer is. It keeps
 * references to \p observer and \p points. */
StageObserver
observerOfPoints (const StageObserver& observer,
                  const Points& points,
                  std::size_t size_of_cloud);

/** \brief Reports the plane of each point of the cloud, as Stage::Labels, if
 * \p observer is not empty. */
void
reportLabels (const StageObserver& observer,
              const std::vector<PlaneSegment>& planes,
              std::size_t size_of_cloud);

} // namespace pcl_ops::internal
