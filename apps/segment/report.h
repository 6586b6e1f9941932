// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include <pcl_ops/result_warnings.h>

#include <iosfwd>

namespace pcl_ops::apps {

/** \brief What was found in one cloud, for the table, messages and output files. */
struct Report {
  /** \brief Name of the input in messages. */
  std::string input;
  /** \brief Name of the method, as in --method. */
  std::string method;
  /** \brief Number of points of the cloud, including NaN points. */
  std::size_t points = 0;
  /** \brief Planes and how they were found. */
  Detected detected;
  /** \brief Id of each plane in Detected::planes: its label in the labeled cloud. */
  std::vector<std::uint32_t> ids;
  /** \brief Id of each plane in Detected::whole_planes, on which pieces lie. */
  std::vector<std::uint32_t> whole_plane_ids;
  /** \brief How many planes the options of \ref PlaneChoice dropped. */
  Dropped dropped;
  /** \brief Why the cloud looks damaged (damageOf); empty if it does not. */
  std::string damage;
  /** \brief What is doubtful about the planes and the plan. */
  std::vector<ResultWarning> warnings;
  /** \brief Contents of output files that the table does not show (saveOutputs). */
  std::vector<std::string> file_notes;
  /** \brief The floor plan, if one is asked for. */
  std::optional<FloorPlan> plan;
  /** \brief Extent of each plane, with the hull of --hull. Empty if that is concave and
   * no output needs extents. */
  std::vector<PlaneExtent> extents;

  /** \brief Returns for each piece the id of the plane on which it lies; empty without
   * --pieces. */
  std::vector<std::uint32_t>
  planeIdsOfPieces () const
  {
    std::vector<std::uint32_t> plane_ids;
    for (const std::size_t whole_plane : detected.lies_on)
      plane_ids.push_back (whole_plane_ids[whole_plane]);
    return plane_ids;
  }
};

/** \brief Prints the table of planes, how the up axis was found, regularized planes,
 * dropped planes, advice, hints, the lengths that were used, and times [ms]. */
void
printTable (const Report& report, std::ostream& stream);

/** \brief Returns the result in a few words: points, planes, dropped planes, advice,
 * hints. It has no times, so that the same run gives the same words. */
std::string
summaryOf (const Report& report);

/** \brief Returns the list of planes of --planes FILE.json. */
nlohmann::ordered_json
toJson (const Report& report);

/** \brief Whether a file name, without folder, is one that --planes-dir writes. */
bool
isPlaneFile (const std::string& name);

/** \brief Writes the outputs for one cloud, each file or folder in one step.
 * \param[in] shifted the points of \p cloud in which the planes were found
 * \return contents of the files that the table does not show: "plan.dxf: 12 walls, 3
 * rooms, 41.2 m2"
 * \throws WorkError if an output cannot be written, Interrupted */
std::vector<std::string>
saveOutputs (const SegmentOptions& options,
             const Outputs& outputs,
             const FileCloud& cloud,
             const ShiftedCloud& shifted,
             const Report& report);

} // namespace pcl_ops::apps
