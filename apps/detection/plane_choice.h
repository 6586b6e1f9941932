// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"
#include <pcl_ops/plane_filter.h>

namespace pcl_ops::apps {

/** \brief Options on which planes to keep, for several programs. */
struct PlaneChoice {
  /** \brief Orientations and kinds, separated by commas, or "largest"; empty: all. */
  std::string only;
  /** \brief Largest angle of a normal, or of its opposite, to PlaneFilter::direction
   * [degree]. */
  double within = 10.0;
  /** \brief Smallest and largest angle to the horizontal [degree]. */
  std::optional<std::array<double, 2>> slope;
  /** \brief The other conditions. \ref chosenOf sets four of its members in a copy:
   * slope by \ref slope, direction_tolerance by \ref within, up_axis by its argument,
   * and max_planes to 1 if \ref only is "largest". */
  PlaneFilter filter;
  /** \brief The options that were given, with their values, for reports; --within also
   * if only --direction was given. Is set by \ref finishChoice. */
  Settings given = Settings::object();

  /** \brief Whether \ref only names a kind, such as "wall"; "other" is an orientation.
   */
  bool
  namesKinds () const;
};

/** \brief How many planes each option dropped. */
struct Dropped {
  struct ByOption {
    /** \brief Name of the option without "--": "min-area". */
    std::string option;
    /** \brief Number of planes that the option dropped. */
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

/** \brief Declares the options of \ref PlaneChoice, a group in the help. */
void
declareChoice (CommandLine& line, PlaneChoice& choice);

/** \brief Checks the options after the command line was parsed, and sets
 * PlaneChoice::given.
 * \throws UsageError if --within is given without --direction, or if an upper bound is
 * below its lower bound */
void
finishChoice (const CommandLine& line, PlaneChoice& choice);

/** \brief Returns the indices in \p planes of the chosen planes, in ascending order.
 * \param[in] kinds one for each plane; empty: no plane has a kind
 * \param[in] up direction against gravity, in the frame of the planes
 * \param[in] extent_of returns the extent of a plane. It is called with elements of \p
 * planes, not with copies, so that it can find their indices, and only if the area,
 * width or size of a plane decides.
 * \param[out] dropped how many planes each option dropped */
std::vector<std::size_t>
chosenOf (const PlaneChoice& choice,
          const std::vector<PlaneSegment>& planes,
          const std::vector<PlaneKind>& kinds,
          const Eigen::Vector3d& up,
          const ExtentOfPlane& extent_of,
          Dropped& dropped);

/** \brief Removes all planes but the chosen ones from \p detected, and adds the given
 * options to its settings. If all planes are removed, Detected::advice says why.
 * \param[in] extent_of as of \ref chosenOf
 * \return how many planes each option dropped */
Dropped
keepChosen (const PlaneChoice& choice,
            const ExtentOfPlane& extent_of,
            Detected& detected);

/** \brief Returns the JSON object {"of": number of planes found, "by": {key of an
 * option: number of planes it dropped, ...}}, without "by" if none was dropped. */
nlohmann::ordered_json
toObject (const Dropped& dropped);

} // namespace pcl_ops::apps
