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

// Regions with fewer places are scraps: a border with a scrap is open.
constexpr std::size_t min_places_of_neighbor = 12;

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

// Returns RegionEvidence::bend. Fits a quadratic surface to the places of a region by
// least squares: its height over the plane of the region is a sum of the terms 1, s, t,
// s^2, s t, t^2, with coordinates s and t in the plane in units of the width. Returns
// the rms height of that surface divided by the rms residual, at most max_bend.
double
bendOf (const Places& places, const Region& region, const Indices& members)
{
  constexpr std::size_t terms = 6;
  constexpr double ridge = 1e-9; // keeps the system solvable for a line
  // Added to the residual variance, in units of the squared width: exact places have
  // no residuals. With 1e-4, the square of join_bend_of_width, the F-score in streets
  // falls from .77 to .69 because of false planes.
  constexpr double added_variance = 1e-6;
  using NormalMatrix = Eigen::Matrix<double, terms, terms>;
  using Vector = Eigen::Matrix<double, terms, 1>;
  if (members.size() < terms)
    return 0.0;
  const Eigen::Vector3d& normal = region.fit.plane.normal;
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross (u);
  constexpr double least_width = 1e-12; // [m], keeps quotients finite
  const double width = region.width() + least_width;
  NormalMatrix products = NormalMatrix::Zero();
  Vector right_side = Vector::Zero();
  double squared_heights = 0.0;
  for (const std::uint32_t place : members) {
    const Eigen::Vector3d from_center = places.position[place] - region.fit.centroid;
    const double s = from_center.dot (u) / width;
    const double t = from_center.dot (v) / width;
    const double height = from_center.dot (normal);
    Vector row;
    row << 1.0, s, t, s * s, s * t, t * t;
    products += row * row.transpose();
    right_side += row * height;
    squared_heights += height * height;
  }
  const auto count = static_cast<double> (members.size());
  products.diagonal().array() += ridge * count;
  const Vector surface = products.ldlt().solve (right_side);
  const double squared_surface_heights =
      std::clamp (surface.dot (right_side), 0.0, squared_heights);
  const double residual_variance = (squared_heights - squared_surface_heights) / count +
                                   added_variance * width * width;
  return std::min (std::sqrt (squared_surface_heights / count / residual_variance),
                   place_constants.max_bend);
}

/** \brief The border of a region. A link leads from a place of the region to a neighbor
 * of that place outside of the region. */
struct Border {
  double links = 0.0;      // their number
  double open_links = 0.0; // number of links to places in no region, or in a scrap
  /** \brief Sum over smooth links of the bend of the region that the link leads to. */
  double sum_of_smooth_bends = 0.0;
};

// Whether a link is smooth: a round surface may continue over it from one plane to
// another. The link must run along the first plane rather than away from it, and the
// angle between the planes must be neither small nor large.
// \param[in] link vector from the place in the first plane to the other place
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
// \param[in] bend of each region
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
    for (std::size_t k = 0; k < places.neighbors; ++k) {
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

// \param[in] points number of points of the region
// \param[in] cloud the number of points and the common errors of the whole cloud
RegionEvidence
evidenceOf (double points, const CloudNoise& cloud, double bend, const Border& border)
{
  RegionEvidence evidence;
  evidence.size =
      std::log10 (points + 1.0) - 0.5 * std::log10 (cloud.points + 1.0) -
      place_constants.common_error_exponent * std::log10 (cloud.common_errors);
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
  constexpr double least_bend = 0.1; // keeps the logarithm finite
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
  // Each piece of the loops is one region, so that its begin is the index.
  parallelFor (threads, members.size(), 1, [&] (std::size_t region, std::size_t) {
    bend[region] = bendOf (places, regions.list[region], members[region]);
  });
  std::vector<char> is_plane (members.size(), 0);
  parallelFor (threads, members.size(), 1, [&] (std::size_t region, std::size_t) {
    const auto points = static_cast<double> (members[region].size());
    const std::ptrdiff_t flat_places = std::count_if (
        members[region].begin(), members[region].end(), [&] (std::uint32_t place) {
          return chosen.is_flat[place] != 0;
        });
    if (points < min_points || flat_places < place_constants.min_flat_places)
      return;
    const RegionEvidence evidence =
        evidenceOf (points,
                    noise.cloud,
                    bend[region],
                    borderOf (places, chosen, regions, members, bend, region));
    is_plane[region] = evidence.sum() > 0.0 ? 1 : 0;
  });
  return is_plane;
}

} // namespace pcl_ops::internal
