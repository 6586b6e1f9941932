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

/** \brief A place on the lattice of terraces or of patches of the ground. */
using Place = Eigen::Vector2i;

/** \brief A rectangle from a corner along two sides that are at right angles. */
struct Side {
  Vector3d corner, along, up;
};

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
  const Vector3d up (0, 0, eaves);
  std::vector<Side> sides = {
      {at (0, 0, 0), along, up},
      {at (0, depth, 0), along, up},
      {at (0, 0, eaves), along, at (0, 0.5 * depth, ridge) - at (0, 0, eaves)},
      {at (0, depth, eaves), along, at (0, 0.5 * depth, ridge) - at (0, depth, eaves)},
      {at (0, 0, 0.5 * eaves), along, across}};
  for (int wall = 0; wall <= houses; ++wall)
    sides.push_back ({at (wall * width_of_house, 0, 0), across, up});
  return sides;
}

/** \brief More than any terrace has. */
constexpr std::uint32_t sides_of_terrace = 20;
/** \brief Beside the number of a side, for the draws of the ground. */
constexpr std::uint32_t of_ground = sides_of_terrace + 1;

/** \brief The places of a lattice that may reach into some area, in the frame of the
 * streets. */
Eigen::AlignedBox2i
reachOf (const AlignedBox2d& area, const Vector2d& pitch, double margin)
{
  const Vector2d room (margin, margin);
  const Vector2d low = (area.min() - room).cwiseQuotient (pitch);
  const Vector2d high = (area.max() + room).cwiseQuotient (pitch);
  return {low.array().floor().cast<int>().matrix(),
          high.array().ceil().cast<int>().matrix()};
}

/** \brief Row by row. */
std::vector<Place>
placesIn (const Eigen::AlignedBox2i& reach)
{
  std::vector<Place> places;
  for (int row = reach.min().y(); row <= reach.max().y(); ++row)
    for (int column = reach.min().x(); column <= reach.max().x(); ++column)
      places.emplace_back (column, row);
  return places;
}

/** \brief Takes the points of a tile out of the patches that reach into it. */
class TileSurvey {
public:
  TileSurvey (const Town& town, std::uint32_t column, std::uint32_t row, double sigma)
  : town_ (town)
  , sigma_ (sigma)
  , turn_ (turnZ (direction_of_streets * pi / 180.0).linear())
  {
    const Vector2d low (column * town.tile, row * town.tile);
    tile_ = {low, low + Vector2d (town.tile, town.tile)};
  }

  std::vector<TownPoint>
  points ()
  {
    constexpr double square = edge_of_patch;
    for (const Place& place :
         placesIn (reachOf (areaOf (tile_), {square, square}, square)))
      addPatch (
          {{square * place.x(), square * place.y(), 0}, {square, 0, 0}, {0, square, 0}},
          randomAt (town_.seed, place, of_ground),
          1);
    const AlignedBox2d town (Vector2d::Zero(),
                             Vector2d::Constant (town_.tiles * town_.tile));
    const Vector2d pitch (terrace_pitch, street_pitch);
    const Eigen::AlignedBox2i all = reachOf (areaOf (town), pitch, reach_of_terrace);
    for (const Place& place :
         placesIn (reachOf (areaOf (tile_), pitch, reach_of_terrace)))
      addTerrace (all, place);
    return std::move (points_);
  }

private:
  /** \brief What is around an area of tiles in the frame of the streets. */
  AlignedBox2d
  areaOf (const AlignedBox2d& area) const
  {
    AlignedBox2d around;
    using Box = AlignedBox2d;
    for (const auto corner :
         {Box::BottomLeft, Box::BottomRight, Box::TopLeft, Box::TopRight}) {
      const Vector2d place = area.corner (corner);
      around.extend (
          (turn_.transpose() * Vector3d (place.x(), place.y(), 0)).head<2>().eval());
    }
    return around;
  }

  void
  addTerrace (const Eigen::AlignedBox2i& all, const Place& place)
  {
    const Place from_first = place - all.min();
    const auto columns = std::uint32_t (all.sizes().x() + 1);
    const auto number =
        std::uint32_t (from_first.y()) * columns + std::uint32_t (from_first.x());
    std::uint32_t side_number = 0;
    for (const Side& side : terraceAt (town_.seed, place)) {
      ++side_number;
      Random seeds = randomAt (town_.seed, place, side_number);
      addSide (side, seeds, 1 + number * sides_of_terrace + side_number);
    }
  }

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
    const double margin = 10.0 * sigma_;
    AlignedBox2d around;
    for (const Vector3d& corner : {patch.corner,
                                   Vector3d (patch.corner + patch.along),
                                   Vector3d (patch.corner + patch.up),
                                   Vector3d (patch.corner + patch.along + patch.up)})
      around.extend ((turn_ * corner).head<2>().eval());
    around.min().array() -= margin;
    around.max().array() += margin;
    if (!around.intersects (tile_))
      return;
    const auto wanted =
        std::size_t (density * patch.along.norm() * patch.up.norm() + random.unit());
    for (std::size_t i = 0; i < wanted; ++i) {
      const double u = random.unit(), v = random.unit();
      Vector3d point = turn_ * (patch.corner + u * patch.along + v * patch.up);
      for (double& coordinate : point)
        coordinate += sigma_ * random.gaussian();
      const bool is_inside = (point.head<2>().array() >= tile_.min().array()).all() &&
                             (point.head<2>().array() < tile_.max().array()).all();
      if (is_inside)
        points_.push_back ({town_.corner + point, label});
    }
  }

  const Town& town_;
  double sigma_;
  Eigen::Matrix3d turn_;
  AlignedBox2d tile_;
  std::vector<TownPoint> points_;
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
  return TileSurvey (town, column, row, noise_scale * survey_sigma).points();
}

} // namespace pcl_ops::simulation
