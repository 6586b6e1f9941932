// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <support/las_bytes.h>
#include <support/program_folder.h>

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

using InputCloud = pcl::PointCloud<pcl::PointXYZI>;

inline constexpr int points_of_side = 50;
inline constexpr int points_of_plane = points_of_side * points_of_side;

/** \brief Adds a grid of points, row by row from a corner on. The intensity of a point
 * is its index in the cloud.
 * \param[in] row,column steps from one row or column to the next [m]
 * \param[in] rows,columns numbers of rows and columns */
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
      const Eigen::Vector3f position =
          corner + static_cast<float> (r) * row + static_cast<float> (c) * column;
      const auto index = static_cast<float> (cloud.size());
      cloud.push_back ({position.x(), position.y(), position.z(), index});
    }
}

/** \brief In this order: a floor of 2 m x 2 m, a point with NaN coordinates, and a wall
 * of 2 m x 2 m at x = 3 m.
 * \param[in] side number of points along each edge of floor and wall */
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

/** \brief Floor and wall of \ref floorAndWall without the point of NaN, moved to UTM
 * coordinates, in whole millimeters. */
inline LasRecipe
floorAndWallInLas ()
{
  LasRecipe recipe;
  recipe.points.clear();
  for (const pcl::PointXYZI& point : floorAndWall())
    if (std::isfinite (point.x)) {
      const Eigen::Array3f millimeters = 1000.0f * point.getArray3fMap();
      std::array<std::int32_t, 3>& raw = recipe.points.emplace_back();
      Eigen::Map<Eigen::Array3i> (raw.data()) = millimeters.round().cast<int>();
    }
  return recipe;
}

/** \brief \ref floorAndWallInLas with GeoTIFF keys.
 * \param[in] keys each key and its value */
inline LasRecipe
floorAndWallWithKeys (const std::vector<std::array<std::uint16_t, 2>>& keys)
{
  LasRecipe recipe = floorAndWallInLas();
  recipe.vlrs = {geoKeys (keys)};
  return recipe;
}

/** \brief Text of a level square of points 4 cm apart at UTM coordinates; the fourth
 * column is the index of the point.
 * \param[in] side number of points along each edge
 * \param[in] z height of all points [m] */
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

/** \brief A folder to run pcl_ops_segment in, with \ref floorAndWall as in.pcd. */
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
};
