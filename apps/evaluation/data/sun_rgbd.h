// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "data_sets.h"

namespace pcl_ops::evaluation {

/** \brief All frames of SUN RGB-D (Song, Lichtenberg & Xiao, CVPR 2015) below a folder,
 * by name. A frame is a folder with the PNG file of its depth, intrinsics.txt (3 x 3)
 * and a folder extrinsics whose last file by name counts (3 x 4). Its origin is at the
 * camera, x to the right and z against gravity [m]. Pixels without a reading give no
 * point; as in the data set's toolbox, depths beyond 8 m are set to 8 m. Loading throws
 * apps::WorkError that names the missing, damaged or malformed file.
 * \param[in] is_raw depth as measured (folder "depth"); else refined, with holes filled
 * ("depth_bfx"): the toolbox's default
 * \throw apps::WorkError if there is none */
DataSet
sunRgbdDataSet (const std::string& folder, bool is_raw);

} // namespace pcl_ops::evaluation
