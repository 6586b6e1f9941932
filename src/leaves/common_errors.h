// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/expected_noise.h"
#include "leaves/leaf_division.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief The share of the points in leaves where neighboring points err alike, as in
 * the images of depth cameras: where smoothed depth makes a surface uneven, or where
 * quantized depth puts all points of a leaf on one step.
 *
 * A surface that is more uneven the larger one looks at it bends, like hills and the
 * meshes of fused depth: that is no error (\ref ExpectedNoise::isNoise).
 * \param[in] cells of the points
 * \param[in] leaves of the points, in their order
 * \return from 0 to 1; 0 for no leaves */
double
shareOfCommonErrors (const CurvePoints& points,
                     const std::vector<CellScatter>& cells,
                     const ExpectedNoise& expected,
                     const std::vector<Leaf>& leaves);

} // namespace pcl_ops::internal
