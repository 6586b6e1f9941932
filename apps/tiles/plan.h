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
  /** \brief Absolute path. */
  std::string file;
  /** \brief Size of the file. */
  std::uint64_t bytes = 0;
  /** \brief Time of the last change of the file [ns], since the epoch of the file
   * system's clock. */
  std::int64_t changed_at = 0;
  /** \brief Number of points, also of those that are not finite. */
  std::uint64_t points = 0;
};

/** \brief Whether the file of an input has another size or time than in the plan. */
bool
hasChanged (const PlannedInput& input);

/** \brief What all phases and ranks of a run must agree on. */
struct Plan {
  /** \brief Sorted by file name. */
  std::vector<PlannedInput> inputs;
  /** \brief The cells and tiles of the survey. \ref TileGrid::cell_near_points is near
   * most points of the first input that has finite points. */
  TileGrid grid;
  /** \brief Number of tiles that have points of the sample that \ref makePlan takes;
   * the other points may be in further tiles. */
  std::uint64_t likely_tiles = 0;
  /** \brief Whether planes are found on voxels, because --voxel-size was given. */
  bool is_on_voxels = false;
  /** \brief Length of a meter in the unit of the inputs, for kinds of planes and floor
   * plans. */
  double meter = 1.0;

  /** \brief Returns the number of points of all inputs. */
  std::uint64_t
  points () const
  {
    std::uint64_t sum = 0;
    for (const PlannedInput& input : inputs)
      sum += input.points;
    return sum;
  }
};

/** \brief The file of a plan, which need not exist yet. */
struct PlanFile {
  std::string name;
  /** \brief End of error messages about the file: how to replace a wrong plan. */
  std::string fix;
};

/** \brief What the user gives for a plan. */
struct PlanOptions {
  /** \brief Edge of a voxel, which is a cell of the grid [m]. Not given: the density of
   * the points decides. */
  std::optional<double> voxel_size;
  /** \brief Edge of a tile [m]. Not given: a fixed number of voxels. */
  std::optional<double> tile;
  /** \brief Length of a meter in the unit of the inputs. Not given: their reference
   * system decides. */
  std::optional<double> meter = std::nullopt;
};

/** \brief Makes a plan from the headers of all inputs and a sample of their points.
 * \param[in] files in any order
 * \throws WorkError if a file cannot be read or labels cannot be added to it,
 * UsageError if given voxels or tiles are too small or too large */
Plan
makePlan (std::vector<std::string> files, const PlanOptions& options);

/** \brief Returns the reference system of all inputs, "EPSG:N"; empty if they differ or
 * have no number, or if an input is missing or no LAS. */
std::string
commonCrs (const Plan& plan);

/** \brief Returns the text of a plan file. Runs whose plans have the same text write
 * the same files. */
std::string
toText (const Plan& plan);

/** \brief Reads a plan file.
 * \throws WorkError if the file cannot be read or is no plan of this version */
Plan
loadPlan (const PlanFile& file);

/** \brief Checks whether a run can follow an earlier plan.
 * \throws WorkError if the plan is for other inputs or other lengths than those given
 * now, or an input has changed since */
void
checkIsFor (const Plan& plan,
            const PlanFile& file,
            std::vector<std::string> inputs,
            const PlanOptions& options);

} // namespace pcl_ops::apps
