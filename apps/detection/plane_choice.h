// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"
#include <pcl_ops/plane_filter.h>

namespace pcl_ops::apps {

struct PlaneChoice {
  /** \brief Orientations, kinds, "largest", with commas between; empty for all. */
  std::string only;
  /** \brief Largest angle to the direction of the filter [degree]. */
  double within = 10.0;
  /** \brief Smallest and largest angle to the horizontal [degree]. */
  std::optional<std::array<double, 2>> slope;
  PlaneFilter filter;
  /** \brief For reports. */
  Settings given = Settings::object();

  /** \brief Whether \ref only has a kind, as "wall", and not only how planes lie. */
  bool
  namesKinds () const;
};

struct Dropped {
  std::size_t found = 0;
  /** \brief By which option, "min-area", how many were dropped, if any. */
  std::vector<std::pair<std::string, std::size_t>> by_option;

  /** \brief "1 by --direction, 2 by --min-area"; empty where none was dropped. */
  std::string
  reasons () const;
};

inline constexpr const char* title_of_choice = "Planes to keep";

void
declareChoice (CommandLine& line, PlaneChoice& choice);

/** \throws UsageError if an option was given without the one it is about, or bounds
 * leave nothing between them */
void
finishChoice (const CommandLine& line, PlaneChoice& choice);

/** \brief The positions of the chosen planes.
 * \param[in] kinds one for each plane, or none, which no kind in \p choice is of
 * \param[in] up against gravity, in the frame of the planes
 * \param[in] extent_of asked for planes that may be too small or too large */
std::vector<std::size_t>
chosenOf (const PlaneChoice& choice,
          const std::vector<PlaneSegment>& planes,
          const std::vector<PlaneKind>& kinds,
          const Eigen::Vector3d& up,
          const ExtentOfPlane& extent_of,
          Dropped& dropped);

/** \brief Keeps the chosen planes alone. Where none is left, the advice says why. */
Dropped
keepChosen (const PlaneChoice& choice,
            const ExtentOfPlane& extent_of,
            Detected& detected);

nlohmann::ordered_json
toObject (const Dropped& dropped);

} // namespace pcl_ops::apps
