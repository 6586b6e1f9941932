// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_file.h"

#include "inputs.h"
#include "output_file.h"
#include <cli/errors.h>

#include <array>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace pcl_ops::apps {

namespace {

constexpr const char* line_format = "timestamp tx ty tz qx qy qz qw";

/** \return what is wrong with the line; empty if nothing is */
std::string
readPose (const std::string& line, Eigen::Isometry3d& pose)
{
  std::array<double, 8> n{};
  std::istringstream words (line);
  std::size_t count = 0;
  for (std::string word; words >> word; ++count) {
    if (count == n.size())
      return "has more than 8 numbers";
    const char* end = word.data() + word.size();
    const auto [rest, error] = std::from_chars (word.data(), end, n[count]);
    if (error != std::errc() || rest != end || !std::isfinite (n[count]))
      return "has something that is no number in place " + std::to_string (count + 1);
  }
  if (count < n.size())
    return "has " + std::to_string (count) + " numbers";
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
  std::ostringstream text;
  text << "# " << line_format << "\n" << std::fixed;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d place = poses[i].translation();
    const Eigen::Quaterniond q (poses[i].linear());
    text << std::setprecision (1) << seconds * static_cast<double> (i)
         << std::setprecision (9);
    for (const double number :
         {place.x(), place.y(), place.z(), q.x(), q.y(), q.z(), q.w()})
      text << ' ' << number;
    text << "\n";
  }
  writeTextFile (file, text.str());
}

} // namespace pcl_ops::apps
