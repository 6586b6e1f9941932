// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <io/cloud_file.h>
#include <io/las_writer.h>
#include <nlohmann/json.hpp>
#include <support/temporary_folder.h>
#include <sys/wait.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

struct Outcome {
  int exit_code;
  std::string out, err;
};

inline std::size_t
lines (const std::string& text)
{
  return static_cast<std::size_t> (std::count (text.begin(), text.end(), '\n'));
}

/** \brief A folder to run the programs in. */
class Tiles : public testing::Test {
protected:
  /** \brief Runs a command of the shell in the folder. */
  Outcome
  shell (const std::string& command) const
  {
    const std::string line = "cd '" + folder_.path() + "' && " + command + " >'" +
                             streams_ / "out" + "' 2>'" + streams_ / "err" + "'";
    const int status = std::system (line.c_str());
    return {WEXITSTATUS (status),
            contentOf (streams_ / "out"),
            contentOf (streams_ / "err")};
  }

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

  TemporaryFolder folder_;
  TemporaryFolder streams_{"_streams"};
};
