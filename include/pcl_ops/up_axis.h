// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_ops {

/** \brief The direction against gravity, as the planes of a room tell it. */
struct UpAxis {
  /** \brief Unit vector in the frame of the planes. */
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  /** \brief How sure that is, 0 to 1: the share of right answers to expect among rooms
   * that look like this one. */
  double confidence = 0.0;
};

struct UpAxisParameters {
  /** \brief Largest angle of a plane to the direction it speaks for [rad]; default 7
   * degrees. */
  double angle_tolerance = paper_angle_tolerance;
  /** \brief Share of the planes that must be horizontal, and share that must be
   * vertical, for a direction to be looked at; planes count by the root of their
   * points.
   */
  double min_share = 0.02;
  /** \brief Below this confidence there is no answer; 0: the likeliest one, if any
   * direction has the shares. */
  double min_confidence = 0.7;
};

/** \brief What is wrong with these parameters, as a sentence; empty if nothing is. */
PCL_OPS_EXPORT std::string
validate (const UpAxisParameters& parameters);

/** \brief Which way is up in a room, by its planes alone.
 *
 * Directions that floor and walls can agree on are the normals of the larger planes and
 * the cross products of two of them, each turned to where the planes within the
 * tolerance fit best. What tells which of them is up: much faces up, as floor, seats
 * and table tops do; some planes are vertical; the sensor looks ahead rather than along
 * the axis; rooms are wider than high; and most things are below the middle of the
 * heights. A logistic model of these five, fitted to simulated rooms, gives each
 * direction its probability, in any unit and frame.
 *
 * It counts on a room or a corridor, and on a sensor whose origin is known and that
 * looks level or somewhat down. A scan all around must not see floor and ceiling: it
 * has no answer then.
 * \param[in] planes as PlaneDetector::segment gives them: normals towards the sensor
 * \param[in] viewpoint origin of the sensor, in the frame of the planes
 * \param[in] parameters tolerance, and how sure an answer has to be
 * \return nothing where the planes cannot tell, or an argument is not finite or out of
 * its range */
PCL_OPS_EXPORT std::optional<UpAxis>
estimateUpAxis (const std::vector<PlaneSegment>& planes,
                const Eigen::Vector3d& viewpoint,
                const UpAxisParameters& parameters = UpAxisParameters());

} // namespace pcl_ops
