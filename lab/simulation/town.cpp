// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "town.h"

#include "survey.h"

#include <cmath>
#include <utility>

namespace pcl_ops::simulation {

namespace {

using Eigen::AlignedBox2d;
using Eigen::AlignedBox2i;

constexpr double density = 30.0; // of points on a surface [1/m^2]
/** Distance from terrace to terrace across the streets [m]. */
constexpr double street_pitch = 44.0;
/** Distance from terrace to terrace along the streets [m]. */
constexpr double terrace_pitch = 170.0;
constexpr double width_of_house = 15.0; // [m]
/** No point of a terrace is farther from the corner of its \ref Cell [m]. Half of the
 * longest terrace is 75 m; the rest is for its depth and its shift of up to 4 m. */
constexpr double reach_of_terrace = 90.0;
constexpr double edge_of_patch = 8.0; // [m]
/** Above the number of sides of any terrace: 5 and up to 11 walls beside houses. */
constexpr std::uint32_t max_sides = 20;

/** Column and row of a cell in one of two grids in the frame of the streets: each cell
 * of one grid has a terrace, each cell of the other a patch of the ground. */
using Cell = Eigen::Vector2i;

/** A rectangle, given by a corner and two edges at right angles [m]. */
struct Rectangle {
  Vector3d corner, first_edge, second_edge;
};

/** Purposes of the random numbers of a cell. Further ones are 1 to \ref max_sides, the
 * numbers of the sides of its terrace. */
constexpr std::uint32_t for_terrace = 0, for_ground = max_sides + 1;

/** Returns the random numbers of a cell for one purpose. */
Random
randomAt (Seed seed, const Cell& cell, std::uint32_t purpose)
{
  // Numbers below 0 wrap around; they seed as well as others.
  const auto x = std::uint32_t (cell.x());
  const auto y = std::uint32_t (cell.y());
  return Random (std::seed_seq{seed, std::uint32_t (Purpose::Town), x, y, purpose});
}

/** Returns the sides of a cell's terrace, in the frame of the streets: front and back
 * wall, both slopes of the roof, the floor of the upper story, and the walls between
 * and beside the houses. */
std::vector<Rectangle>
terraceAt (Seed seed, const Cell& cell)
{
  Random random = randomAt (seed, cell, for_terrace);
  const auto houses = int (random.between (7, 11)); // 7 to 10
  const double length = houses * width_of_house;
  const double depth = random.between (9, 12);
  const double eaves = random.between (5, 8);
  const double ridge = eaves + random.between (2, 4);
  const double x = terrace_pitch * cell.x() + random.between (-4, 4);
  const double y = street_pitch * cell.y() + random.between (-4, 4);
  const Isometry3d pose = at ({x, y, 0}) * turnZ (random.angle (-3, 3));
  // u and v are distances from a corner of the terrace along and across it [m].
  const auto corner = [&] (double u, double v, double z) -> Vector3d {
    return pose * Vector3d (u - 0.5 * length, v - 0.5 * depth, z);
  };
  const Vector3d along = pose.linear() * Vector3d (length, 0, 0);
  const Vector3d across = pose.linear() * Vector3d (0, depth, 0);
  const Vector3d up (0, 0, eaves);
  const Vector3d top = corner (0, 0.5 * depth, ridge);
  std::vector<Rectangle> sides = {
      {corner (0, 0, 0), along, up},
      {corner (0, depth, 0), along, up},
      {corner (0, 0, eaves), along, top - corner (0, 0, eaves)},
      {corner (0, depth, eaves), along, top - corner (0, depth, eaves)},
      {corner (0, 0, 0.5 * eaves), along, across}};
  for (int wall = 0; wall <= houses; ++wall)
    sides.push_back ({corner (wall * width_of_house, 0, 0), across, up});
  return sides;
}

/** Rotation from the frame of the streets to the frame of the tiles, by 12 degrees, so
 * that tiles cut terraces at a slant. */
const Eigen::Matrix3d streets_to_tiles = turnZ (12.0 * pi / 180.0).linear();

/** Returns the range of cells, in the frame of the streets, from which a terrace or a
 * patch may reach into a square.
 * \param[in] square in the frame of the tiles [m]
 * \param[in] pitch edges of a cell [m]
 * \param[in] reach of a terrace or a patch from its cell [m] */
AlignedBox2i
cellsAround (const AlignedBox2d& square, const Vector2d& pitch, double reach)
{
  const Eigen::Matrix2d to_streets = streets_to_tiles.topLeftCorner<2, 2>().transpose();
  AlignedBox2d around;
  for (int corner = 0; corner < 4; ++corner)
    around.extend (to_streets * square.corner (AlignedBox2d::CornerType (corner)));
  const Eigen::Array2d low = (around.min().array() - reach) / pitch.array();
  const Eigen::Array2d high = (around.max().array() + reach) / pitch.array();
  return {low.floor().cast<int>().matrix(), high.ceil().cast<int>().matrix()};
}

/** Collects the points of a tile. A side of a terrace is divided into patches, and so
 * is the ground; each patch that reaches into the tile gives points. */
struct TileSurvey {
  const Town& town;
  AlignedBox2d tile; // relative to the town's corner [m]
  double sigma;      // of each coordinate [m]
  std::vector<TownPoint> points = {};

