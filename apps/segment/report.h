// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include <pcl_ops/result_warnings.h>

#include <iosfwd>

namespace pcl_ops::apps {

struct Report {
  std::string input;
  std::string method;
  /** \brief Points of the cloud, those without coordinates included. */
  std::size_t points = 0;
  Detected detected;
  /** \brief Of each plane: its label in the cloud. */
  std::vector<std::uint32_t> ids;
  /** \brief Of each plane that pieces lie on: its number in the cloud. */
  std::vector<std::uint32_t> ids_of_whole;
  Dropped dropped;
  /** \brief What makes the cloud look damaged; empty where nothing does. */
  std::string damage;
  /** \brief What is doubtful about the planes and the plan. */
  std::vector<ResultWarning> warnings;
  /** \brief What files hold of which the table says nothing. */
  std::vector<std::string> written;
  /** \brief The floor plan, if one is asked for. */
  std::optional<FloorPlan> plan;
  /** \brief One for each plane, if an output says where planes end; else none. */
  std::vector<PlaneExtent> extents;

  /** \brief The numbers of the planes that pieces lie on; empty where there are none.
   */
  std::vector<std::uint32_t>
  planesOfPieces () const
  {
    std::vector<std::uint32_t> numbers;
    for (const std::size_t plane : detected.lies_on)
      numbers.push_back (ids_of_whole[plane]);
    return numbers;
  }
};

/** \brief The table of --help's standard output: planes, then times. */
void
printTable (const Report& report, std::ostream& stream);

/** \brief The run in a few words: points, planes, advice; without times, so that the
 * same run gives the same words. */
std::string
summaryOf (const Report& report);

nlohmann::ordered_json
toJson (const Report& report);

/** \brief Whether --planes-dir gives such a name, of a file without its folder. */
bool
isPlaneFile (const std::string& name);

/** \brief Writes what was asked for of a cloud, each file or folder in one step.
 * \return what files hold of which the table says nothing: "plan.dxf: 12 walls, 3 rooms,
 * 41.2 m2"
 * \throws WorkError if one cannot be written */
std::vector<std::string>
saveOutputs (const SegmentOptions& options,
             const Outputs& outputs,
             const FileCloud& cloud,
             const ShiftedCloud& shifted,
             const Report& report);

} // namespace pcl_ops::apps
