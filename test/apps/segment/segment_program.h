// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <support/las_bytes.h>
#include <support/program_folder.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using InputCloud = pcl::PointCloud<pcl::PointXYZI>;
using LabelledCloud = pcl::PointCloud<pcl::PointXYZRGBL>;

inline constexpr int points_of_side = 50;
inline constexpr int points_of_plane = points_of_side * points_of_side;
/** \brief The reading without coordinates between floor and wall. */
inline constexpr int missing_reading = points_of_plane;

/** \brief Adds a grid of points; the intensity of each is its index. */
inline void
addGrid (InputCloud& cloud,
         const Eigen::Vector3f& corner,
         const Eigen::Vector3f& row,
         int rows,
         const Eigen::Vector3f& column,
         int columns)
{
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const Eigen::Vector3f place =
          corner + static_cast<float> (r) * row + static_cast<float> (c) * column;
      const auto index = static_cast<float> (cloud.size());
      cloud.push_back ({place.x(), place.y(), place.z(), index});
    }
}

/** \brief A floor of 2 m by 2 m, one missing reading, and a wall at x = 3 m.
 * \param[in] side how many points there are along each edge */
inline InputCloud
floorAndWall (int side = points_of_side)
{
  constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
  const Eigen::Matrix3f step = Eigen::Matrix3f::Identity() * 2.0f / float (side);
  InputCloud cloud;
  addGrid (cloud, {0, 0, 0}, step.col (0), side, step.col (1), side);
  addGrid (cloud, Eigen::Vector3f::Constant (not_a_number), {0, 0, 0}, 1, {0, 0, 0}, 1);
  addGrid (cloud, {3, 0, 0}, step.col (1), side, step.col (2), side);
  cloud.is_dense = false;
  cloud.sensor_origin_ = Eigen::Vector4f (0.5f, 1.0f, 1.5f, 0.0f);
  return cloud;
}

/** \brief A floor of 2 m by 2 m and a wall at x = 3 m, in UTM coordinates and whole
 * millimeters. */
inline LasRecipe
floorAndWallInLas ()
{
  constexpr float millimeters = 1000.0f;
  LasRecipe recipe;
  recipe.points.clear();
  for (const pcl::PointXYZI& point : floorAndWall())
    if (std::isfinite (point.x))
      recipe.points.push_back (
          {static_cast<int> (std::lround (point.x * millimeters)),
           static_cast<int> (std::lround (point.y * millimeters)),
           static_cast<int> (std::lround (point.z * millimeters))});
  return recipe;
}

/** \brief A square of points, 4 cm apart, at UTM coordinates in text, with the number
 * of each point. */
inline std::string
squareText (int side, double z, const char* separator = " ")
{
  std::ostringstream text;
  text << std::fixed << std::setprecision (3);
  for (int i = 0; i < side * side; ++i)
    text << 500'000 + 0.04 * (i / side) << separator << 5'400'000 + 0.04 * (i % side)
         << separator << z << separator << i << "\n";
  return text.str();
}

/** \brief A folder with the input cloud, to run the program in. */
class Segment : public ProgramFolder {
protected:
  Segment() : ProgramFolder (PCL_OPS_SEGMENT_PROGRAM)
  {
    save ("in.pcd", floorAndWall());
  }

  void
  save (const std::string& file, const InputCloud& cloud) const
  {
    pcl::io::savePCDFileBinary (folder_ / file, cloud);
  }

  /** \brief What a run prints with --planes -. */
  nlohmann::json
  jsonOf (const std::string& arguments) const
  {
    return nlohmann::json::parse (expectDone (arguments + " --planes -").out);
  }

  /** \brief Ends the program by SIGTERM as soon as a condition of the shell holds, at
   * the latest after some ten seconds. */
  Outcome
  runAndTerminate (const std::string& environment,
                   const std::string& arguments,
                   const std::string& condition) const
  {
    return run (arguments + " & segment=$!; n=0; until " + condition +
                    " || [ $n -gt 1000 ]; do sleep 0.01; n=$((n + 1)); done; "
                    "kill -TERM $segment; wait $segment; }",
                "{ " + environment);
  }

  template <typename Cloud = LabelledCloud>
  Cloud
  loaded (const std::string& file) const
  {
    Cloud cloud;
    EXPECT_EQ (pcl::io::loadPCDFile (folder_ / file, cloud), 0) << file;
    return cloud;
  }

  /** \brief The labelled cloud the program makes of a file. */
  LabelledCloud
  label (const std::string& input, const std::string& options = "") const
  {
    expectDone (input + " labelled.pcd " + options);
    return loaded ("labelled.pcd");
  }
};

inline std::vector<std::uint32_t>
labelsOf (const LabelledCloud& cloud)
{
  std::vector<std::uint32_t> labels;
  for (const pcl::PointXYZRGBL& point : cloud)
    labels.push_back (point.label);
  return labels;
}

/** \brief The labels of the points from \p begin to before \p end. */
inline std::set<std::uint32_t>
distinct (const std::vector<std::uint32_t>& labels, int begin, int end)
{
  return {labels.begin() + begin, labels.begin() + end};
}
