// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_ops {

/** \brief The direction against gravity, estimated from the planes of a room. */
struct UpAxis {
  /** \brief Unit vector in the frame of the planes. */
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  /** \brief Estimated probability, 0 to 1, that the direction is correct. */
  double confidence = 0.0;
};

/** \brief Parameters of \ref estimateUpAxis. */
struct UpAxisParameters {
  /** \brief Largest deviation from horizontal or vertical at which a plane supports a
   * direction [rad]; by default 7 degrees. */
  double angle_tolerance = paper_angle_tolerance;
  /** \brief Smallest share of horizontal planes, and of vertical planes, that a
   * candidate direction needs. The weight of a plane is the root of its number of
   * points. */
  double min_share = 0.02;
  /** \brief Smallest confidence of a result. 0: if any directions pass min_share, the
   * likeliest one is returned. */
  double min_confidence = 0.7;
};

/** \brief Returns the first problem of the parameters; empty if they are valid. */
PCL_OPS_EXPORT std::string
validate (const UpAxisParameters& parameters);

/** \brief Estimates the up axis of a room from its planes.
 *
 * Candidates are the normals of the larger planes and the cross products of two of
 * them. Each candidate is refined to fit the planes within the tolerance best. Five
 * properties tell which candidate is up: many planes face up, as floor, seats and table
 * tops do; some planes are vertical; the sensor looks ahead rather than along the axis;
 * rooms are wider than high; and most points are in the lower half of the heights. A
 * logistic model of these properties, fitted to simulated rooms, gives each direction a
 * probability, in any unit and frame.
 *
 * It expects a room or a corridor, and a sensor with a known origin that looks level or
 * somewhat down. If a scan in all directions sees floor and ceiling, there is no
 * result, unless min_confidence is 0.
 * \param[in] planes with normals towards the sensor, as PlaneDetector::segment returns
 * them; non-finite planes are skipped
 * \param[in] viewpoint origin of the sensor, in the frame of the planes
 * \param[in] parameters of the estimation
 * \return nothing if the planes cannot tell, the viewpoint is not finite, or the
 * parameters are not valid */
PCL_OPS_EXPORT std::optional<UpAxis>
estimateUpAxis (const std::vector<PlaneSegment>& planes,
                const Eigen::Vector3d& viewpoint,
                const UpAxisParameters& parameters = UpAxisParameters());

} // namespace pcl_ops
