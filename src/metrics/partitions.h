// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <metrics/metrics.h>

namespace pcl_ops::evaluation {

/** Compares two labelings as partitions of the points on true planes, with metrics that
 * plane detectors for images publish (Liu et al., PlaneRCNN, CVPR 2019, section 5.3;
 * Arbelaez et al., PAMI 2011, section 2.3). Points on a true plane but on no found
 * plane are one more part of the result. Without true planes the result is perfect.
 * - variation_of_information: H (T | R) + H (R | T) [bits], 0 at best
 * - rand_index: pairs of points that both join or both separate / pairs
 * - segmentation_covering: mean over points and both directions of the largest
 * intersection over union of the point's part with a part of the other labeling */
NamedValues
partitionMetrics (const Confusion& confusion);

/** Returns the similarity of two labelings of the same points, if neither is the truth.
 * Planes are matched one to one, the largest overlap first; of equal overlaps the one
 * with the lower labels. The similarity is the number of points on both planes of a
 * match / the number of points on a plane in either labeling; 1 without planes.
 * \throw std::invalid_argument if the sizes differ */
double
agreementOf (const PlaneLabels& first, const PlaneLabels& second);

} // namespace pcl_ops::evaluation
