// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_damage.h"

#include <pcl/common/point_tests.h>

#include <Eigen/Geometry>

#include "median_place.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace pcl_ops::apps {

namespace {

using Places = std::vector<Eigen::Vector3d>;

/** \brief Points spread over a cloud, those without coordinates left out. */
Places
someOf (const XyzCloud& cloud)
{
  constexpr std::size_t most = 4096;
  const std::size_t step = std::max<std::size_t> (1, cloud.size() / most);
  Places places;
  for (std::size_t i = 0; i < cloud.size(); i += step)
    if (pcl::isXYZFinite (cloud[i]))
      places.push_back (cloud[i].getVector3fMap().cast<double>());
  return places;
}

/** \brief The place that most points share, and how many do. */
std::pair<Eigen::Vector3d, std::size_t>
mostSharedPlace (Places places)
{
  std::sort (places.begin(), places.end(), [] (const auto& first, const auto& second) {
    return std::lexicographical_compare (
        first.data(), first.data() + 3, second.data(), second.data() + 3);
  });
  std::pair<Eigen::Vector3d, std::size_t> shared (Eigen::Vector3d::Zero(), 0);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] != places[begin])
      begin = i;
    if (i - begin + 1 > shared.second)
      shared = {places[i], i - begin + 1};
  }
  return shared;
}

/** \brief How many are beyond a thousand diagonals of all that are nearer to the
 * middle, if these are the larger half. */
std::size_t
countFar (Places places)
{
  constexpr double max_diagonals = 1000.0;
  const Eigen::Vector3d middle = medianPlace (places);
  std::sort (places.begin(), places.end(), [&] (const auto& first, const auto& second) {
    return (first - middle).squaredNorm() < (second - middle).squaredNorm();
  });
  Eigen::AlignedBox3d rest;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_beyond =
        2 * i > places.size() && rest.diagonal().norm() > 0.0 &&
        (places[i] - middle).norm() > max_diagonals * rest.diagonal().norm();
    if (is_beyond)
      return places.size() - i;
    rest.extend (places[i]);
  }
  return 0;
}

std::string
rounded (double number, int digits)
{
  std::ostringstream text;
  text.precision (digits);
  text << number;
  return text.str();
}

std::string
coordinate (double number)
{
  constexpr int digits = 10; // millimeters of UTM
  return rounded (number, digits);
}

std::string
perCent (std::size_t count, std::size_t all)
{
  constexpr double hundred = 100.0, nearly_all = 99.5;
  const double share =
      hundred * static_cast<double> (count) / static_cast<double> (all);
  return rounded (share, share < nearly_all ? 2 : 3);
}

} // namespace

std::string
damageOf (const ShiftedCloud& shifted)
{
  // Of fewer, a share says nothing.
  constexpr std::size_t min_places = 10;
  // One per cent, and room for what a sample may miss of it.
  constexpr double far_share = 0.005;
  const Places places = someOf (*shifted.cloud);
  if (places.size() < min_places)
    return "";
  const auto [shared_place, shared] = mostSharedPlace (places);
  const Eigen::Vector3d place = shared_place + shifted.shift;
  const std::size_t far = countFar (places);
  if (2 * shared > places.size())
    return "looks damaged: " + perCent (shared, places.size()) +
           " % of its points are at (" + coordinate (place.x()) + ", " +
           coordinate (place.y()) + ", " + coordinate (place.z()) +
           "); leave missing readings out or write them as NaN";
  if (static_cast<double> (far) > far_share * static_cast<double> (places.size()))
    return "looks damaged: " + perCent (far, places.size()) +
           " % of its points are more than 1000 times as far away as the rest is wide; "
           "leave them out";
  return "";
}

} // namespace pcl_ops::apps
