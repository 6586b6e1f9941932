// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <io/cloud_file.h>
#include <io/las_writer.h>
#include <nlohmann/json.hpp>
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
  /** \brief Runs pcl_ops_tiles. \param[in] before what is in front of the program */
  Outcome
  tiles (const std::string& arguments, const std::string& before = "") const
  {
    return shell (before + " '" PCL_OPS_TILES_PROGRAM "' " + arguments);
  }

  void
  expectDone (const std::string& arguments, const std::string& before = "") const
  {
    const Outcome done = tiles (arguments, before);
    EXPECT_EQ (done.exit_code, 0) << done.out << done.err;
  }

  /** \brief A run that ends with a code and one line. */
  void
  expectRefused (const std::string& arguments,
                 const std::string& complaint,
                 int exit_code = 1,
                 const std::string& before = "") const
  {
    const Outcome done = tiles (arguments, before);
    EXPECT_EQ (done.exit_code, exit_code) << arguments << done.out;
    EXPECT_EQ (done.err, "pcl_ops_tiles: " + complaint + "\n") << arguments;
  }

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
    const pcl_ops::apps::FileCloud cloud = pcl_ops::apps::loadCloud (folder_ / name);
    std::vector<std::uint32_t> labels (cloud.size());
    for (const pcl::PCLPointField& field : cloud.points.fields)
      if (field.name == "label")
        for (std::size_t i = 0; i < labels.size(); ++i)
          std::memcpy (&labels[i],
                       cloud.points.data.data() + i * cloud.points.point_step +
                           field.offset,
                       sizeof (labels[i]));
    return labels;
  }

  nlohmann::json
  listIn (const std::string& name) const
  {
    return nlohmann::json::parse (contentOf (folder_ / (name + "/planes.json")));
  }
};
