// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/memory.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "scene.h"

#include <cmath>
#include <functional>
#include <ostream>
#include <string>

// Clouds that are hard on a search in one way or another.

using pcl::PointXYZ;
using Cloud = pcl::PointCloud<PointXYZ>;

inline Cloud::Ptr
randomCloud (std::size_t size, const std::function<PointXYZ (RandomGenerator&)>& draw)
{
  RandomGenerator generator (seedOfTest());
  auto cloud = pcl::make_shared<Cloud>();
  for (std::size_t i = 0; i < size; ++i)
    cloud->push_back (draw (generator));
  return cloud;
}

inline PointXYZ
drawInCube (RandomGenerator& generator, double edge)
{
  const auto draw = [&] {
    return static_cast<float> (edge * (drawUnit (generator) - 0.5));
  };
  const float x = draw(), y = draw(), z = draw();
  return {x, y, z};
}

inline Cloud::Ptr
uniformVolume ()
{
  return randomCloud (3000, [] (auto& g) { return drawInCube (g, 1_m); });
}

inline Cloud::Ptr
surfaces ()
{
  return room().spacing (10_cm).build().cloud;
}

/** Most points within a millimetre, the others over a kilometre. */
inline Cloud::Ptr
clusters ()
{
  return randomCloud (4000, [] (auto& g) {
    return drawInCube (g, drawUnit (g) < 0.9 ? 1_mm : 1000_m);
  });
}

inline Cloud::Ptr
duplicates ()
{
  return randomCloud (2000, [] (auto& g) {
    const auto i = static_cast<float> (drawBelow (g, 7));
    return PointXYZ (i, 2.0f * i, -i);
  });
}

inline Cloud::Ptr
allEqual ()
{
  return randomCloud (1000, [] (auto&) { return PointXYZ (1, 2, 3); });
}

inline Cloud::Ptr
line ()
{
  return randomCloud (2000, [] (auto& g) {
    const auto t = static_cast<float> (drawUnit (g));
    return PointXYZ (t, 2.0f * t, 3.0f * t);
  });
}

/** The same relative distance between neighbours at every scale. */
inline Cloud::Ptr
everySmallerSteps ()
{
  return randomCloud (2000, [] (auto& g) {
    return drawInCube (g, std::pow (10.0, 12.0 * drawUnit (g) - 9.0));
  });
}

inline Cloud::Ptr
farFromZero ()
{
  return Scene()
      .floor (40_m, 30_m)
      .wall ({0, 0}, {40, 0}, 25_m)
      .spacing (1_m)
      .movedBy ({1e6, -2e6, 1e6})
      .build()
      .cloud;
}

inline Cloud::Ptr
volumeBesideStrayPoints ()
{
  const auto cloud = uniformVolume();
  for (const PointXYZ& stray : {PointXYZ (1e7f, 0, 0), PointXYZ (-1e12f, 1e12f, 0)})
    cloud->push_back (stray);
  return cloud;
}

inline Cloud::Ptr
onePoint ()
{
  auto cloud = pcl::make_shared<Cloud>();
  cloud->push_back ({1, 2, 3});
  return cloud;
}

struct NamedCloud {
  std::string name;
  Cloud::Ptr (*build)();
};

inline std::ostream&
operator<< (std::ostream& stream, const NamedCloud& cloud)
{
  return stream << cloud.name;
}