  /** Adds the points of all patches of a side.
   * \param[in,out] seeds gives each patch its seed, also patches outside the tile, so
   * that a patch has the same one for any tile */
  void
  addSide (const Rectangle& side, Random& seeds, std::uint32_t label)
  {
    const auto columns = int (std::ceil (side.first_edge.norm() / edge_of_patch));
    const auto rows = int (std::ceil (side.second_edge.norm() / edge_of_patch));
    const Vector3d across_column = side.first_edge / columns;
    const Vector3d across_row = side.second_edge / rows;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        addPatch ({side.corner + column * across_column + row * across_row,
                   across_column,
                   across_row},
                  Random (seeds.bits()),
                  label);
  }

  /** Returns a position of a patch in the frame of the tiles [m].
   * \param[in] u, v shares of the edges, from 0 to 1 */
  Vector3d
  positionOn (const Rectangle& patch, double u, double v) const
  {
    return streets_to_tiles *
           (patch.corner + u * patch.first_edge + v * patch.second_edge);
  }

  /** Adds the points of a patch that are in the tile.
   * \param[in] random those of the patch alone */
  void
  addPatch (const Rectangle& patch, Random random, std::uint32_t label)
  {
    AlignedBox2d around;
    for (const int u : {0, 1})
      for (const int v : {0, 1})
        around.extend (Vector2d (positionOn (patch, u, v).head<2>()));
    constexpr double largest_noise = 10.0; // no noise is larger, in multiples of sigma
    if (around.squaredExteriorDistance (tile) >
        largest_noise * largest_noise * sigma * sigma)
      return;
    // Random rounding: the mean number of points is density times area.
    const auto point_count = std::size_t (
        density * patch.first_edge.norm() * patch.second_edge.norm() + random.unit());
    for (std::size_t i = 0; i < point_count; ++i) {
      const double u = random.unit();
      const double v = random.unit();
      Vector3d point = positionOn (patch, u, v);
      for (double& coordinate : point)
        coordinate += sigma * random.gaussian();
      const auto x_y = point.head<2>().array();
      if ((x_y >= tile.min().array()).all() && (x_y < tile.max().array()).all())
        points.push_back ({town.corner + point, label});
    }
  }
};

constexpr std::uint32_t label_of_ground = 1;

AlignedBox2d
squareAt (const Vector2d& corner, double edge)
{
  return {corner, corner + Vector2d::Constant (edge)};
}

/** Calls visit for each cell of a range, the last column and row included. */
template <typename Visit>
void
forEachCell (const AlignedBox2i& range, const Visit& visit)
{
  for (int y = range.min().y(); y <= range.max().y(); ++y)
    for (int x = range.min().x(); x <= range.max().x(); ++x)
      visit (Cell (x, y));
}

} // namespace

Town
makeTown (Seed seed, double points, double tiles)
{
  // Surveyed surface per area of ground, walls and roofs included: about that of a mean
  // terrace in its cell.
  constexpr double surface_per_ground = 1.65;
  Town town;
  town.seed = seed;
  town.tiles = std::uint32_t (std::ceil (std::sqrt (tiles)));
  const double area = points / (density * surface_per_ground);
  town.edge_of_tile = std::sqrt (area) / town.tiles;
  return town;
}

std::vector<TownPoint>
surveyTile (const Town& town, std::uint32_t column, std::uint32_t row, double noise)
{
  const double edge_of_town = town.tiles * town.edge_of_tile;
  const Vector2d corner (column * town.edge_of_tile, row * town.edge_of_tile);
  TileSurvey survey{town, squareAt (corner, town.edge_of_tile), noise * survey_sigma};
  const double edge = edge_of_patch;
  forEachCell (cellsAround (survey.tile, {edge, edge}, edge), [&] (const Cell& cell) {
    survey.addPatch (
        {{edge * cell.x(), edge * cell.y(), 0}, {edge, 0, 0}, {0, edge, 0}},
        randomAt (town.seed, cell, for_ground),
        label_of_ground);
  });
  const Vector2d pitch (terrace_pitch, street_pitch);
  const AlignedBox2i cells_of_town =
      cellsAround (squareAt (Vector2d::Zero(), edge_of_town), pitch, reach_of_terrace);
  const AlignedBox2i cells = cellsAround (survey.tile, pitch, reach_of_terrace);
  forEachCell (cells, [&] (const Cell& cell) {
    const Cell from_first = cell - cells_of_town.min();
    const int columns = cells_of_town.sizes().x() + 1; // first and last one included
    const auto terrace = std::uint32_t (from_first.y() * columns + from_first.x());
    std::uint32_t side_number = 0;
    for (const Rectangle& side : terraceAt (town.seed, cell)) {
      Random seeds = randomAt (town.seed, cell, ++side_number);
      survey.addSide (side, seeds, label_of_ground + terrace * max_sides + side_number);
    }
  });
  return std::move (survey.points);
}

} // namespace pcl_ops::simulation
