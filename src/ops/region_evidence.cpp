// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/region_evidence.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "base/parallel.h"
#include "ops/constants.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// The border to a region with fewer places counts as open.
constexpr std::size_t min_places_of_neighbor = 12; // chosen by hand

// Returns the places of each region.
std::vector<Indices>
membersOf (const Regions& regions)
{
  std::vector<Indices> members (regions.list.size());
  for (std::size_t i = 0; i < regions.of_place.size(); ++i)
    if (regions.of_place[i] != no_plane)
      members[regions.of_place[i]].push_back (static_cast<std::uint32_t> (i));
  return members;
}

/** \brief The normal equations for the quadratic surface through the places of a
 * region: the height of the surface over the plane of the region is a weighted sum of
 * the terms 1, s, t, s^2, s t, t^2, with coordinates s and t in the plane in units of
 * the width of the region. */
struct SurfaceEquations {
  static constexpr std::size_t terms = 6;
  Eigen::Matrix<double, terms, terms> products =
      Eigen::Matrix<double, terms, terms>::Zero();
  Eigen::Matrix<double, terms, 1> right_side = Eigen::Matrix<double, terms, 1>::Zero();
  double sum_of_squared_heights = 0.0; // of the places over the plane [m^2]
};

// \param[in] members places of the region
// \param[in] width of the region [m], above 0
SurfaceEquations
surfaceEquations (const Places& places,
                  const Region& region,
                  const Indices& members,
                  double width)
{
  const Eigen::Vector3d& normal = region.fit.plane.normal;
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross (u);
  SurfaceEquations equations;
  for (const std::uint32_t place : members) {
    const Eigen::Vector3d from_center = places.position[place] - region.fit.centroid;
    const double s = from_center.dot (u) / width;
    const double t = from_center.dot (v) / width;
    const double height = from_center.dot (normal);
    Eigen::Matrix<double, SurfaceEquations::terms, 1> terms_at_place;
    terms_at_place << 1.0, s, t, s * s, s * t, t * t;
    equations.products += terms_at_place * terms_at_place.transpose();
    equations.right_side += terms_at_place * height;
    equations.sum_of_squared_heights += height * height;
  }
  return equations;
}

// Returns RegionEvidence::bend, with a quadratic surface fitted by least squares.
// \param[in] members places of the region
double
bendOf (const Places& places, const Region& region, const Indices& members)
{
  constexpr double ridge = 1e-9; // keeps the equations solvable for places on a line
  // Added to the variance of the residuals, in units of the squared width: exact places
  // have no residuals. With 1e-4, the square of join_bend_of_width, the F-score in
  // streets falls from .77 to .69 because of false planes.
  constexpr double added_variance = 1e-6;
  constexpr double least_width = 1e-12; // [m], keeps quotients finite
  if (members.size() < SurfaceEquations::terms)
    return 0.0;
  const double width = region.width() + least_width;
  SurfaceEquations equations = surfaceEquations (places, region, members, width);
  const auto count = static_cast<double> (members.size());
  equations.products.diagonal().array() += ridge * count;
  const Eigen::Matrix<double, SurfaceEquations::terms, 1> weights =
      equations.products.ldlt().solve (equations.right_side);
  const double sum_of_squared_surface_heights = std::clamp (
      weights.dot (equations.right_side), 0.0, equations.sum_of_squared_heights);
  const double residual_variance =
      (equations.sum_of_squared_heights - sum_of_squared_surface_heights) / count +
      added_variance * width * width;
  return std::min (
      std::sqrt (sum_of_squared_surface_heights / count / residual_variance),
      place_constants.max_bend);
}

/** \brief The border of a region. A link leads from a place of the region to a neighbor
 * of that place outside of the region. */
struct Border {
  double links = 0.0;      // their number
  double open_links = 0.0; // number of those to places in no region or in a small one
  /** \brief Sum over smooth links of the bend of the region that the link leads to. */
  double sum_of_smooth_bends = 0.0;
};

