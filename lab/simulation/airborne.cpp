// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "airborne.h"

#include <algorithm>

namespace pcl_ops::simulation {

namespace {

constexpr double edge_of_lot = 45.0; // [m]
/** The roof of lot i has the surfaces first_roof + 2 i and first_roof + 2 i + 1. */
constexpr SurfaceId ground = 1, first_roof = 2;

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

/** \param[in] side of the roof: towards +y (1) or -y (-1) of its house */
Plane
roofPlane (const House& house, int side)
{
  const double half_width = 0.5 * house.width;
  const Vector3d normal (0.0, side * (house.ridge - house.eaves), half_width);
  return planeThrough (house.pose() * Vector3d (0, 0, house.ridge),
                       house.pose().linear() * normal.normalized());
}

struct SurfaceAt {
  double height = 0.0; // [m]
  SurfaceId surface = no_surface;
};

/** Returns height and surface seen from above at a place of a lot, without noise. */
SurfaceAt
lookDown (const Airborne& site, std::size_t lot, const Vector2d& place, Random& random)
{
  constexpr double share_of_leaves = 0.7;
  const bool is_flat = !(site.relief.amplitude > 0.0);
  const double height = site.relief.height (place.x(), place.y());
  const SurfaceAt bare{height, is_flat ? ground : unknown_surface};
  if (!site.houses[lot])
    return random.chance (share_of_leaves)
               ? SurfaceAt{height + random.between (2, 16), no_surface}
               : bare;
  const House& house = *site.houses[lot];
  const Vector2d from_center = place - house.center.head<2>();
  const Vector2d local = Eigen::Rotation2Dd (-house.yaw) * from_center;
  const double half_width = 0.5 * house.width;
  const double aside = std::abs (local.y());
  if (aside >= half_width || std::abs (local.x()) >= 0.5 * house.length)
    return bare;
  const double rise = (house.ridge - house.eaves) / half_width;
  const SurfaceId side = local.y() > 0.0 ? 0 : 1;
  return {house.center.z() + house.ridge - rise * aside,
          first_roof + 2 * SurfaceId (lot) + side};
}

} // namespace

double
Airborne::width() const
{
  return lots * edge_of_lot;
}

Airborne
makeAirborne (Seed seed)
{
  constexpr double chance_of_flat = 0.25;
  constexpr double chance_of_wood = 0.3;
  constexpr double max_points = 600'000;
  Random random = randomFor (Purpose::Airborne, seed);
  Airborne site;
  site.lots = int (std::lround (drawLogUniform (100, 1000, random) / edge_of_lot));
  const double densest = max_points / (site.width() * site.width());
  site.density = std::min (drawLogUniform (0.4, 4, random), densest);
  const bool is_flat = random.chance (chance_of_flat);
  const double amplitude = random.between (1, 8);
  const double length = random.between (150, 250);
  site.relief = drawRelief (is_flat ? 0.0 : amplitude, length, random);
  for (int row = 0; row < site.lots; ++row)
    for (int column = 0; column < site.lots; ++column) {
      const Vector2d middle (column + 0.5, row + 0.5);
      site.houses.emplace_back();
      if (!random.chance (chance_of_wood))
        site.houses.back() = drawHouse (edge_of_lot * middle, site.relief, random);
    }
  return site;
}

SimulatedCloud
scanAirborne (const Airborne& site, std::size_t points, double noise, Seed seed)
{
  std::vector<Plane> planes{planeThrough (Vector3d::Zero(), Vector3d::UnitZ())};
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
    const SurfaceAt seen = lookDown (site, lot, {x, y}, random);
    const double error = noise * airborne_sigma * random.gaussian();
    cloud.push_back (pointAt ({x, y, seen.height + error}, seen.surface));
  }
  return labeledBySize (std::move (cloud), planes, min_points_of_roof);
}

} // namespace pcl_ops::simulation
