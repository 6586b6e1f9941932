// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "point_sample.h"
#include <io/shifted_cloud.h>
#include <nlohmann/json.hpp>
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_extent.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief What a page shows: a cloud and the planes found in it. */
struct PlanePage {
  std::string title;
  const ShiftedCloud& shifted;
  /** \brief In the frame of the file. */
  const std::vector<PlaneSegment>& planes;
  /** \brief A \ref planeObject for each plane; the "id" decides on the color of the
   * plane.
   */
  nlohmann::ordered_json objects;
  /** \brief Direction against gravity, of any length but 0. */
  Eigen::Vector3f up;
  /** \brief The points to show in place of those of \ref shifted, in the frame of the
   * file: those of each plane, then those on no plane. Only for a survey, which no
   * single sensor has seen; else empty. */
  std::vector<SampledPoints> samples = {};
};

/** \brief Returns \ref PlanePage::objects.
 * \param[in] extents, kinds, ids one for each plane
 * \param[in] up direction against gravity, of any length but 0 */
nlohmann::ordered_json
planeObjects (const std::vector<PlaneSegment>& planes,
              const std::vector<PlaneExtent>& extents,
              const std::vector<PlaneKind>& kinds,
              const std::vector<std::uint32_t>& ids,
              const Eigen::Vector3f& up);

/** \brief Writes a page (\ref savePage). It opens with a view along the direction of
 * \ref chooseView. */
void
savePlanePage (const std::string& file, const PlanePage& page);

} // namespace pcl_ops::apps
