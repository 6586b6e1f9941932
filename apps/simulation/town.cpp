// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "town.h"

#include "survey.h"

#include <cmath>

namespace pcl_ops::simulation {

namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/** \brief Points of a square meter of surface. */
constexpr double density = 30.0;
/** \brief Streets are so far apart, and terraces begin so far apart along them [m]. */
constexpr double street_pitch = 44.0, terrace_pitch = 170.0;
constexpr double width_of_house = 15.0;
/** \brief Of a terrace and all it may be shifted by, from its middle [m]. */
constexpr double reach_of_terrace = 90.0;
/** \brief Of what is surveyed of a square meter of ground, walls and roofs included. */
constexpr double surface_of_square_meter = 1.65;
constexpr double edge_of_patch = 8.0;
/** \brief Of streets against the borders of tiles [degree]. */
constexpr double direction_of_streets = 12.0;
/** \brief More than any terrace has. */
constexpr std::uint32_t sides_of_terrace = 20;

/** \brief A place on the lattice of terraces or of patches of the ground. */
using Place = Eigen::Vector2i;

/** \brief A rectangle from a corner along two sides that are at right angles. */
struct Side {
  Vector3d corner, along, up;
};

/** \param[in] what number of a side, 0: the terrace, beyond them: the ground */
Random
randomAt (std::uint32_t seed, const Place& place, std::uint32_t what)
{
  return Random (std::seed_seq{seed,
                               std::uint32_t (Purpose::Town),
                               std::uint32_t (place.x()),
                               std::uint32_t (place.y()),
                               what});
}

/** \brief Outer walls, slopes of the roof, the floor above the ground, and the walls
 * between houses, in the frame of the streets. */
std::vector<Side>
terraceAt (std::uint32_t seed, const Place& place)
{
  Random random = randomAt (seed, place, 0);
  const auto houses = int (random.between (7, 11));
  const double length = houses * width_of_house;
  const double depth = random.between (9, 12);
  const double eaves = random.between (5, 8);
  const double ridge = eaves + random.between (2, 4);
  const double x = terrace_pitch * place.x() + random.between (-4, 4);
  const double y = street_pitch * place.y() + random.between (-4, 4);
  const Eigen::Isometry3d pose =
      Eigen::Translation3d (x, y, 0) * turnZ (random.angle (-3, 3));
  const auto at = [&] (double u, double v, double z) -> Vector3d {
    return pose * Vector3d (u - 0.5 * length, v - 0.5 * depth, z);
  };
  const Vector3d along = pose.linear() * Vector3d (length, 0, 0);
  const Vector3d across = pose.linear() * Vector3d (0, depth, 0);
  const Vector3d up (0, 0, eaves), top = at (0, 0.5 * depth, ridge);
  std::vector<Side> sides = {{at (0, 0, 0), along, up},
                             {at (0, depth, 0), along, up},
                             {at (0, 0, eaves), along, top - at (0, 0, eaves)},
                             {at (0, depth, eaves), along, top - at (0, depth, eaves)},
                             {at (0, 0, 0.5 * eaves), along, across}};
  for (int wall = 0; wall <= houses; ++wall)
    sides.push_back ({at (wall * width_of_house, 0, 0), across, up});
  return sides;
}

/** \brief The square of so many tiles, and the places of a lattice in the frame of the
 * streets that may reach into it. */
struct Area {
  Eigen::Matrix3d turn = turnZ (direction_of_streets * pi / 180.0).linear();
  AlignedBox2d box;

  Area (const Vector2d& corner, double edge)
  : box (corner, corner + Vector2d::Constant (edge))
  {}

  Eigen::AlignedBox2i
  reach (const Vector2d& pitch, double margin) const
  {
    AlignedBox2d around;
    for (int corner = 0; corner < 4; ++corner) {
      const Vector2d place = box.corner (AlignedBox2d::CornerType (corner));
      around.extend (
          (turn.transpose() * Vector3d (place.x(), place.y(), 0)).head<2>().eval());
    }
    const Vector2d low = (around.min().array() - margin).matrix().cwiseQuotient (pitch);
    const Vector2d high =
        (around.max().array() + margin).matrix().cwiseQuotient (pitch);
    return {low.array().floor().cast<int>().matrix(),
            high.array().ceil().cast<int>().matrix()};
  }

