// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey.h"

#include "poses.h"
#include "surface_points.h"

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

/** \brief Edge of the ground each house has for itself [m]. */
constexpr double width_of_lot = 30.0;
constexpr double density_of_ground = 0.5;

/** \brief A rectangle, or with a gable the pentagon in it that narrows evenly above the
 * shoulders to a point. */
struct Facade {
  Rectangle rectangle;
  /** \brief Height of the shoulders as a share of the rectangle's; 1 without a gable.
   */
  double shoulders = 1.0;
};

Eigen::Isometry3d
poseOf (const House& house)
{
  return Eigen::Translation3d (house.center) * turned (house.yaw, Vector3d::UnitZ());
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
Rectangle
rectangleOn (const Vector3d& left, const Vector3d& right, const Vector3d& top)
{
  Rectangle rectangle;
  rectangle.center = 0.5 * (right + top);
  rectangle.axis_u = (right - left).normalized();
  rectangle.axis_v = (top - left).normalized();
  rectangle.half_u = 0.5 * (right - left).norm();
  rectangle.half_v = 0.5 * (top - left).norm();
  return rectangle;
}

/** \brief Walls and slopes of a house, \ref planes_of_house, without surfaces. */
std::vector<Facade>
facadesOf (const House& house)
{
  const Eigen::Isometry3d pose = poseOf (house);
  const auto corner = [&] (double x, double y, double z) -> Vector3d {
    return pose * Vector3d (0.5 * x * house.length, 0.5 * y * house.width, z);
  };
  const double eaves = house.eaves, ridge = house.ridge;
  std::vector<Facade> facades;
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
  return facades;
}

/** \brief Walls and slopes of all houses, then the ground, with surfaces from 1. */
std::vector<Facade>
facadesOf (const Survey& survey)
{
  std::vector<Facade> facades;
  for (const House& house : survey.houses)
    for (const Facade& facade : facadesOf (house))
      facades.push_back (facade);
  Rectangle ground;
  ground.half_u = ground.half_v = 0.5 * survey.width;
  facades.push_back ({ground});
  for (std::size_t i = 0; i < facades.size(); ++i)
    facades[i].rectangle.surface = SurfaceId (i + 1);
  return facades;
}

/** \brief Draws points of a survey one by one. */
class Surveyor {
public:
  Surveyor (const Survey& survey, internal::RandomGenerator& generator)
  : survey_ (survey), facades_ (facadesOf (survey)), generator_ (generator)
  {
    double weight_so_far = 0.0;
    for (const Facade& facade : facades_) {
      const bool is_ground = &facade == &facades_.back();
      weight_so_far += facade.rectangle.area() * (is_ground ? density_of_ground : 1.0);
      weights_.push_back (weight_so_far);
    }
  }

  pcl::PointXYZL
  draw (double sigma)
  {
    for (;;) {
      const Facade& facade = drawFacade();
      const Vector3d exact = drawPoint (facade.rectangle, generator_).position;
      if (!isOn (facade, exact))
        continue;
      pcl::PointXYZL point;
      point.label = facade.rectangle.surface;
      for (int axis = 0; axis < 3; ++axis)
        point.data[axis] = float (exact[axis] + sigma * drawGaussian (generator_));
      return point;
    }
  }

  std::vector<Plane>
  planes () const
  {
    std::vector<Plane> planes;
    for (const Facade& facade : facades_)
      planes.push_back (
          planeThrough (facade.rectangle.center, facade.rectangle.normal()));
    return planes;
  }

private:
  const Facade&
  drawFacade ()
  {
    const double drawn = drawBetween (generator_, 0.0, weights_.back());
    const auto found = std::upper_bound (weights_.begin(), weights_.end() - 1, drawn);
    return facades_[std::size_t (found - weights_.begin())];
  }

  /** \brief Whether a point of its rectangle is none of air beside a gable or of ground
   * below a house. */
  bool
  isOn (const Facade& facade, const Vector3d& point) const
  {
    if (&facade == &facades_.back())
      return std::none_of (
          survey_.houses.begin(), survey_.houses.end(), [&point] (const House& house) {
            return covers (house, point);
          });
    const Rectangle& rectangle = facade.rectangle;
    const Vector3d local = point - rectangle.center;
    const double aside = std::abs (local.dot (rectangle.axis_u)) / rectangle.half_u;
    const double height = 0.5 * (1.0 + local.dot (rectangle.axis_v) / rectangle.half_v);
    return height <= facade.shoulders ||
           aside <= (1.0 - height) / (1.0 - facade.shoulders);
  }

  const Survey& survey_;
  std::vector<Facade> facades_;
  internal::RandomGenerator& generator_;
  /** \brief Running total of area times density. */
  std::vector<double> weights_;
};

House
drawHouse (const Vector3d& middle_of_lot, internal::RandomGenerator& generator)
{
  House house;
  house.center = middle_of_lot;
  house.center.x() += drawBetween (generator, -4, 4);
  house.center.y() += drawBetween (generator, -4, 4);
  house.yaw = drawAngle (generator, 0, 180);
  house.length = drawBetween (generator, 12, 18);
  house.width = drawBetween (generator, 9, 13);
  house.eaves = drawBetween (generator, 4, 7);
  house.ridge = house.eaves + drawBetween (generator, 2, 5);
  return house;
}

} // namespace

Survey
makeSurvey (std::uint32_t seed, std::size_t houses)
{
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::Survey);
  const auto lots_in_a_row = std::size_t (std::ceil (std::sqrt (double (houses))));
  Survey survey;
  survey.width = double (lots_in_a_row) * width_of_lot;
  const double first = 0.5 * (width_of_lot - survey.width);
  for (std::size_t i = 0; i < houses; ++i) {
    const double column = double (i % lots_in_a_row), row = double (i / lots_in_a_row);
    const Vector3d middle_of_lot (
        first + column * width_of_lot, first + row * width_of_lot, 0.0);
    survey.houses.push_back (drawHouse (middle_of_lot, generator));
  }
  return survey;
}

SimulatedCloud
scanSurvey (const Survey& survey,
            std::size_t points,
            double noise_scale,
            std::uint32_t seed)
{
  SimulatedCloud simulated;
  if (survey.houses.empty())
    return simulated;
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::SurveyScan);
  Surveyor surveyor (survey, generator);
  simulated.cloud.reserve (points);
  for (std::size_t i = 0; i < points; ++i)
    simulated.cloud.push_back (surveyor.draw (noise_scale * survey_sigma));
  simulated.planes = labelBySize (simulated.cloud, surveyor.planes());
  return simulated;
}

} // namespace pcl_ops::simulation
