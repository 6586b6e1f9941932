// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_file.h"

#include "inputs.h"
#include "output_file.h"
#include <cli/errors.h>

#include <charconv>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace pcl_ops::apps {

namespace {

/** \brief The format of a line with a quaternion. */
constexpr const char* line_format = "timestamp tx ty tz qx qy qz qw";

/** \brief How many numbers a line has in \ref line_format, and how many with a matrix.
 */
constexpr std::size_t numbers_with_quaternion = 8, numbers_of_matrix = 12;

/** \brief How much the length of a quaternion may differ from 1, and a rotation matrix
 * times its transpose from the identity: some files have only four decimals. */
constexpr double rotation_rounding = 0.01;

/** \brief Reads the numbers of a line, at most 13: one more than a pose can have.
 * \return what is wrong with the line; empty if nothing is */
std::string
readNumbers (const std::string& line, std::vector<double>& numbers)
{
  std::istringstream words (line);
  for (std::string word; words >> word && numbers.size() <= numbers_of_matrix;) {
    const char* end = word.data() + word.size();
    double& number = numbers.emplace_back();
    const auto [rest, error] = std::from_chars (word.data(), end, number);
    if (error != std::errc() || rest != end || !std::isfinite (number))
      return "has something that is no number as value " +
             std::to_string (numbers.size());
  }
  return {};
}

/** \brief Sets a pose by the numbers of a line.
 * \param[in] n the numbers in the order of \ref line_format
 * \return what is wrong with them; empty if nothing is */
std::string
fromQuaternion (const std::vector<double>& n, Eigen::Isometry3d& pose)
{
  const Eigen::Quaterniond rotation (n[7], n[4], n[5], n[6]);
  if (!(std::abs (rotation.norm() - 1.0) <= rotation_rounding))
    return "has a quaternion qx qy qz qw that is not of length 1";
  pose = Eigen::Translation3d (n[1], n[2], n[3]) * rotation.normalized();
  return {};
}

/** \brief Sets a pose by the numbers of a line.
 * \param[in] n the first three rows of a matrix, row by row, as KITTI has them (Geiger
 * et al., CVPR 2012)
 * \return what is wrong with them; empty if nothing is */
std::string
fromMatrix (const std::vector<double>& n, Eigen::Isometry3d& pose)
{
  using Rows = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;
  const Rows rows = Eigen::Map<const Rows> (n.data());
  const Eigen::Matrix3d rotation = rows.leftCols<3>();
  if (!(rotation * rotation.transpose()).isIdentity (rotation_rounding) ||
      rotation.determinant() < 0.0)
    return "has a matrix whose first three columns are no rotation";
  pose =
      Eigen::Translation3d (rows.col (3)) * Eigen::Quaterniond (rotation).normalized();
  return {};
}

/** \brief Sets a pose by a line.
 * \return what is wrong with the line; empty if nothing is */
std::string
readPose (const std::string& line, Eigen::Isometry3d& pose)
{
  std::vector<double> numbers;
  std::string problem = readNumbers (line, numbers);
  if (!problem.empty())
    return problem;
  if (numbers.size() == numbers_with_quaternion)
    problem = fromQuaternion (numbers, pose);
  else if (numbers.size() == numbers_of_matrix)
    problem = fromMatrix (numbers, pose);
  else if (numbers.size() > numbers_of_matrix)
    return "has more than 12 numbers";
  else
    return "has " + std::to_string (numbers.size()) +
           (numbers.size() == 1 ? " number, a time, which is not needed" : " numbers");
  // No sensor moves so far, and much farther away doubles do not resolve millimeters.
  constexpr double max_coordinate = 1e9; // [m]
  if (problem.empty() && !(pose.translation().cwiseAbs().maxCoeff() <= max_coordinate))
    return "has a position more than 1e9 m from zero";
  return problem;
}

/** \brief Whether a line is empty or a comment. */
bool
isWithoutPose (const std::string& line)
{
  const std::size_t first = line.find_first_not_of (" \t\r");
  return first == std::string::npos || line[first] == '#';
}

/** \brief Sets the transform of \ref loadCalibration.
 * \param[in] text of the line behind its key
 * \return what is wrong with the text; empty if nothing is */
std::string
readCalibration (const std::string& text, Eigen::Isometry3d& lidar_to_camera)
{
  std::vector<double> numbers;
  const std::string problem = readNumbers (text, numbers);
  if (!problem.empty())
    return problem;
  if (numbers.size() != numbers_of_matrix)
    return "has " + std::to_string (numbers.size()) + " numbers";
  return fromMatrix (numbers, lidar_to_camera);
}

} // namespace

std::vector<Eigen::Isometry3d>
loadPoses (const std::string& file)
{
  std::istringstream lines (readTextFile (file, "a text file of poses"));
  std::vector<Eigen::Isometry3d> poses;
  std::size_t line_number = 0;
  for (std::string line; std::getline (lines, line);) {
    ++line_number;
    if (isWithoutPose (line))
      continue;
    const std::string problem = readPose (line, poses.emplace_back());
    if (!problem.empty())
      throw WorkError (file,
                       "line " + std::to_string (line_number) + " " + problem +
                           "; it has to be " + line_format +
                           " or the 12 numbers of KITTI");
  }
  return poses;
}

bool
lookLikeCameraOfKitti (const std::string& file,
                       const std::vector<Eigen::Isometry3d>& poses)
{
  std::istringstream lines (readTextFile (file, "a text file of poses"));
  std::string line;
  while (std::getline (lines, line) && isWithoutPose (line))
    ;
  std::vector<double> numbers;
  if (!readNumbers (line, numbers).empty() || numbers.size() != numbers_of_matrix)
    return false;
  // How far the camera moves along each of its axes, back and forth added up.
  Eigen::Vector3d path = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i + 1 < poses.size(); ++i)
    path += (poses[i].inverse() * poses[i + 1]).translation().cwiseAbs();
  return path.z() >= path.x() && path.z() >= path.y();
}

Eigen::Isometry3d
loadCalibration (const std::string& file)
{
  std::istringstream lines (readTextFile (file, "a calib.txt of KITTI"));
  for (std::string line; std::getline (lines, line);)
    for (const std::string key : {"Tr:", "Tr_velo_to_cam:"}) {
      if (line.rfind (key, 0) != 0)
        continue;
      Eigen::Isometry3d lidar_to_camera;
      const std::string problem =
          readCalibration (line.substr (key.size()), lidar_to_camera);
      if (!problem.empty())
        throw WorkError (
            file, "the line " + key + " " + problem + "; give KITTI's, of 12 numbers");
      return lidar_to_camera;
    }
  throw WorkError (file, "has no line Tr: of 12 numbers; give a calib.txt of KITTI");
}

void
savePoses (const std::string& file, const std::vector<Eigen::Isometry3d>& poses)
{
  constexpr double period = 0.1; // [s]
  constexpr int period_decimals = 1, pose_decimals = 9;
  std::ostringstream text;
  text << "# " << line_format << "\n" << std::fixed;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d position = poses[i].translation();
    const Eigen::Quaterniond q (poses[i].linear());
    text << std::setprecision (period_decimals) << period * static_cast<double> (i)
         << std::setprecision (pose_decimals);
    for (const double number :
         {position.x(), position.y(), position.z(), q.x(), q.y(), q.z(), q.w()})
      text << ' ' << number;
    text << "\n";
  }
  writeTextFile (file, text.str());
}

} // namespace pcl_ops::apps