  /** \brief Calls \p visit with each of these places, row by row. */
  template <typename Visit>
  void
  forEachPlace (const Vector2d& pitch, double margin, const Visit& visit) const
  {
    const Eigen::AlignedBox2i places = reach (pitch, margin);
    for (int row = places.min().y(); row <= places.max().y(); ++row)
      for (int column = places.min().x(); column <= places.max().x(); ++column)
        visit (Place (column, row));
  }
};

/** \brief Takes the points of a tile out of the patches that reach into it. */
struct TileSurvey {
  const Town& town;
  Area tile;
  double sigma;
  std::vector<TownPoint> points;

  void
  addSide (const Side& side, Random& seeds, std::uint32_t label)
  {
    const auto columns = int (std::ceil (side.along.norm() / edge_of_patch));
    const auto rows = int (std::ceil (side.up.norm() / edge_of_patch));
    const Vector3d along = side.along / columns, up = side.up / rows;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        addPatch ({side.corner + column * along + row * up, along, up},
                  Random (seeds.bits()),
                  label);
  }

  void
  addPatch (const Side& patch, Random random, std::uint32_t label)
  {
    AlignedBox2d around;
    for (const int u : {0, 1})
      for (const int v : {0, 1})
        around.extend ((tile.turn * (patch.corner + u * patch.along + v * patch.up))
                           .head<2>()
                           .eval());
    if (around.squaredExteriorDistance (tile.box) > 100.0 * sigma * sigma)
      return;
    const auto wanted =
        std::size_t (density * patch.along.norm() * patch.up.norm() + random.unit());
    for (std::size_t i = 0; i < wanted; ++i) {
      const double u = random.unit(), v = random.unit();
      Vector3d point = tile.turn * (patch.corner + u * patch.along + v * patch.up);
      for (double& coordinate : point)
        coordinate += sigma * random.gaussian();
      if ((point.head<2>().array() >= tile.box.min().array()).all() &&
          (point.head<2>().array() < tile.box.max().array()).all())
        points.push_back ({town.corner + point, label});
    }
  }
};

} // namespace

Town
makeTown (std::uint32_t seed, double points, double tiles)
{
  Town town;
  town.seed = seed;
  town.tiles = std::uint32_t (std::ceil (std::sqrt (tiles)));
  const double area = points / (density * surface_of_square_meter);
  town.tile = std::sqrt (area) / town.tiles;
  return town;
}

std::vector<TownPoint>
surveyTile (const Town& town,
            std::uint32_t column,
            std::uint32_t row,
            double noise_scale)
{
  TileSurvey survey{town,
                    {{column * town.tile, row * town.tile}, town.tile},
                    noise_scale * survey_sigma,
                    {}};
  const double square = edge_of_patch;
  survey.tile.forEachPlace ({square, square}, square, [&] (const Place& place) {
    survey.addPatch (
        {{square * place.x(), square * place.y(), 0}, {square, 0, 0}, {0, square, 0}},
        randomAt (town.seed, place, sides_of_terrace + 1),
        1);
  });
  const Vector2d pitch (terrace_pitch, street_pitch);
  const Eigen::AlignedBox2i all =
      Area (Vector2d::Zero(), town.tiles * town.tile).reach (pitch, reach_of_terrace);
  survey.tile.forEachPlace (pitch, reach_of_terrace, [&] (const Place& place) {
    const Place from_first = place - all.min();
    const int number = from_first.y() * (all.sizes().x() + 1) + from_first.x();
    std::uint32_t side_number = 0;
    for (const Side& side : terraceAt (town.seed, place)) {
      Random seeds = randomAt (town.seed, place, ++side_number);
      survey.addSide (
          side, seeds, 1 + std::uint32_t (number) * sides_of_terrace + side_number);
    }
  });
  return std::move (survey.points);
}

} // namespace pcl_ops::simulation
