// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/angles.h>

#include "peers.h"
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version_macros.h>

// CGAL 5.6 grows regions of items instead of indices.
#if CGAL_VERSION_NR < 1050600000
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_point_set.h>
#else
#include <CGAL/Point_set_3.h>
#include <CGAL/Shape_detection/Region_growing/Point_set.h>
#endif

#include <cmath>
#include <tuple>

namespace pcl_ops::evaluation {

namespace {

using Kernel = CGAL::Simple_cartesian<float>;
/** Efficient RANSAC reorders its input: a point brings its index along. */
using OrientedPoint = std::tuple<Kernel::Point_3, Kernel::Vector_3, pcl::index_t>;
using OrientedPoints = std::vector<OrientedPoint>;
using PointMap = CGAL::Nth_of_tuple_property_map<0, OrientedPoint>;
using NormalMap = CGAL::Nth_of_tuple_property_map<1, OrientedPoint>;

/** Number of neighbors for a normal in CGAL's tutorial. */
constexpr unsigned tutorial_neighbors = 24;
/** Default number of points of the smallest region. Unlike that of Efficient RANSAC it
 * is not min_share_of_plane: CGAL drops a smaller region and grows it again from each
 * of its points, which then takes minutes. */
constexpr std::size_t min_points_of_region = 50;
/** Largest angle between the normals of a point and of its plane: CGAL's default for
 * both detectors [degree]. */
constexpr float max_normal_angle = 25.0f;
/** Probability to miss the largest plane: CGAL's default. */
constexpr float miss_probability = 0.05f;
/** Share of the points that the smallest plane of Efficient RANSAC has, by default;
 * chosen by hand. */
constexpr double min_share_of_plane = 0.002;

/** Returns the number of neighbors for a normal. */
unsigned
neighborsFor (const PeerTask& task)
{
  const bool is_of_tutorial =
      task.source == ValuesFrom::Tutorial && !task.settings.peer_neighbors;
  return is_of_tutorial ? tutorial_neighbors : unsigned (task.values.neighbors);
}

/** Returns the points of the cloud with their normals. */
OrientedPoints
orientedPointsOf (const PeerTask& task)
{
  OrientedPoints points;
  points.reserve (task.cloud->size());
  for (const pcl::PointXYZ& point : *task.cloud)
    points.emplace_back (Kernel::Point_3 (point.x, point.y, point.z),
                         Kernel::Vector_3 (0, 0, 0),
                         pcl::index_t (points.size()));
  timed (task.time_of_normals, [&] {
    CGAL::pca_estimate_normals<CGAL::Sequential_tag> (
        points,
        neighborsFor (task),
        CGAL::parameters::point_map (PointMap()).normal_map (NormalMap()));
  });
  return points;
}

/** \param[in] members of the plane, as indices into points */
pcl::PointIndices
planeOf (const OrientedPoints& points, const std::vector<std::size_t>& members)
{
  pcl::PointIndices plane;
  for (const std::size_t i : members)
    plane.indices.push_back (std::get<2> (points[i]));
  return plane;
}

namespace growing = CGAL::Shape_detection::Point_set;

/** The points of each region, as indices into all points. */
using Regions = std::vector<std::vector<std::size_t>>;

#if CGAL_VERSION_NR < 1050600000

Regions
regionsOf (const OrientedPoints& points, const PeerTask& task)
{
  using Query = growing::K_neighbor_query<Kernel, OrientedPoints, PointMap>;
  using Region = growing::
      Least_squares_plane_fit_region<Kernel, OrientedPoints, PointMap, NormalMap>;
  using Sorting =
      growing::Least_squares_plane_fit_sorting<Kernel, OrientedPoints, Query, PointMap>;
  Query query (points, neighborsFor (task));
  Region region (points,
                 float (task.values.threshold),
                 max_normal_angle,
                 task.minPoints (min_points_of_region));
  Sorting sorting (points, query);
  sorting.sort();
  CGAL::Shape_detection::
      Region_growing<OrientedPoints, Query, Region, typename Sorting::Seed_map>
          region_growing (points, query, region, sorting.seed_map());
  Regions regions;
  region_growing.detect (std::back_inserter (regions));
  return regions;
}

#else

Regions
regionsOf (const OrientedPoints& points, const PeerTask& task)
{
  CGAL::Point_set_3<Kernel::Point_3> set (true); // with normals
  for (const OrientedPoint& point : points)
    set.insert (std::get<0> (point), std::get<1> (point));
  auto query = growing::make_k_neighbor_query (
      set, CGAL::parameters::k_neighbors (std::size_t{neighborsFor (task)}));
  auto region = growing::make_least_squares_plane_fit_region (
      set,
      CGAL::parameters::maximum_distance (float (task.values.threshold))
          .maximum_angle (max_normal_angle)
          .minimum_region_size (task.minPoints (min_points_of_region)));
  auto sorting = growing::make_least_squares_plane_fit_sorting (set, query);
  sorting.sort();
  using Growing =
      CGAL::Shape_detection::Region_growing<decltype (query), decltype (region)>;
  std::vector<Growing::Primitive_and_region> grown;
  Growing (set, sorting.ordered(), query, region).detect (std::back_inserter (grown));
  Regions regions;
  for (const auto& [plane, members] : grown)
    regions.emplace_back (members.begin(), members.end());
  return regions;
}

#endif

} // namespace

Planes
planesByCgalRansac (const PeerTask& task)
{
  using Traits = CGAL::Shape_detection::
      Efficient_RANSAC_traits<Kernel, OrientedPoints, PointMap, NormalMap>;
  using Ransac = CGAL::Shape_detection::Efficient_RANSAC<Traits>;
  CGAL::get_default_random() = CGAL::Random (task.settings.seed);
  OrientedPoints points = orientedPointsOf (task);
  Ransac ransac;
  ransac.set_input (points);
  ransac.add_shape_factory<CGAL::Shape_detection::Plane<Traits>>();
  Ransac::Parameters parameters;
  parameters.probability = miss_probability;
  parameters.min_points =
      task.minPoints (std::size_t (min_share_of_plane * double (points.size())) + 1);
  parameters.epsilon = float (task.values.threshold);
  parameters.cluster_epsilon = float (task.values.gap);
  parameters.normal_threshold = std::cos (pcl::deg2rad (max_normal_angle));
  ransac.detect (parameters);

  Planes planes;
  for (const auto& shape : ransac.shapes())
    planes.push_back (planeOf (points, shape->indices_of_assigned_points()));
  return planes;
}

Planes
planesByCgalRegionGrowing (const PeerTask& task)
{
  const OrientedPoints points = orientedPointsOf (task);
  Planes planes;
  for (const std::vector<std::size_t>& members : regionsOf (points, task))
    planes.push_back (planeOf (points, members));
  return planes;
}

} // namespace pcl_ops::evaluation
