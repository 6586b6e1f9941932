// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <io/cloud_file.h>
#include <io/las_file.h>
#include <nlohmann/json.hpp>
#include <support/cloud_values.h>
#include <support/program_folder.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

/** \brief A folder to run pcl_ops_tiles in. */
class Tiles : public ProgramFolder {
protected:
  Tiles() : ProgramFolder (PCL_OPS_TILES_PROGRAM) {}

  /** \brief A small town of terraces in four files, in the folder town. */
  void
  makeTown (const std::string& options = "--points 60000 --tiles 4") const
  {
    const Outcome done =
        shell ("'" PCL_OPS_SIMULATE_PROGRAM "' town --scene town " + options);
    ASSERT_EQ (done.exit_code, 0) << done.err;
  }

  /** \brief A hash of each output in a folder by its name, without what a run left for
   * others, or behind when it was killed. */
  std::map<std::string, std::size_t>
  outputsIn (const std::string& name) const
  {
    std::map<std::string, std::size_t> files;
    for (const auto& entry : std::filesystem::directory_iterator (folder_ / name))
      if (entry.is_regular_file() && entry.path().filename().string().front() != '.')
        files[entry.path().filename().string()] =
            std::hash<std::string>() (contentOf (entry.path().string()));
    return files;
  }

  std::vector<std::uint32_t>
  labelsIn (const std::string& name) const
  {
    return valuesOf<std::uint32_t> (pcl_ops::apps::loadCloud (folder_ / name), "label");
  }

  nlohmann::json
  listIn (const std::string& name) const
  {
    return jsonIn (name + "/planes.json");
  }
};
