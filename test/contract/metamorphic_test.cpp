// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/transforms.h>

#include "presets.h"
#include "scene.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>

#include <map>
#include <set>

// The planes of a cloud do not depend on how the cloud is written down.

namespace {

using Fspf = pcl_ops::FastSamplingPlaneFiltering<pcl::PointXYZ>;
using Kht = pcl_ops::KernelHoughTransform<pcl::PointXYZ>;
using Planes = std::vector<pcl_ops::PlaneSegment>;

/** \brief Index of points that were added to a cloud and have no original. */
constexpr pcl::index_t no_original = -1;

/** \brief A cloud and what is known of how it was changed; unchanged at first. */
struct Variant {
  explicit Variant (const Cloud& of)
  : cloud (pcl::make_shared<Cloud> (of)), original (upTo<pcl::Indices> (of.size()))
  {}

  Cloud::Ptr cloud;
  /** \brief For each point its index in the cloud it was made from, or no_original. */
  pcl::Indices original;
  /** \brief Length in this cloud of one unit length of the original cloud. */
  double unit = 1.0;
};

/** \param[in] unit length in the moved cloud of one unit length before */
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
  variant.original = order;
}

/** \brief Adds 1 % more points, drawn in a cube centered at zero.
 * \param[in] half_edge half the edge of the cube [m] */
void
addOutliers (Variant& variant, double half_edge)
{
  RandomGenerator generator (seedOfTest());
  const auto draw = [&] { return half_edge * (2.0 * drawUnit (generator) - 1.0); };
  for (std::size_t i = variant.cloud->size() / 100; i > 0; --i)
    variant.cloud->push_back (toPoint ({draw(), draw(), draw()}));
  variant.original.resize (variant.cloud->size(), no_original);
}

/** \brief Puts missing readings, written as zeros, before all points.
 * \param[in] share number of missing readings over number of points */
void
addMissing (Variant& variant, double share)
{
  const auto number =
      static_cast<std::size_t> (share * static_cast<double> (variant.cloud->size()));
  variant.cloud->insert (
      variant.cloud->begin(), number, pcl::PointXYZ (0.0f, 0.0f, 0.0f));
  variant.original.insert (variant.original.begin(), number, no_original);
}

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
       pcl::Indices order = v.original;
       std::shuffle (order.begin(), order.end(), RandomGenerator (seedOfTest()));
       reorder (v, order);
     }},
    {"every_point_twice",
     [] (Variant& v) {
       pcl::Indices order = v.original;
       order.insert (order.end(), v.original.begin(), v.original.end());
       reorder (v, order);
     }},
    {"every_point_thirty_times",
     [] (Variant& v) {
       pcl::Indices order;
       for (int copy = 0; copy < 30; ++copy)
         order.insert (order.end(), v.original.begin(), v.original.end());
       reorder (v, order);
     }},
    {"half_a_per_cent_more_missing_at_zero", [] (Variant& v) { addMissing (v, 5e-3); }},
    {"half_as_many_missing_at_zero", [] (Variant& v) { addMissing (v, 0.5); }},
    {"outliers_30_m", [] (Variant& v) { addOutliers (v, 30); }},
    {"outliers_10_km", [] (Variant& v) { addOutliers (v, 1e4); }},
    {"outliers_1000_km", [] (Variant& v) { addOutliers (v, 1e6); }},
    {"a_point_at_a_million_km",
     [] (Variant& v) {
       v.cloud->insert (v.cloud->begin(), pcl::PointXYZ (1e9f, -1e9f, 1e9f));
       v.original.insert (v.original.begin(), no_original);
     }},
    {"viewpoint_elsewhere", [] (Variant& v) {
       v.cloud->sensor_origin_ = Eigen::Vector4f (-30.0f, 50.0f, -20.0f, 0.0f);
     }}};

// Changes after which OPS, by default and on voxels, keeps every point on its plane.
// Equal points count as one point. Far more points at one place than at others are
// missing readings, and do not count.
const std::set<std::string> exact_changes = {"permuted",
                                             "every_point_twice",
                                             "every_point_thirty_times",
                                             "half_as_many_missing_at_zero"};

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
  Planes (*planes) (const Variant&);
  /** \brief Least share of the points on planes that stay on the same plane. */
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

/** \brief Share of the points on \p planes that stay together: of the points of a plane
 * those count that are on one plane of the variant, the one that has most of them. */
double
agreement (const Planes& planes, const Planes& of_variant, const Variant& variant)
{
  // For each original index the number of its plane, from 1; 0 on no plane.
  std::map<int, std::size_t> number_after;
  for (std::size_t p = 0; p < of_variant.size(); ++p)
    for (const pcl::index_t i : of_variant[p].inliers)
      number_after[variant.original[i]] = p + 1;
  double on_planes = 0.0, kept = 0.0;
  for (const pcl_ops::PlaneSegment& plane : planes) {
    std::vector<double> shared (of_variant.size() + 1);
    for (const pcl::index_t i : plane.inliers)
      ++shared[number_after[i]];
    shared[0] = 0.0;
    kept += *std::max_element (shared.begin(), shared.end());
    on_planes += plane.inliers.size();
  }
  return on_planes > 0.0 ? kept / on_planes : 0.0;
}

/** \brief A room with a table, and the noise of a good laser scanner. */
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

TEST_P (Metamorphic, PlanesStayTheSame)
{
  const auto& [name, change] = GetParam();
  const Variant unchanged (furnishedRoom());
  Variant changed (*unchanged.cloud);
  change (changed);
  for (const Method& method : methods) {
    const std::set<std::string> exact_methods = {"ops", "ops on voxels"};
    const bool is_exact =
        exact_changes.count (name) > 0 && exact_methods.count (method.name) > 0;
    EXPECT_GE (agreement (method.planes (unchanged), method.planes (changed), changed),
               is_exact ? 1.0 : method.min_agreement)
        << method.name;
  }
}

INSTANTIATE_TEST_SUITE_P (Cloud,
                          Metamorphic,
                          ::testing::ValuesIn (changes),
                          [] (const auto& info) { return info.param.first; });
