// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include <algorithm>

namespace pcl_ops::simulation {

namespace {

using Eigen::AlignedBox2d;
using Eigen::AlignedBox2i;

/** A rectangle, or for a gable wall a pentagon that narrows above the shoulders. */
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

bool
covers (const House& house, const Vector3d& point)
{
  const Vector3d local = house.pose().inverse() * point;
  return std::abs (local.x()) < 0.5 * house.length &&
         std::abs (local.y()) < 0.5 * house.width;
}

std::vector<Facade>
facadesOf (const Survey& survey)
{
  std::vector<Facade> facades;
  for (const House& house : survey.houses) {
    const auto corner = [&] (double x, double y, double z) -> Vector3d {
      return house.pose() * Vector3d (0.5 * x * house.length, 0.5 * y * house.width, z);
    };
    const auto add = [&] (const Vector3d& left,
                          const Vector3d& right,
                          const Vector3d& top,
                          double shoulders = 1.0) {
      facades.push_back (
          {makeRectangle (0.5 * (right + top), right - left, top - left), shoulders});
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
  facades.push_back (
      {makeRectangle ({0, 0, 0}, {width, 0, 0}, {0, width, 0}), 1.0, 0.5});
  return facades;
}

/** Points per square meter of a surface. */
constexpr double density = 30.0;
/** Distances between terraces across and along the streets [m]. */
constexpr double street_pitch = 44.0, terrace_pitch = 170.0;
constexpr double width_of_house = 15.0;
/** Half the length of the longest terrace and the largest shift [m]. */
constexpr double reach_of_terrace = 90.0;
constexpr double edge_of_patch = 8.0; // [m]
/** More sides than any terrace has. */
constexpr std::uint32_t sides_of_terrace = 20;

/** Integer place in the lattice of terraces or of ground patches. */
using Place = Eigen::Vector2i;

/** A rectangle, given by a corner and two edges at right angles [m]. */
struct Side {
  Vector3d corner, along, up;
};

/** \param[in] what 0: the terrace; number of one of its sides; higher: the ground */
Random
randomAt (Seed seed, const Place& place, std::uint32_t what)
{
  const auto x = std::uint32_t (place.x());
  const auto y = std::uint32_t (place.y());
  return Random (std::seed_seq{seed, std::uint32_t (Purpose::Town), x, y, what});
}

/** Returns front and back wall, roof slopes, the floor of the upper story, and the
 * walls beside each house, in the frame of the streets. */
std::vector<Side>
terraceAt (Seed seed, const Place& place)
{
  Random random = randomAt (seed, place, 0);
  const auto houses = int (random.between (7, 11));
  const double length = houses * width_of_house;
  const double depth = random.between (9, 12);
  const double eaves = random.between (5, 8);
  const double ridge = eaves + random.between (2, 4);
  const double x = terrace_pitch * place.x() + random.between (-4, 4);
  const double y = street_pitch * place.y() + random.between (-4, 4);
  const Isometry3d pose = at ({x, y, 0}) * turnZ (random.angle (-3, 3));
  const auto corner = [&] (double u, double v, double z) -> Vector3d {
    return pose * Vector3d (u - 0.5 * length, v - 0.5 * depth, z);
  };
  const Vector3d along = pose.linear() * Vector3d (length, 0, 0);
  const Vector3d across = pose.linear() * Vector3d (0, depth, 0);
  const Vector3d up (0, 0, eaves);
  const Vector3d top = corner (0, 0.5 * depth, ridge);
  std::vector<Side> sides = {
      {corner (0, 0, 0), along, up},
      {corner (0, depth, 0), along, up},
      {corner (0, 0, eaves), along, top - corner (0, 0, eaves)},
      {corner (0, depth, eaves), along, top - corner (0, depth, eaves)},
      {corner (0, 0, 0.5 * eaves), along, across}};
  for (int wall = 0; wall <= houses; ++wall)
    sides.push_back ({corner (wall * width_of_house, 0, 0), across, up});
  return sides;
}

/** Rotation from the frame of the streets to the frame of the tiles. */
const Eigen::Matrix3d streets_to_tiles = turnZ (12.0 * pi / 180.0).linear();

/** Returns the lattice places, in the frame of the streets, from which a terrace or a
 * patch may reach into a square.
 * \param[in] square in the frame of the tiles [m] */
AlignedBox2i
placesAround (const AlignedBox2d& square, const Vector2d& pitch, double margin)
{
  const Eigen::Matrix2d to_streets = streets_to_tiles.topLeftCorner<2, 2>().transpose();
  AlignedBox2d around;
  for (int corner = 0; corner < 4; ++corner)
    around.extend (to_streets * square.corner (AlignedBox2d::CornerType (corner)));
  const Eigen::Array2d low = (around.min().array() - margin) / pitch.array();
  const Eigen::Array2d high = (around.max().array() + margin) / pitch.array();
  return {low.floor().cast<int>().matrix(), high.ceil().cast<int>().matrix()};
}

/** Collects the points of a tile from all patches that reach into it. */
struct TileSurvey {
  const Town& town;
  AlignedBox2d tile;
  double sigma;
  std::vector<TownPoint> points = {};

  void
  addSide (const Side& side, Random& seeds, std::uint32_t label)
  {
    const auto columns = int (std::ceil (side.along.norm() / edge_of_patch));
    const auto rows = int (std::ceil (side.up.norm() / edge_of_patch));
    const Vector3d along = side.along / columns;
    const Vector3d up = side.up / rows;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        addPatch ({side.corner + column * along + row * up, along, up},
                  Random (seeds.bits()),
                  label);
  }

  Vector3d
  placeOn (const Side& patch, double u, double v) const
  {
    return streets_to_tiles * (patch.corner + u * patch.along + v * patch.up);
  }

  void
  addPatch (const Side& patch, Random random, std::uint32_t label)
  {
    AlignedBox2d around;
    for (const int u : {0, 1})
      for (const int v : {0, 1})
        around.extend (Vector2d (placeOn (patch, u, v).head<2>()));
    if (around.squaredExteriorDistance (tile) > 100.0 * sigma * sigma)
      return;
    const auto wanted =
        std::size_t (density * patch.along.norm() * patch.up.norm() + random.unit());
    for (std::size_t i = 0; i < wanted; ++i) {
      const double u = random.unit();
      const double v = random.unit();
      Vector3d point = placeOn (patch, u, v);
      for (double& coordinate : point)
        coordinate += sigma * random.gaussian();
      const auto in_tile = point.head<2>().array();
      if ((in_tile >= tile.min().array()).all() && (in_tile < tile.max().array()).all())
        points.push_back ({town.corner + point, label});
    }
  }
};

} // namespace

Survey
makeSurvey (Seed seed)
{
  constexpr double width_of_lot = 30.0; // edge of the ground around a house [m]
  constexpr int lots_in_a_row = 6;
  Random random = randomFor (Purpose::Survey, seed);
  Survey survey;
  survey.width = lots_in_a_row * width_of_lot;
  const double first = 0.5 * (width_of_lot - survey.width);
  for (int i = 0; i < lots_in_a_row * lots_in_a_row; ++i) {
    House& house = survey.houses.emplace_back();
    const int column = i % lots_in_a_row;
    const int row = i / lots_in_a_row;
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

Town
makeTown (Seed seed, double points, double tiles)
{
  // Surveyed surface per square meter of ground, walls and roofs included [m^2].
  constexpr double surface_of_square_meter = 1.65;
  Town town;
  town.seed = seed;
  town.tiles = std::uint32_t (std::ceil (std::sqrt (tiles)));
  const double area = points / (density * surface_of_square_meter);
  town.tile = std::sqrt (area) / town.tiles;
  return town;
}

std::vector<TownPoint>
surveyTile (const Town& town, std::uint32_t column, std::uint32_t row, double noise)
{
  const auto squareOf = [&town] (double x, double y, double edge) {
    const Vector2d corner (x * town.tile, y * town.tile);
    return AlignedBox2d (corner, corner + Vector2d::Constant (edge));
  };
  TileSurvey survey{town, squareOf (column, row, town.tile), noise * survey_sigma};
  const auto forEachPlace =
      [&survey] (const Vector2d& pitch, double margin, const auto& visit) {
        const AlignedBox2i places = placesAround (survey.tile, pitch, margin);
        for (int y = places.min().y(); y <= places.max().y(); ++y)
          for (int x = places.min().x(); x <= places.max().x(); ++x)
            visit (Place (x, y));
      };
  const double edge = edge_of_patch;
  forEachPlace ({edge, edge}, edge, [&] (const Place& place) {
    survey.addPatch (
        {{edge * place.x(), edge * place.y(), 0}, {edge, 0, 0}, {0, edge, 0}},
        randomAt (town.seed, place, sides_of_terrace + 1),
        1);
  });
  const Vector2d pitch (terrace_pitch, street_pitch);
  const AlignedBox2i all =
      placesAround (squareOf (0, 0, town.tiles * town.tile), pitch, reach_of_terrace);
  forEachPlace (pitch, reach_of_terrace, [&] (const Place& place) {
    const Place from_first = place - all.min();
    const auto number =
        std::uint32_t (from_first.y() * (all.sizes().x() + 1) + from_first.x());
    std::uint32_t side_number = 0;
    for (const Side& side : terraceAt (town.seed, place)) {
      Random seeds = randomAt (town.seed, place, ++side_number);
      survey.addSide (side, seeds, 1 + number * sides_of_terrace + side_number);
    }
  });
  return std::move (survey.points);
}

} // namespace pcl_ops::simulation
