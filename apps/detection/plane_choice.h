// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"
#include <pcl_ops/plane_filter.h>

namespace pcl_ops::apps {

/** \brief Which planes to keep: options that programs share. */
struct PlaneChoice {
  /** \brief Orientations and kinds, separated by commas, or "largest"; empty: all. */
  std::string only;
  /** \brief Largest angle of a normal to PlaneFilter::direction [degree]. */
  double within = 10.0;
  /** \brief Smallest and largest angle to the horizontal [degree]. */
  std::optional<std::array<double, 2>> slope;
  /** \brief The other conditions. Its slope comes from \ref slope, its
   * direction_tolerance from \ref within, its up_axis from \ref chosenOf; for \ref only
   * "largest" its max_planes is 1. */
  PlaneFilter filter;
  /** \brief The options that were given, with their values, for reports; --within also
   * if only --direction was given. */
  Settings given = Settings::object();

  /** \brief Whether \ref only names a kind, such as "wall"; "other" is an orientation.
   */
  bool
  namesKinds () const;
};

/** \brief How many planes each option dropped. */
struct Dropped {
  struct ByOption {
    /** \brief Without "--": "min-area". */
    std::string option;
    std::size_t planes;
  };

  /** \brief Number of planes before any was dropped. */
  std::size_t found = 0;
  /** \brief Only the options that dropped any plane. */
  std::vector<ByOption> by_option;

  /** \brief Returns "1 by --direction, 2 by --min-area"; empty if none was dropped. */
  std::string
  reasons () const;
};

/** \brief Title of these options in the help. */
inline constexpr const char* title_of_choice = "Planes to keep";

void
declareChoice (CommandLine& line, PlaneChoice& choice);

/** \brief Checks the options and sets PlaneChoice::given.
 * \throws UsageError if --within is given without --direction, or if an upper bound is
 * below its lower bound */
void
finishChoice (const CommandLine& line, PlaneChoice& choice);

/** \brief Returns the indices of the chosen planes, in ascending order.
 * \param[in] kinds one for each plane; empty: no plane has a kind
 * \param[in] up against gravity, in the frame of the planes
 * \param[in] extent_of called with elements of \p planes, not with copies, so that it
 * can find their indices; only for planes whose area, width or size decides
 * \param[out] dropped how many planes each option dropped */
std::vector<std::size_t>
chosenOf (const PlaneChoice& choice,
          const std::vector<PlaneSegment>& planes,
          const std::vector<PlaneKind>& kinds,
          const Eigen::Vector3d& up,
          const ExtentOfPlane& extent_of,
          Dropped& dropped);

/** \brief Removes all planes but the chosen ones from \p detected, and adds the options
 * to its settings. If no plane is left, the advice says why.
 * \return how many planes each option dropped */
Dropped
keepChosen (const PlaneChoice& choice,
            const ExtentOfPlane& extent_of,
            Detected& detected);

/** \brief Returns the JSON {"of": planes found, "by": {option: planes dropped, ...}},
 * without "by" if none was dropped. */
nlohmann::ordered_json
toObject (const Dropped& dropped);

} // namespace pcl_ops::apps
