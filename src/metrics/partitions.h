// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <metrics/metrics.h>

namespace pcl_ops::evaluation {

/** Two labelings as partitions of the points on true planes, as plane detectors for
 * images publish them (Liu et al., PlaneRCNN, CVPR 2019, section 5.3; Arbelaez et al.,
 * PAMI 2011, section 2.3). Points on a true plane that the result has on none are one
 * more part of the result. Where there is no true plane the result is perfect.
 * - variation_of_information: H (T | R) + H (R | T) [bits], 0 at best
 * - rand_index: pairs of points that both have together or both apart / pairs
 * - segmentation_covering: the mean over points of the largest intersection over union
 * of their part with one of the other side, and the mean of both directions */
NamedValues
partitionMetrics (const Confusion& confusion);

/** How alike two labelings of the same points are, neither of which is a truth: points
 * on planes that are matched one to one, the largest overlap first, and on both of a
 * match / points on a plane in either; 1 where there are none. Of equal overlaps the
 * one of the lower labels is first.
 * \throw std::invalid_argument if the sizes differ */
double
agreementOf (const PlaneLabels& first, const PlaneLabels& second);

} // namespace pcl_ops::evaluation
