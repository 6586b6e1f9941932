// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/transforms.h>

#include "presets.h"
#include "scene.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>

#include <map>
#include <set>

// The planes of a cloud stay the same if it is moved, scaled or written in another
// order, and if points are added that are on none of its surfaces.

namespace {

using Fspf = pcl_ops::FastSamplingPlaneFiltering<pcl::PointXYZ>;
using Kht = pcl_ops::KernelHoughTransform<pcl::PointXYZ>;
using Planes = std::vector<pcl_ops::PlaneSegment>;

/** \brief In place of an index: the point was added to the cloud. */
constexpr pcl::index_t no_original = -1;

/** \brief A copy of a cloud, the original, which is changed later, and how its points
 * and its unit follow from the original. */
struct Variant {
  explicit Variant (const Cloud& original)
  : cloud (pcl::make_shared<Cloud> (original))
  , original_index (upTo<pcl::Indices> (original.size()))
  {}

  Cloud::Ptr cloud;
  /** \brief For each point its index in the original cloud, or no_original. */
  pcl::Indices original_index;
  /** \brief Length in this cloud of one unit length of the original cloud. */
  double unit = 1.0;
};

/** \brief Moves and scales a variant.
 * \param[in] unit \ref Variant::unit: the scale that is part of the motion */
void
move (Variant& variant, const Eigen::Affine3d& motion, double unit = 1.0)
{
  pcl::transformPointCloud (*variant.cloud, *variant.cloud, motion);
  variant.unit = unit;
}

/** \brief A turn by 0.7 rad, some 40 degrees, about an axis through zero. */
Eigen::Affine3d
turnAbout (const Eigen::Vector3d& axis)
{
  constexpr double angle = 0.7; // [rad]
  return Eigen::Affine3d (Eigen::AngleAxisd (angle, axis.normalized()));
}

/** \brief Replaces the points by those with the indices in \p order. The variant must
 * be unchanged before. */
void
reorder (Variant& variant, const pcl::Indices& order)
{
  // pcl::copyPointCloud ignores the order if there are as many indices as points.
  const auto ordered = pcl::make_shared<Cloud>();
  for (const pcl::index_t i : order)
    ordered->push_back ((*variant.cloud)[i]);
  variant.cloud = ordered;
  variant.original_index = order;
}

/** \brief Adds 1 % more points, drawn uniformly in a cube centered at zero.
 * \param[in] half_edge half the edge of the cube [m] */
void
addOutliers (Variant& variant, double half_edge)
{
  RandomGenerator generator (seedOfTest());
  const auto draw = [&] { return half_edge * (2.0 * drawUnit (generator) - 1.0); };
  for (std::size_t i = variant.cloud->size() / 100; i > 0; --i)
    variant.cloud->push_back (toPoint ({draw(), draw(), draw()}));
  variant.original_index.resize (variant.cloud->size(), no_original);
}

/** \brief Adds points at zero before all others: readings of a sensor that found
 * nothing.
 * \param[in] share number of added points over number of points before */
void
addMissingReadings (Variant& variant, double share)
{
  const auto number =
      static_cast<std::size_t> (share * static_cast<double> (variant.cloud->size()));
  variant.cloud->insert (
      variant.cloud->begin(), number, pcl::PointXYZ (0.0f, 0.0f, 0.0f));
  variant.original_index.insert (variant.original_index.begin(), number, no_original);
}

/** \brief Changes of an unchanged variant, by name. */
const std::map<std::string, void (*) (Variant&)> changes = {
    {"shifted_by_1_km",
     [] (Variant& v) {
       move (v, Eigen::Affine3d (Eigen::Translation3d (1000, -1000, 100)));
     }},
    {"rounded_to_um",
     [] (Variant& v) {
       for (pcl::PointXYZ& point : *v.cloud)
         point.getVector3fMap() =
             (1e-6 * (1e6 * point.getVector3fMap().array().cast<double>()).round())
                 .matrix()
                 .cast<float>();
     }},
    {"in_millimeters",
     [] (Variant& v) { move (v, Eigen::Affine3d (Eigen::Scaling (1e3)), 1e3); }},
    {"in_kilometers",
     [] (Variant& v) { move (v, Eigen::Affine3d (Eigen::Scaling (1e-3)), 1e-3); }},
    {"turned_about_z",
     [] (Variant& v) { move (v, turnAbout (Eigen::Vector3d::UnitZ())); }},
    {"turned", [] (Variant& v) { move (v, turnAbout (Eigen::Vector3d (1, 2, 3))); }},
    {"permuted",
     [] (Variant& v) {
       pcl::Indices order = v.original_index;
       std::shuffle (order.begin(), order.end(), RandomGenerator (seedOfTest()));
       reorder (v, order);
     }},
    {"every_point_twice",
     [] (Variant& v) {
       pcl::Indices order = v.original_index;
       order.insert (order.end(), v.original_index.begin(), v.original_index.end());
       reorder (v, order);
     }},
    {"every_point_thirty_times",
     [] (Variant& v) {
       pcl::Indices order;
       for (int copy = 0; copy < 30; ++copy)
         order.insert (order.end(), v.original_index.begin(), v.original_index.end());
       reorder (v, order);
     }},
    {"missing_readings_of_half_a_percent",
     [] (Variant& v) { addMissingReadings (v, 5e-3); }},
    {"missing_readings_half_as_many_as_points",
     [] (Variant& v) { addMissingReadings (v, 0.5); }},
    {"outliers_30_m", [] (Variant& v) { addOutliers (v, 30); }},
    {"outliers_10_km", [] (Variant& v) { addOutliers (v, 1e4); }},
    {"outliers_1000_km", [] (Variant& v) { addOutliers (v, 1e6); }},
    {"a_point_at_a_million_km",
     [] (Variant& v) {
       v.cloud->insert (v.cloud->begin(), pcl::PointXYZ (1e9f, -1e9f, 1e9f));
       v.original_index.insert (v.original_index.begin(), no_original);
     }},
    {"viewpoint_elsewhere", [] (Variant& v) {
       v.cloud->sensor_origin_ = Eigen::Vector4f (-30.0f, 50.0f, -20.0f, 0.0f);
     }}};

// Changes after which OPS, by default and on voxels, keeps every point on its plane:
// equal points count as one point, and if one position has far more points than all
// others, these are missing readings, which do not count.
const std::set<std::string> exact_changes = {"permuted",
                                             "every_point_twice",
                                             "every_point_thirty_times",
                                             "missing_readings_half_as_many_as_points"};

template <typename Detector>
Planes
planesBy (Detector detector, const Variant& variant)
{
  auto parameters = detector.getParameters();
  if (parameters.distance_threshold)
    *parameters.distance_threshold *= variant.unit;
  if constexpr (std::is_same_v<Detector, Fspf>) {
    parameters.local.inner_radius *= variant.unit;
    parameters.local.outer_radius *= variant.unit;
  }
  detector.setParameters (parameters);
  detector.setInputCloud (variant.cloud);
  return planesOf (detector);
}

struct Method {
  const char* name;
  Planes (*planes_of) (const Variant&);
  /** \brief Smallest \ref agreement that a change other than an exact one may have. */
  double min_agreement;
};

const Method methods[] = {
    {"ops", [] (const auto& v) { return planesBy (Ops(), v); }, 99_percent},
    {"ops on voxels",
     [] (const auto& v) { return planesBy (voxelsOn (v.cloud), v); },
     99_percent},
    {"ops as in the paper",
     [] (const auto& v) { return planesBy (paperOn (v.cloud), v); },
     95_percent},
    {"fspf", [] (const auto& v) { return planesBy (Fspf(), v); }, 99_percent},
    {"kht", [] (const auto& v) { return planesBy (Kht(), v); }, 98_percent}};

/** \brief Share of the points on \p planes that stay together. Each plane belongs to
 * the plane of the variant that has most of its points; the points that both have
 * count.
 * \return 0 if there are no points on planes */
double
agreement (const Planes& planes, const Planes& of_variant, const Variant& variant)
{
  // For each original index the number of its plane of the variant, from 1; 0: none.
  std::map<pcl::index_t, std::size_t> plane_in_variant;
  for (std::size_t p = 0; p < of_variant.size(); ++p)
    for (const pcl::index_t i : of_variant[p].inliers)
      plane_in_variant[variant.original_index[i]] = p + 1;
  double on_planes = 0.0, together = 0.0;
  for (const pcl_ops::PlaneSegment& plane : planes) {
    std::vector<double> shared_points (of_variant.size() + 1);
    for (const pcl::index_t i : plane.inliers)
      ++shared_points[plane_in_variant[i]];
    shared_points[0] = 0.0;
    together += *std::max_element (shared_points.begin(), shared_points.end());
    on_planes += plane.inliers.size();
  }
  return on_planes > 0.0 ? together / on_planes : 0.0;
}

/** \brief A room with a table, a noise of 3 mm, as of a laser scanner, and no clutter.
 */
Cloud
furnishedRoom ()
{
  constexpr std::uint32_t seed = 7; // the same room in all tests
  Scene scene = room (seed).noise (3_mm).spacing (2_cm).clutter (0.0);
  return *scene.surface ({1.5, 1, 0.75}, {1.2, 0, 0}, {0, 0.8, 0}).build().cloud;
}

class Metamorphic
: public ::testing::TestWithParam<std::pair<const std::string, void (*) (Variant&)>> {};

} // namespace

TEST_P (Metamorphic, PointsStayTogetherOnTheirPlanes)
{
  const auto& [name, change] = GetParam();
  const Variant unchanged (furnishedRoom());
  Variant changed (*unchanged.cloud);
  change (changed);
  for (const Method& method : methods) {
    const std::set<std::string> exact_methods = {"ops", "ops on voxels"};
    const bool is_exact =
        exact_changes.count (name) > 0 && exact_methods.count (method.name) > 0;
    EXPECT_GE (
        agreement (method.planes_of (unchanged), method.planes_of (changed), changed),
        is_exact ? 1.0 : method.min_agreement)
        << method.name;
  }
}

INSTANTIATE_TEST_SUITE_P (Cloud,
                          Metamorphic,
                          ::testing::ValuesIn (changes),
                          [] (const auto& info) { return info.param.first; });
