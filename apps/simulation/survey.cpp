// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::simulation {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/** \brief A rectangle, or with a gable the pentagon in it that narrows evenly above the
 * shoulders to a point. */
struct Facade {
  Shape rectangle;
  /** \brief Height of the shoulders as a share of the rectangle's; 1 without a gable.
   */
  double shoulders = 1.0;
  /** \brief Of its points, relative to walls and roofs. */
  double density = 1.0;
};

Isometry3d
poseOf (const House& house)
{
  return Eigen::Translation3d (house.center) * turnZ (house.yaw);
}

bool
covers (const House& house, const Vector3d& point)
{
  const Vector3d local = poseOf (house).inverse() * point;
  return std::abs (local.x()) < 0.5 * house.length &&
         std::abs (local.y()) < 0.5 * house.width;
}

/** \brief The rectangle with a lower edge from \p left to \p right and an upper edge
 * that begins at \p top. */
Shape
rectangleOn (const Vector3d& left, const Vector3d& right, const Vector3d& top)
{
  return {Shape::Kind::Rectangle,
          0.5 * (right + top),
          (right - left).normalized(),
          (top - left).normalized(),
          0.5 * (right - left).norm(),
          0.5 * (top - left).norm()};
}

/** \brief Adds walls and slopes of a house, \ref planes_of_house. */
void
addFacades (std::vector<Facade>& facades, const House& house)
{
  const Isometry3d pose = poseOf (house);
  const auto corner = [&] (double x, double y, double z) -> Vector3d {
    return pose * Vector3d (0.5 * x * house.length, 0.5 * y * house.width, z);
  };
  const double eaves = house.eaves, ridge = house.ridge;
  for (const int side : {-1, 1}) {
    facades.push_back ({rectangleOn (
        corner (-1, side, 0), corner (1, side, 0), corner (-1, side, eaves))});
    facades.push_back ({rectangleOn (corner (side, -1, 0),
                                     corner (side, 1, 0),
                                     corner (side, -1, ridge)),
                        eaves / ridge});
    facades.push_back ({rectangleOn (
        corner (-1, side, eaves), corner (1, side, eaves), corner (-1, 0, ridge))});
  }
}

/** \brief Walls and slopes of all houses, then the ground, with surfaces from 1. */
std::vector<Facade>
facadesOf (const Survey& survey)
{
  std::vector<Facade> facades;
  for (const House& house : survey.houses)
    addFacades (facades, house);
  const double half_width = 0.5 * survey.width;
  facades.push_back (
      {rectangleAlong (0, 1, {0, 0, 0}, half_width, half_width), 1.0, 0.5});
  for (std::size_t i = 0; i < facades.size(); ++i)
    facades[i].rectangle.surface = SurfaceId (i + 1);
  return facades;
}

/** \brief Whether a point of its rectangle is none of air beside a gable. */
bool
isOn (const Facade& facade, const Vector3d& point)
{
  const Shape& rectangle = facade.rectangle;
  const Vector3d local = point - rectangle.center;
  const double aside = std::abs (local.dot (rectangle.u)) / rectangle.half_u;
  const double height = 0.5 * (1.0 + local.dot (rectangle.v) / rectangle.half_v);
  return height <= facade.shoulders ||
         aside <= (1.0 - height) / (1.0 - facade.shoulders);
}

House
drawHouse (const Vector3d& middle_of_lot, Random& random)
{
  House house;
  house.center = middle_of_lot;
  house.center.x() += random.between (-4, 4);
  house.center.y() += random.between (-4, 4);
  house.yaw = random.angle (0, 180);
  house.length = random.between (12, 18);
  house.width = random.between (9, 13);
  house.eaves = random.between (4, 7);
  house.ridge = house.eaves + random.between (2, 5);
  return house;
}

} // namespace

Survey
makeSurvey (std::uint32_t seed, std::size_t houses)
{
  constexpr double width_of_lot = 30.0; // the ground each house has for itself [m]
  Random random = randomFor (Purpose::Survey, seed);
  const auto lots_in_a_row = std::size_t (std::ceil (std::sqrt (double (houses))));
  Survey survey;
  survey.width = double (lots_in_a_row) * width_of_lot;
  const double first = 0.5 * (width_of_lot - survey.width);
  for (std::size_t i = 0; i < houses; ++i) {
    const double column = double (i % lots_in_a_row), row = double (i / lots_in_a_row);
    survey.houses.push_back (drawHouse (
        {first + column * width_of_lot, first + row * width_of_lot, 0.0}, random));
  }
  return survey;
}

SimulatedCloud
scanSurvey (const Survey& survey,
            std::size_t points,
            double noise_scale,
            std::uint32_t seed)
{
  if (survey.houses.empty())
    return {};
  LabeledCloud cloud;
  const std::vector<Facade> facades = facadesOf (survey);
  const Facade& ground = facades.back();
  std::vector<Plane> planes;
  std::vector<double> weights; // running total of area times density
  for (const Facade& facade : facades) {
    planes.push_back (facade.rectangle.plane());
    weights.push_back ((weights.empty() ? 0.0 : weights.back()) +
                       facade.rectangle.area() * facade.density);
  }
  Random random = randomFor (Purpose::SurveyScan, seed);
  cloud.reserve (points);
  while (cloud.size() < points) {
    const double drawn = random.between (0.0, weights.back());
    const auto found = std::upper_bound (weights.begin(), weights.end() - 1, drawn);
    const Facade& facade = facades[std::size_t (found - weights.begin())];
    Vector3d point = drawPoint (facade.rectangle, random).position;
    const auto coversPoint = [&point] (const House& house) {
      return covers (house, point);
    };
    if (&facade == &ground
            ? std::any_of (survey.houses.begin(), survey.houses.end(), coversPoint)
            : !isOn (facade, point))
      continue;
    for (double& coordinate : point)
      coordinate += noise_scale * survey_sigma * random.gaussian();
    cloud.push_back (pointAt (point, facade.rectangle.surface));
  }
  return labeledBySize (cloud, planes);
}

} // namespace pcl_ops::simulation
