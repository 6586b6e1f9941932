// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_file.h"

#include "inputs.h"
#include "output_file.h"
#include <cli/errors.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace pcl_ops::apps {

namespace {

constexpr const char* line_format = "timestamp tx ty tz qx qy qz qw";
using Numbers = std::array<double, 8>;

/** \return what is wrong with the line; empty if nothing is */
std::string
readNumbers (const std::string& line, Numbers& numbers)
{
  std::istringstream words (line);
  std::size_t count = 0;
  for (std::string word; words >> word; ++count) {
    if (count == numbers.size())
      return "has more than 8 numbers";
    const char* end = word.data() + word.size();
    const auto [rest, error] = std::from_chars (word.data(), end, numbers[count]);
    if (error != std::errc() || rest != end || !std::isfinite (numbers[count]))
      return "has something that is no number in place " + std::to_string (count + 1);
  }
  if (count < numbers.size())
    return "has " + std::to_string (count) + " numbers";
  return {};
}

std::string
readPose (const std::string& line, Eigen::Isometry3d& pose)
{
  Numbers n{};
  std::string problem = readNumbers (line, n);
  if (!problem.empty())
    return problem;
  const Eigen::Quaterniond rotation (n[7], n[4], n[5], n[6]);
  // No sensor moves so far; beyond, doubles lose what a plane is off.
  constexpr double farthest = 1e9;
  for (const std::size_t axis : {1u, 2u, 3u})
    if (std::abs (n[axis]) > farthest)
      return "has a place more than 1e9 m from zero";
  // Files have as few as four decimals.
  constexpr double rounding = 0.01;
  if (!(std::abs (rotation.norm() - 1.0) <= rounding))
    return "has a quaternion qx qy qz qw that is not of length 1";
  pose = Eigen::Translation3d (n[1], n[2], n[3]) * rotation.normalized();
  return {};
}

} // namespace

std::vector<Eigen::Isometry3d>
loadPoses (const std::string& file)
{
  std::istringstream lines (readTextFile (file, "a text file of poses"));
  std::vector<Eigen::Isometry3d> poses;
  std::size_t number = 0;
  for (std::string line; std::getline (lines, line);) {
    ++number;
    const std::size_t first = line.find_first_not_of (" \t\r");
    if (first == std::string::npos || line[first] == '#')
      continue;
    const std::string problem = readPose (line, poses.emplace_back());
    if (!problem.empty())
      throw WorkError (file,
                       "line " + std::to_string (number) + " " + problem +
                           "; it has to be " + line_format);
  }
  return poses;
}

void
savePoses (const std::string& file, const std::vector<Eigen::Isometry3d>& poses)
{
  constexpr double seconds = 0.1;
  std::string text = std::string ("# ") + line_format + "\n";
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d place = poses[i].translation();
    const Eigen::Quaterniond rotation (poses[i].linear());
    std::array<char, 256> line{};
    std::snprintf (line.data(),
                   line.size(),
                   "%.1f %.9f %.9f %.9f %.9f %.9f %.9f %.9f\n",
                   seconds * static_cast<double> (i),
                   place.x(),
                   place.y(),
                   place.z(),
                   rotation.x(),
                   rotation.y(),
                   rotation.z(),
                   rotation.w());
    text += line.data();
  }
  writeTextFile (file, text);
}

} // namespace pcl_ops::apps
