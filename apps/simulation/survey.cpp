// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include <algorithm>

namespace pcl_ops::simulation {

namespace {

/** A rectangle, or with a gable the pentagon in it above the shoulders. */
struct Facade {
  Shape rectangle;
  double shoulders = 1.0; // their height as a share of the rectangle's
  double density = 1.0;   // of its points, relative to walls and roofs

  bool
  has (const Vector3d& point) const
  {
    const Vector3d local = point - rectangle.center;
    const double aside = std::abs (local.dot (rectangle.u)) / rectangle.half_u;
    const double height = 0.5 * (1.0 + local.dot (rectangle.v) / rectangle.half_v);
    return height <= shoulders || aside <= (1.0 - height) / (1.0 - shoulders);
  }
};

Isometry3d
poseOf (const House& house)
{
  return at (house.center) * turnZ (house.yaw);
}

bool
covers (const House& house, const Vector3d& point)
{
  const Vector3d local = poseOf (house).inverse() * point;
  return std::abs (local.x()) < 0.5 * house.length &&
         std::abs (local.y()) < 0.5 * house.width;
}

std::vector<Facade>
facadesOf (const Survey& survey)
{
  std::vector<Facade> facades;
  for (const House& house : survey.houses) {
    const auto corner = [&] (double x, double y, double z) -> Vector3d {
      return poseOf (house) *
             Vector3d (0.5 * x * house.length, 0.5 * y * house.width, z);
    };
    const auto add = [&] (const Vector3d& left,
                          const Vector3d& right,
                          const Vector3d& top,
                          double shoulders = 1.0) {
      facades.push_back (
          {makeRectangle (0.5 * (right + top), right - left, top - left), shoulders});
    };
    const double eaves = house.eaves, ridge = house.ridge;
    for (const int side : {-1, 1}) {
      add (corner (-1, side, 0), corner (1, side, 0), corner (-1, side, eaves));
      add (corner (side, -1, 0),
           corner (side, 1, 0),
           corner (side, -1, ridge),
           eaves / ridge);
      add (corner (-1, side, eaves), corner (1, side, eaves), corner (-1, 0, ridge));
    }
  }
  const double width = survey.width;
  facades.push_back (
      {makeRectangle ({0, 0, 0}, {width, 0, 0}, {0, width, 0}), 1.0, 0.5});
  return facades;
}

} // namespace

Survey
makeSurvey (Seed seed)
{
  constexpr double width_of_lot = 30.0; // the ground each house has for itself [m]
  constexpr int lots_in_a_row = 6;
  Random random = randomFor (Purpose::Survey, seed);
  Survey survey;
  survey.width = lots_in_a_row * width_of_lot;
  const double first = 0.5 * (width_of_lot - survey.width);
  for (int i = 0; i < lots_in_a_row * lots_in_a_row; ++i) {
    House& house = survey.houses.emplace_back();
    const int column = i % lots_in_a_row, row = i / lots_in_a_row;
    house.center.x() = first + column * width_of_lot + random.between (-4, 4);
    house.center.y() = first + row * width_of_lot + random.between (-4, 4);
    house.yaw = random.angle (0, 180);
    house.length = random.between (12, 18);
    house.width = random.between (9, 13);
    house.eaves = random.between (4, 7);
    house.ridge = house.eaves + random.between (2, 5);
  }
  return survey;
}

SimulatedCloud
scanSurvey (const Survey& survey, std::size_t points, double noise, Seed seed)
{
  const std::vector<Facade> facades = facadesOf (survey);
  std::vector<Plane> planes;
  std::vector<double> weights; // running total of area times density
  double weight = 0.0;
  for (const Facade& facade : facades) {
    planes.push_back (facade.rectangle.plane());
    weights.push_back (weight += facade.rectangle.area() * facade.density);
  }
  Random random = randomFor (Purpose::SurveyScan, seed);
  LabeledCloud cloud;
  cloud.reserve (points);
  while (cloud.size() < points) {
    const double drawn = random.between (0.0, weight);
    const auto index = std::size_t (
        std::upper_bound (weights.begin(), weights.end() - 1, drawn) - weights.begin());
    Vector3d point = drawPoint (facades[index].rectangle, random).position;
    const auto coversPoint = [&point] (const House& house) {
      return covers (house, point);
    };
    const bool is_ground = index == facades.size() - 1;
    if (is_ground
            ? std::any_of (survey.houses.begin(), survey.houses.end(), coversPoint)
            : !facades[index].has (point))
      continue;
    for (double& coordinate : point)
      coordinate += noise * survey_sigma * random.gaussian();
    cloud.push_back (pointAt (point, SurfaceId (index + 1)));
  }
  return labeledBySize (cloud, planes);
}

} // namespace pcl_ops::simulation
