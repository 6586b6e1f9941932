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

/** \brief What a plane is in a building, or outside of one. */
enum class PlaneKind {
  /** \brief The lowest large level surface of a story; outdoors the ground. */
  Floor,
  /** \brief What is above a story, seen from below. */
  Ceiling,
  Wall,
  /** \brief A large level surface that is none of the others: a platform, a landing. */
  Slab,
  /** \brief Sloping or level, with nothing standing on it, above head height. */
  Roof,
  /** \brief A sloping surface that begins at a floor. */
  Ramp,
  /** \brief A level surface at the height of seats, tables, beds and counters. */
  Table,
  Other
};

/** \brief "floor", "ceiling", "wall", "slab", "roof", "ramp", "table" or "other". */
PCL_OPS_EXPORT const char*
toString (PlaneKind kind);

/** \brief What planes are, by rules on height, size, slope and what is around them (the
 * table in src/doc/buildings.md).
 *
 * Level surfaces large enough make stories: the lowest is a floor, the next above head
 * height the ceiling, one just above a ceiling the floor of the next story. Everything
 * else is named by its place in its story. A plane whose normal points down is taken as
 * seen from below; one whose normal points up may be seen from above or, in clouds of
 * no known sensor, from anywhere. Where the viewpoint is given, what lies below it is
 * no ceiling, and the sensor may lean: where its ground is level but for 12 degrees,
 * and hardly anything else is more level, the ground tells which way is up.
 * \param[in] planes all of a cloud, with their orientations and their normals towards
 * the sensor
 * \param[in] extents where each ends, as \ref planeExtent says
 * \param[in] up against gravity, any length but 0
 * \param[in] meter the length of a meter in the unit of the planes
 * \param[in] viewpoint where the sensor was, in the frame of the planes; nothing where
 * it is not known, or where there were several; one that is 500 times as far away as
 * the planes reach says nothing, either
 * \return one for each plane
 * \throw std::invalid_argument if there is not one extent for each plane, up or meter are
 * no direction and no length, or a plane, its extent in meters or the viewpoint is not
 * finite */
PCL_OPS_EXPORT std::vector<PlaneKind>
planeKinds (const std::vector<PlaneSegment>& planes,
            const std::vector<PlaneExtent>& extents,
            const Eigen::Vector3d& up,
            double meter = 1.0,
            const std::optional<Eigen::Vector3d>& viewpoint = {});

} // namespace pcl_ops
