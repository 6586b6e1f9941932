// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "confusion.h"

#include <utility>

namespace pcl_ops::evaluation {

/** \brief Planes as instances, at one overlap threshold. All are fractions; where both
 * sides have no plane the result is perfect, where one has none it has found nothing.
 *
 * Matching and its figures as in the EVOPS benchmark (Kornilova et al. 2022) and in
 * panoptic segmentation (Kirillov et al. 2019); the four kinds of error are those of
 * Hoover et al. 1996. */
struct InstanceMetrics {
  /** \brief Found planes that match a true one / found planes. */
  double precision = 0.0;
  /** \brief True planes that are matched / true planes. */
  double recall = 0.0;
  double f_score = 0.0;
  /** \brief Mean intersection over union of the matched pairs. */
  double mean_iou = 0.0;
  /** \brief mean_iou times f_score. */
  double panoptic_quality = 0.0;
  /** \brief True planes broken up: two or more found planes lie on each, and cover it,
   * by at least the threshold / true planes. */
  double over_segmentation = 0.0;
  /** \brief Found planes that swallow two or more true planes, the same test with the
   * sides exchanged / found planes. */
  double under_segmentation = 0.0;
  /** \brief Found planes that neither match nor have a part in the two above / found.
   */
  double noise = 0.0;
  /** \brief True planes that neither match nor have a part in them / true planes. */
  double missed = 0.0;
};

/** \brief All of them by their published names, in order. */
constexpr std::pair<const char*, double InstanceMetrics::*> instance_metrics[] = {
    {"precision", &InstanceMetrics::precision},
    {"recall", &InstanceMetrics::recall},
    {"f_score", &InstanceMetrics::f_score},
    {"mean_iou", &InstanceMetrics::mean_iou},
    {"panoptic_quality", &InstanceMetrics::panoptic_quality},
    {"over_segmentation", &InstanceMetrics::over_segmentation},
    {"under_segmentation", &InstanceMetrics::under_segmentation},
    {"noise", &InstanceMetrics::noise},
    {"missed", &InstanceMetrics::missed}};

/** \brief Matches planes one to one by falling intersection over union, from \p
 * threshold on (at more than one half no plane has two candidates). */
InstanceMetrics
instanceMetrics (const Confusion& confusion, double threshold);

/** \brief Which true planes that matching finds, by their ids. */
std::vector<bool>
foundTruePlanes (const Confusion& confusion, double threshold);

} // namespace pcl_ops::evaluation
