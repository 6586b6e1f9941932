// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "airborne.h"

#include <algorithm>

namespace pcl_ops::simulation {

namespace {

constexpr double edge_of_lot = 45.0; // [m]
/** Surface of the ground. */
constexpr SurfaceId ground = 1;
/** The roof of lot i has the surfaces first_roof + 2 i (side at +y of the house) and
 * first_roof + 2 i + 1 (side at -y). */
constexpr SurfaceId first_roof = 2;

/** Draws a house of common lengths and heights [m] on a lot.
 * \param[in] middle of the lot [m] */
House
drawHouse (const Vector2d& middle, const Relief& relief, Random& random)
{
  House house;
  house.center.x() = middle.x() + random.between (-4, 4);
  house.center.y() = middle.y() + random.between (-4, 4);
  house.center.z() = relief.height (house.center.x(), house.center.y());
  house.yaw = random.angle (0, 180);
  house.width = random.between (9, 13);
  house.length = random.between (14, 20);
  house.eaves = random.between (3.5, 6.5);
  house.ridge = house.eaves + 0.5 * house.width * std::tan (random.angle (28, 42));
  return house;
}

/** Returns the plane of a side of a roof, whose normal points upwards.
 * \param[in] side at +y (1) or -y (-1) of the house */
Plane
roofPlane (const House& house, int side)
{
  const double half_width = 0.5 * house.width;
  const Vector3d normal (0.0, side * (house.ridge - house.eaves), half_width);
  return planeThrough (house.pose() * Vector3d (0, 0, house.ridge),
                       house.pose().linear() * normal.normalized());
}

struct SeenSurface {
  double height = 0.0; // [m]
  SurfaceId surface = no_surface;
};

/** Returns what is seen from above at a position, without noise: a leaf of a wood, a
 * roof or the ground.
 * \param[in] lot index of the lot of the position
 * \param[in] position x and y in the frame of the site [m] */
SeenSurface
lookDown (const AirborneSite& site,
          std::size_t lot,
          const Vector2d& position,
          Random& random)
{
  constexpr double share_of_leaves = 0.7; // of what is seen of a wood
  constexpr double lowest_leaf = 2.0;     // above the ground [m]
  constexpr double highest_leaf = 16.0;   // above the ground [m]
  const bool is_flat = !(site.relief.amplitude > 0.0);
  const double height = site.relief.height (position.x(), position.y());
  const SeenSurface bare_ground{height, is_flat ? ground : unknown_surface};
  if (!site.houses[lot])
    return random.chance (share_of_leaves)
               ? SeenSurface{height + random.between (lowest_leaf, highest_leaf),
                             no_surface}
               : bare_ground;
  const House& house = *site.houses[lot];
  const Vector2d from_center = position - house.center.head<2>();
  const Vector2d local = Eigen::Rotation2Dd (-house.yaw) * from_center; // in its frame
  const double half_width = 0.5 * house.width;
  const double from_ridge = std::abs (local.y());
  if (from_ridge >= half_width || std::abs (local.x()) >= 0.5 * house.length)
    return bare_ground;
  const double slope = (house.ridge - house.eaves) / half_width;
  const SurfaceId side = local.y() > 0.0 ? 0 : 1;
  return {house.center.z() + house.ridge - slope * from_ridge,
          first_roof + 2 * SurfaceId (lot) + side};
}

} // namespace

double
AirborneSite::width() const
{
  return lots * edge_of_lot;
}

AirborneSite
makeAirborne (Seed seed)
{
  constexpr double chance_of_flat = 0.25;
  constexpr double chance_of_wood = 0.3;
  constexpr double max_points = 600'000;
  Random random = randomFor (Purpose::Airborne, seed);
  AirborneSite site;
  const double wanted_width = drawLogUniform (100, 1000, random); // [m]
  site.lots = int (std::lround (wanted_width / edge_of_lot));
  const double max_density = max_points / (site.width() * site.width());
  site.density = std::min (drawLogUniform (0.4, 4, random), max_density);
  const bool is_flat = random.chance (chance_of_flat);
  const double amplitude = random.between (1, 8);       // [m]
  const double wave_length = random.between (150, 250); // [m]
  site.relief = drawRelief (is_flat ? 0.0 : amplitude, wave_length, random);
  for (int row = 0; row < site.lots; ++row)
    for (int column = 0; column < site.lots; ++column) {
      const Vector2d middle (column + 0.5, row + 0.5); // [lots]
      site.houses.emplace_back();
      if (!random.chance (chance_of_wood))
        site.houses.back() = drawHouse (edge_of_lot * middle, site.relief, random);
    }
  return site;
}

SimulatedCloud
scanAirborne (const AirborneSite& site, std::size_t points, double noise, Seed seed)
{
  std::vector<Plane> planes{planeThrough (Vector3d::Zero(), Vector3d::UnitZ())};
  // A wood gets two planes without points, so that each lot has two surface numbers.
  for (const std::optional<House>& house : site.houses)
    for (const int side : {1, -1})
      planes.push_back (roofPlane (house.value_or (House{}), side));
  Random random = randomFor (Purpose::AirborneScan, seed);
  LabeledCloud cloud;
  cloud.reserve (points);
  for (std::size_t i = 0; i < points; ++i) {
    const double x = site.width() * random.unit();
    const double y = site.width() * random.unit();
    const auto lot = std::size_t (y / edge_of_lot) * std::size_t (site.lots) +
                     std::size_t (x / edge_of_lot);
    const SeenSurface seen = lookDown (site, lot, {x, y}, random);
    const double error = noise * airborne_sigma * random.gaussian();
    cloud.push_back (pointAt ({x, y, seen.height + error}, seen.surface));
  }
  return labeledBySize (std::move (cloud), planes, min_points_of_roof);
}

} // namespace pcl_ops::simulation
