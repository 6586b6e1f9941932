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

/** \brief What is doubtful about the results of a run, each kind in one line. */
class WarningLines {
public:
  /** \brief Adds those of one input. */
  void
  add (const std::string& input, const std::vector<ResultWarning>& warnings);

  /** \brief At most three lines, those of most inputs first: "a.pcd and 11 others: what
   * is doubtful about a.pcd; what to do". */
  std::vector<std::string>
  lines () const;

private:
  struct Line {
    ResultWarning warning;
    std::string first_input;
    std::size_t inputs = 0;
  };
  std::vector<Line> lines_;
};

/** \brief Puts before all others why a floor plan has no wall, if it has none: the unit
 * of the cloud, if that is doubtful, is then not told twice. */
void
putWarningOnPlan (const PlanCounts& counts, std::vector<ResultWarning>& warnings);

/** \brief What x and y are, as the reference system of a file says. */
CoordinateUnit
coordinateUnitOf (LasFile& las);

/** \brief An array of objects with code and text. */
nlohmann::ordered_json
warningsToJson (const std::vector<ResultWarning>& warnings);

} // namespace pcl_ops::apps
