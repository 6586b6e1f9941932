// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_extent.h>
#include <pcl_ops/plane_kinds.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief What a page shows: a cloud and the planes found in it. */
struct PlanePage {
  std::string title;
  const ShiftedCloud& shifted;
  /** \brief In the file's frame, each with its extent, its kind and its id, which it
   * has its color by. */
  const std::vector<PlaneSegment>& planes;
  const std::vector<PlaneExtent>& extents;
  const std::vector<PlaneKind>& kinds;
  const std::vector<std::uint32_t>& ids;
  Eigen::Vector3f up;
};

/** \brief Writes a page (\ref savePage) that begins with the view of \ref chooseView.
 */
void
savePlanePage (const std::string& file, const PlanePage& page);

} // namespace pcl_ops::apps
