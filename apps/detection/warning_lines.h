// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/las_unit.h>
#include <nlohmann/json.hpp>
#include <pcl_ops/result_warnings.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Groups the warnings on all inputs of a run by their code. */
class WarningLines {
public:
  /** \brief Adds the warnings on one input. */
  void
  add (const std::string& input, const std::vector<ResultWarning>& warnings);

  /** \brief Returns a line for each code, that of the most inputs first, at most
   * ResultContext::max_warnings lines. A line has the warning on the first input:
   * "a.pcd and 11 others: what is doubtful about a.pcd; what to do". */
  std::vector<std::string>
  lines () const;

private:
  /** \brief The warnings of one code. */
  struct Line {
    /** \brief The warning on the first input. */
    ResultWarning warning;
    std::string first_input;
    /** \brief Number of inputs with this code. */
    std::size_t input_count = 0;
  };
  std::vector<Line> lines_;
};

/** \brief If a floor plan has no wall, puts a warning on that before the others: it has
 * the most likely reason. A warning on the unit of the cloud is a better reason: its
 * text replaces the other one, and the warning itself is removed. Only the first
 * ResultContext::max_warnings warnings are kept.
 * \param[in] is_in_tiles whether pcl_ops_tiles made the plan, which has no --up */
void
putWarningOnPlan (const PlanCounts& counts,
                  bool is_in_tiles,
                  std::vector<ResultWarning>& warnings);

/** \brief If the reference system of a LAS file has x and y in meters and z in feet, or
 * the reverse, puts a warning on these units before the others. Only the first
 * ResultContext::max_warnings warnings are kept. */
void
putWarningOnHeights (LasFile& las, std::vector<ResultWarning>& warnings);

/** \brief Returns the unit of x and y by the reference system of a LAS file. */
CoordinateUnit
coordinateUnitOf (LasFile& las);

/** \brief Returns warnings as a JSON array of objects with the keys code and text. */
nlohmann::ordered_json
warningsToJson (const std::vector<ResultWarning>& warnings);

} // namespace pcl_ops::apps
