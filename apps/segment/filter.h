// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <detection/methods.h>
#include <pcl_ops/plane_filter.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_ops::apps {

/** \brief Which planes are wanted; those of all options that are given. */
struct PlaneChoice {
  /** \brief An orientation, "largest", or empty for all. */
  std::string only;
  std::optional<Eigen::Vector3f> direction;
  /** \brief Largest angle to \ref direction [degree]. */
  double within = 10.0;
  std::optional<std::size_t> min_points;
  /** \brief Largest planes to keep of those the others leave. */
  std::optional<std::size_t> max_planes;
  std::optional<double> min_area;
  std::optional<double> min_width;
  std::optional<double> max_area;
  std::optional<double> max_width;
};

/** \brief What became of the planes that were not chosen. */
struct Dropped {
  /** \brief Planes there were before. */
  std::size_t found = 0;
  /** \brief How many were dropped by which option, "min-area"; only options that
   * dropped any. */
  std::vector<std::pair<std::string, std::size_t>> by_option;

  /** \brief "1 by --direction, 2 by --min-area"; empty where none was dropped. */
  std::string
  reasons () const;
};

/** \brief Declares the options beside --only. */
void
declareChoice (CommandLine& line, PlaneChoice& choice);

/** \throws UsageError if an option was given without the one it is about, or bounds
 * leave nothing between them */
void
checkChoice (const CommandLine& line, const PlaneChoice& choice);

/** \brief Keeps the chosen planes and forgets the others, whose points then count as on
 * no plane; ids follow the size of those kept. Where none is left, the advice says why.
 * \param[in] extent_of where a plane ends that may be too small */
Dropped
keepChosen (const PlaneChoice& choice,
            const ExtentOfPlane& extent_of,
            Detected& detected);

} // namespace pcl_ops::apps
