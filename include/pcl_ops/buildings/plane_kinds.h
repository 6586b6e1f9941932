// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_extent.h>

#include <optional>
#include <vector>

namespace pcl_ops {

/** \brief The kind of a plane in or around a building. */
enum class PlaneKind {
  /** \brief The lowest large level surface of a story; outdoors the ground. */
  Floor,
  /** \brief A level surface above a story, seen from below. */
  Ceiling,
  Wall,
  /** \brief Any other large level surface: a platform, a landing. */
  Slab,
  /** \brief A sloping or level surface above head height, with no walls on it. */
  Roof,
  /** \brief A sloping surface that begins at a floor. */
  Ramp,
  /** \brief A level surface at the height of seats, tables, beds and counters. */
  Table,
  Other
};

/** \brief Returns "floor", "ceiling", "wall", "slab", "roof", "ramp", "table" or
 * "other". */
PCL_OPS_EXPORT const char*
toString (PlaneKind kind);

/** \brief Classifies planes by rules on their height, size, slope and neighbors (the
 * table in src/doc/buildings.md).
 *
 * Large level surfaces make stories: the lowest is a floor, the next one above head
 * height is the ceiling, and one just above a ceiling is the floor of the next story.
 * All other planes are classified by their position in their story. A plane whose
 * normal points down counts as seen from below. A plane whose normal points up may be
 * seen from above or, if the sensor position is not known, from either side. If the
 * viewpoint is given, planes below it are no ceilings, and the sensor may lean: if the
 * ground below it slopes by 3 to 12 degrees, and hardly any plane is more level, the
 * normal of the ground replaces \p up.
 * \param[in] planes all planes of a cloud, with orientations and with normals towards
 * the sensor
 * \param[in] extents the extent of each plane, from \ref planeExtent
 * \param[in] up direction against gravity, of any length but 0
 * \param[in] meter the length of a meter in the unit of the planes
 * \param[in] viewpoint position of the sensor, in the frame of the planes; not given if
 * it is not known or if there were several. It is ignored if it is farther away than
 * 500 times the size of the scene
 * \return the kind of each plane
 * \throw std::invalid_argument if the numbers of extents and planes differ, if \p up is
 * zero or not finite, if \p meter is not above 0 and finite, or if a plane, its extent
 * in meters or the viewpoint is not finite */
PCL_OPS_EXPORT std::vector<PlaneKind>
planeKinds (const std::vector<PlaneSegment>& planes,
            const std::vector<PlaneExtent>& extents,
            const Eigen::Vector3d& up,
            double meter = 1.0,
            const std::optional<Eigen::Vector3d>& viewpoint = {});

} // namespace pcl_ops
