// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"
#include <detection/plane_choice.h>
#include <detection/plane_map.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

inline constexpr const char* program_name = "pcl_ops_tiles";

struct TilesOptions {
  std::vector<std::string> inputs;
  std::string output_dir;
  PlanOptions plan;
  /** \brief Where the chosen planes go, .json, .csv or .geojson; empty for nowhere. */
  std::string planes;
  /** \brief Where a picture of them goes, .png; empty for nowhere. */
  std::string image;
  PlaneChoice choice;
  MapOptions map;
  /** \brief Where the plan is; empty for the folder of outputs. */
  std::string plan_file;
  /** \brief Tiles at a time; 0: as many as there are processors. */
  unsigned jobs = 1;
  bool dry_run = false;
  bool quiet = false;
};

/** \brief \return false if --help or --version was answered and nothing is left to do
 * \throws UsageError */
bool
readOptions (int argc, const char* const* argv, TilesOptions& options);

} // namespace pcl_ops::apps
