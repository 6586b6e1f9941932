// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <metrics/metrics.h>

namespace pcl_ops::evaluation {

/** Compares two labelings as partitions of the points on true planes, with metrics that
 * plane detectors for images publish (Liu et al., PlaneRCNN, CVPR 2019, section 5.3;
 * Arbelaez et al., PAMI 2011, section 2.3). Points on a true plane but on no found
 * plane are one more part of the result. Without true planes the result is perfect.
 * - variation_of_information: H (T | R) + H (R | T) [bits] with the conditional
 * entropies of truth T and result R; 0 at best
 * - rand_index: share of the pairs of points that are in one part in both labelings, or
 * in two parts in both; 1 at best
 * - segmentation_covering: mean over points and over both labelings of the largest
 * intersection over union of the point's part with a part of the other labeling; 1 at
 * best */
NamedValues
partitionMetrics (const Confusion& confusion);

/** Returns the similarity of two labelings of the same points, neither of which has to
 * be the truth. Planes are matched one to one, the largest overlap first; of equal
 * overlaps the one with the lower labels. The similarity is the number of points on
 * both planes of a match / the number of points on a plane in either labeling; 1
 * without planes.
 * \throw std::invalid_argument if the sizes differ */
double
agreementOf (const PlaneLabels& first, const PlaneLabels& second);

} // namespace pcl_ops::evaluation
