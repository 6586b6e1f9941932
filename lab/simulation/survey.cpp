// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey.h"

#include <algorithm>

namespace pcl_ops::simulation {

namespace {

/** A wall, a side of a roof or the ground: a rectangle. A gable wall is a pentagon, the
 * part of its rectangle below the two slopes of the roof. */
struct SurveyedFace {
  Shape rectangle;
  /** Height at which the slopes of a gable wall begin, as a share of the rectangle's
   * height. */
  double eaves_share = 1.0;
  double density = 1.0; // of points, relative to that of walls and roofs

  /** Whether a point of the rectangle is on the face. */
  bool
  contains (const Vector3d& point) const
  {
    const Vector3d local = point - rectangle.center;
    // From 0 in the middle to 1 at the sides, and from 0 at the foot to 1 at the top.
    const double aside = std::abs (local.dot (rectangle.u)) / rectangle.half_u;
    const double height = 0.5 * (1.0 + local.dot (rectangle.v) / rectangle.half_v);
    return height <= eaves_share || aside <= (1.0 - height) / (1.0 - eaves_share);
  }
};

bool
isBelowAHouse (const Survey& survey, const Vector3d& point)
{
  return std::any_of (
      survey.houses.begin(), survey.houses.end(), [&point] (const House& house) {
        const Vector3d local = house.pose().inverse() * point;
        return std::abs (local.x()) < 0.5 * house.length &&
               std::abs (local.y()) < 0.5 * house.width;
      });
}

/** Returns the walls and roofs of all houses; the last face is the ground. */
std::vector<SurveyedFace>
surveyedFacesOf (const Survey& survey)
{
  constexpr double density_of_ground = 0.5;
  std::vector<SurveyedFace> faces;
  for (const House& house : survey.houses) {
    // x and y are -1 or 1 at the walls.
    const auto corner = [&] (double x, double y, double z) -> Vector3d {
      return house.pose() * Vector3d (0.5 * x * house.length, 0.5 * y * house.width, z);
    };
    // Adds the face whose rectangle has these corners: lower left, lower right, and
    // upper left.
    const auto add = [&] (const Vector3d& left,
                          const Vector3d& right,
                          const Vector3d& top,
                          double eaves_share = 1.0) {
      faces.push_back (
          {makeRectangle (0.5 * (right + top), right - left, top - left), eaves_share});
    };
    const double eaves = house.eaves;
    const double ridge = house.ridge;
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
  SurveyedFace ground{makeRectangle ({0, 0, 0}, {width, 0, 0}, {0, width, 0})};
  ground.density = density_of_ground;
  faces.push_back (ground);
  return faces;
}

} // namespace

Survey
makeSurvey (Seed seed)
{
  constexpr double width_of_lot = 30.0; // edge of the ground around a house [m]
  constexpr int lots_in_a_row = 6;
  Random random = randomFor (Purpose::Survey, seed);
  Survey survey;
  survey.width = lots_in_a_row * width_of_lot;
  // x and y of the middle of the first lot [m].
  const double first = 0.5 * (width_of_lot - survey.width);
  for (int i = 0; i < lots_in_a_row * lots_in_a_row; ++i) {
    House& house = survey.houses.emplace_back();
    const int column = i % lots_in_a_row;
    const int row = i / lots_in_a_row;
    // Positions, angles [degree] and lengths [m] within common ranges.
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
  const std::vector<SurveyedFace> faces = surveyedFacesOf (survey);
  std::vector<Plane> planes;
  // Sums of area times density over the faces up to each one, itself included.
  std::vector<double> running_weights;
  double weight = 0.0;
  for (const SurveyedFace& face : faces) {
    planes.push_back (face.rectangle.plane());
    weight += face.rectangle.area() * face.density;
    running_weights.push_back (weight);
  }
  Random random = randomFor (Purpose::SurveyScan, seed);
  LabeledCloud cloud;
  cloud.reserve (points);
  while (cloud.size() < points) {
    const double drawn = random.between (0.0, weight);
    const auto first = running_weights.begin();
    // Without the last sum: a number above the others means the last face, the ground.
    const auto last = running_weights.end() - 1;
    const auto index = std::size_t (std::upper_bound (first, last, drawn) - first);
    Vector3d point = drawPoint (faces[index].rectangle, random).position;
    const bool is_ground = index == faces.size() - 1;
    if (is_ground && isBelowAHouse (survey, point))
      continue;
    if (!is_ground && !faces[index].contains (point))
      continue;
    for (double& coordinate : point)
      coordinate += noise * survey_sigma * random.gaussian();
    cloud.push_back (pointAt (point, SurfaceId (index + 1)));
  }
  return labeledBySize (cloud, planes);
}

} // namespace pcl_ops::simulation
