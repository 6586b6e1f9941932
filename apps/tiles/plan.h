// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_grid.h"

#include <optional>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief A file of points as it was when the plan was made. */
struct PlannedInput {
  std::string file;
  std::uint64_t bytes = 0;
  /** \brief When it was last written [ns]. */
  std::int64_t written = 0;
  std::uint64_t points = 0;
};

bool
hasChanged (const PlannedInput& input);

/** \brief What all parts of a run have to agree on. */
struct Plan {
  /** \brief Ordered by name. */
  std::vector<PlannedInput> inputs;
  /** \brief Its place is near the points of the first input. */
  TileGrid grid;
  std::uint64_t likely_tiles = 0;
  /** \brief Planes are looked for on voxels, as their size was given. */
  bool is_on_voxels = false;
  /** \brief Its length in the unit of the inputs, for what knows buildings. */
  double meter = 1.0;

  std::uint64_t
  points () const
  {
    std::uint64_t sum = 0;
    for (const PlannedInput& input : inputs)
      sum += input.points;
    return sum;
  }
};

/** \brief A file that has a plan, or will have. */
struct PlanFile {
  std::string name;
  /** \brief Advice that ends the error message where the file has another plan than it
   * should. */
  std::string fix;
};

struct PlanOptions {
  /** \brief Edges [m]; by the density of the points where not given. */
  std::optional<double> voxel_size, tile;
  /** \brief The length of a meter in the unit of the inputs; where not given by their
   * reference system. */
  std::optional<double> meter = std::nullopt;
};

/** \brief Looks at the headers of all inputs and at some of their points.
 * \param[in] files in any order
 * \throws WorkError if any cannot be read or takes no labels */
Plan
makePlan (std::vector<std::string> files, const PlanOptions& options);

/** \brief The reference system that all inputs are in, "EPSG:N"; empty where they do
 * not say. */
std::string
commonCrs (const Plan& plan);

/** \brief The content of a plan file. Runs of plans with equal text leave the same
 * files. */
std::string
toText (const Plan& plan);

/** \brief \throws WorkError if it cannot be read */
Plan
loadPlan (const PlanFile& file);

/** \brief \throws WorkError if a plan that was made earlier is for other inputs, or
 * other lengths than those given now */
void
checkIsFor (const Plan& plan,
            const PlanFile& file,
            std::vector<std::string> inputs,
            const PlanOptions& options);

} // namespace pcl_ops::apps