// Whether a link is smooth: a round surface may continue over it from plane own to
// plane other. The link must run along plane own rather than away from it. The angle
// between the planes must be neither small, as between pieces of one plane, nor large,
// as at an edge. The limits were chosen by hand.
// \param[in] link vector from the place in region own to its neighbor
bool
isSmooth (const Plane& own, const Plane& other, const Eigen::Vector3d& link)
{
  constexpr double max_slope = 0.7; // sine of the angle of the link to the plane
  constexpr double min_angle = 4.0 * (M_PI / 180.0);
  constexpr double max_angle = 35.0 * (M_PI / 180.0);
  const double cosine = std::abs (own.normal.dot (other.normal));
  return std::abs (own.normal.dot (link)) < max_slope * link.norm() &&
         cosine < std::cos (min_angle) && cosine > std::cos (max_angle);
}

// Returns the border of one region.
// \param[in] members the places of each region
// \param[in] bend of each region, RegionEvidence::bend
// \param[in] region its index
Border
borderOf (const Places& places,
          const ChosenSupports& chosen,
          const Regions& regions,
          const std::vector<Indices>& members,
          const std::vector<double>& bend,
          std::size_t region)
{
  Border border;
  for (const std::uint32_t place : members[region])
    for (std::size_t k = 0; k < places.neighbors_per_place; ++k) {
      const std::uint32_t neighbor = places.nearestOf (place)[k];
      const std::int32_t other = regions.of_place[neighbor];
      if (other == static_cast<std::int32_t> (region))
        continue;
      border.links += 1.0;
      if (other == no_plane || members[other].size() < min_places_of_neighbor)
        border.open_links += 1.0;
      if (other != no_plane && chosen.is_flat[neighbor] != 0 &&
          isSmooth (regions.list[region].fit.plane,
                    regions.list[other].fit.plane,
                    places.position[neighbor] - places.position[place]))
        border.sum_of_smooth_bends += bend[other];
    }
  return border;
}

// Returns the evidence for and against a region being a plane.
// \param[in] points number of places of the region
// \param[in] points_of_cloud number of points of the whole cloud
// \param[in] bend,border those of the region
RegionEvidence
evidenceOf (double points, double points_of_cloud, double bend, const Border& border)
{
  RegionEvidence evidence;
  evidence.size = std::log10 (points + 1.0) - 0.5 * std::log10 (points_of_cloud + 1.0);
  evidence.bend = bend;
  if (border.links > 0.0) {
    evidence.smooth_border = border.sum_of_smooth_bends / border.links;
    evidence.open_border = border.open_links / border.links;
  }
  return evidence;
}

} // namespace

double
RegionEvidence::sum() const
{
  // Keeps the logarithm finite. Chosen by hand: much smaller bends count alike.
  constexpr double least_bend = 0.1;
  return place_constants.evidence_constant + place_constants.evidence_of_size * size +
         place_constants.evidence_of_bend * std::log (least_bend + bend) +
         place_constants.evidence_of_smooth_border * smooth_border +
         place_constants.evidence_of_open_border * open_border;
}

std::vector<char>
planesAmong (const Places& places,
             const PlaceNoise& noise,
             const ChosenSupports& chosen,
             const Regions& regions,
             double min_points_factor,
             unsigned threads)
{
  const std::vector<Indices> members = membersOf (regions);
  const double min_points = min_points_factor * place_constants.min_independent_points *
                            noise.cloud.common_errors;
  std::vector<double> bend (members.size());
  // Each piece of the loops is one region: the begin of the piece is its index.
  constexpr std::size_t one_region = 1;
  parallelFor (
      threads, members.size(), one_region, [&] (std::size_t region, std::size_t) {
        bend[region] = bendOf (places, regions.list[region], members[region]);
      });
  std::vector<char> is_plane (members.size(), 0);
  parallelFor (
      threads, members.size(), one_region, [&] (std::size_t region, std::size_t) {
        const auto points = static_cast<double> (members[region].size());
        const std::ptrdiff_t flat_places = std::count_if (
            members[region].begin(), members[region].end(), [&] (std::uint32_t place) {
              return chosen.is_flat[place] != 0;
            });
        if (points < min_points || flat_places < place_constants.min_flat_places)
          return;
        const RegionEvidence evidence =
            evidenceOf (points,
                        noise.cloud.points,
                        bend[region],
                        borderOf (places, chosen, regions, members, bend, region));
        is_plane[region] = evidence.sum() > 0.0 ? 1 : 0;
      });
  return is_plane;
}

} // namespace pcl_ops::internal
