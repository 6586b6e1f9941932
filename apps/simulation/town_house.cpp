// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "openings.h"
#include "poses.h"
#include "street_things.h"

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

/** \brief Sizes that the openings of a house share [m]. */
struct FacadeStyle {
  int storeys, bays;
  double width, storey;
  double window_width, window_height, sill, window_depth;
  double door_width, door_height, door_depth;
  int bay_of_door;
  /** \brief Of the facade's upper edge. */
  double eaves;
};

FacadeStyle
drawStyle (double width, internal::RandomGenerator& generator)
{
  FacadeStyle style{};
  style.width = width;
  style.storeys = 1 + int (internal::drawBelow (generator, 4));
  style.bays = int (width / drawBetween (generator, 2.8, 3.4));
  style.storey = drawBetween (generator, 2.7, 3.2);
  style.window_width = drawBetween (generator, 0.9, 1.6);
  style.window_height = drawBetween (generator, 1.2, 1.6);
  style.sill = drawBetween (generator, 0.7, 1.0);
  style.window_depth = drawBetween (generator, 0.10, 0.20);
  const bool is_garage = drawChance (generator, 0.4);
  style.door_width = is_garage ? 2.4 : drawBetween (generator, 1.0, 1.4);
  style.door_height = drawBetween (generator, 2.1, 2.4);
  style.door_depth = drawBetween (generator, 0.28, 0.40);
  style.bay_of_door = int (internal::drawBelow (generator, style.bays));
  style.eaves = style.storeys * style.storey + drawBetween (generator, 0.2, 0.6);
  return style;
}

Opening
openingOf (const FacadeStyle& style, int storey, int bay)
{
  constexpr double step_of_door = 0.06; // [m]
  const bool is_door = storey == 0 && bay == style.bay_of_door;
  const double middle = ((bay + 0.5) / style.bays - 0.5) * style.width;
  const double half_width = 0.5 * (is_door ? style.door_width : style.window_width);
  const double bottom = storey * style.storey + (is_door ? step_of_door : style.sill);
  const double height = is_door ? style.door_height : style.window_height;
  return {middle - half_width,
          middle + half_width,
          bottom,
          bottom + height,
          is_door ? style.door_depth : style.window_depth};
}

void
addFacade (Body& house, const FacadeStyle& style)
{
  const double bay_width = style.width / style.bays;
  for (int storey = 0; storey < style.storeys; ++storey)
    for (int bay = 0; bay < style.bays; ++bay) {
      const bool is_top = storey + 1 == style.storeys;
      const double left = bay * bay_width - 0.5 * style.width;
      const Opening opening = openingOf (style, storey, bay);
      addWallAround (house,
                     opening,
                     upright (left,
                              left + bay_width,
                              storey * style.storey,
                              is_top ? style.eaves : (storey + 1) * style.storey,
                              0.0));
      addRecess (house, opening);
    }
}

/** \brief The walls beside the neighbours, which the ground hides below z = 0. */
void
addSideWalls (Body& house, const FacadeStyle& style, double depth)
{
  for (const double side : {-0.5, 0.5})
    addSurface (house,
                {{side * style.width, -0.5 * depth, 0.5 * style.eaves},
                 Vector3d::UnitY(),
                 Vector3d::UnitZ(),
                 0.5 * depth,
                 0.5 * style.eaves});
}

/** \brief The slope towards the street, which hides the other one. */
void
addRoof (Body& house,
         const FacadeStyle& style,
         double depth,
         internal::RandomGenerator& generator)
{
  const double pitch = drawAngle (generator, 30, 45);
  const double overhang = drawBetween (generator, 0.2, 0.5); // [m]
  const double half_run = 0.5 * (0.5 * depth + overhang);
  const Vector3d up_slope (0.0, -std::cos (pitch), std::sin (pitch));
  const double half_length = half_run / std::cos (pitch);
  const Vector3d lower_edge (0.0, overhang, style.eaves - overhang * std::tan (pitch));
  addSurface (house,
              {lower_edge + half_length * up_slope,
               Vector3d::UnitX(),
               up_slope,
               0.5 * style.width,
               half_length});
}

} // namespace

Body
makeTownHouse (double width, internal::RandomGenerator& generator)
{
  const FacadeStyle style = drawStyle (width, generator);
  const double depth = drawBetween (generator, 8, 12);
  Body house;
  addFacade (house, style);
  addSideWalls (house, style, depth);
  if (drawChance (generator, 0.6))
    addRoof (house, style, depth, generator);
  joinCoplanar (house);
  return house;
}

} // namespace pcl_ops::simulation
