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
constexpr std::size_t min_places = 12;

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

// Fits a quadratic surface to the places of a region by least squares. Returns the rms
// height of that surface over the rms residual, at most max_bend. Heights are over the
// plane of the region. The terms are 1, s, t, s^2, s t, t^2 with coordinates s and t in
// the plane in units of the width.
double
bendOf (const Places& places, const Region& region, const Indices& members)
{
  constexpr std::size_t terms = 6;
  constexpr double ridge = 1e-9; // keeps the system solvable for a line
  // Least residual variance in units of the squared width, as exact places have no
  // residuals. With 1e-4, the square of join_bend_of_width, F in streets falls from .77
  // to .69 because of false planes.
  constexpr double least_rest = 1e-6;
  using NormalMatrix = Eigen::Matrix<double, terms, terms>;
  using Vector = Eigen::Matrix<double, terms, 1>;
  if (members.size() < terms)
    return 0.0;
  const Eigen::Vector3d& normal = region.fit.plane.normal;
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross (u);
  const double width = region.width() + 1e-12;
  NormalMatrix products = NormalMatrix::Zero();
  Vector right = Vector::Zero();
  double squares = 0.0;
  for (const std::uint32_t place : members) {
    const Eigen::Vector3d from_center = places.position[place] - region.fit.centroid;
    const double s = from_center.dot (u) / width;
    const double t = from_center.dot (v) / width;
    const double height = from_center.dot (normal);
    Vector row;
    row << 1.0, s, t, s * s, s * t, t * t;
    products += row * row.transpose();
    right += row * height;
    squares += height * height;
  }
  const auto number = static_cast<double> (members.size());
  products.diagonal().array() += ridge * number;
  const Vector surface = products.ldlt().solve (right);
  const double explained = std::clamp (surface.dot (right), 0.0, squares);
  const double rest = (squares - explained) / number + least_rest * width * width;
  return std::min (std::sqrt (explained / number / rest), place_constants.max_bend);
}

/** \brief Counts of links, from a place of a region to a neighbor outside of it. */
struct Border {
  double links = 0.0;
  double open = 0.0; // links to places in no region, or in a scrap
  /** \brief Sum over smooth links of the bend of the region that the link leads to. */
  double bend_of_smooth = 0.0;
};

// Whether a round surface may continue from one plane to another over a link between
// places. The step must run along the first plane rather than away from it, and the
// angle between the planes must be neither small nor large.
bool
isSmooth (const Plane& own, const Plane& other, const Eigen::Vector3d& step)
{
  constexpr double max_slope = 0.7; // sine of the angle of the step to the plane
  constexpr double min_turn = 4.0 * (M_PI / 180.0);
  constexpr double max_turn = 35.0 * (M_PI / 180.0);
  const double cosine = std::abs (own.normal.dot (other.normal));
  return std::abs (own.normal.dot (step)) < max_slope * step.norm() &&
         cosine < std::cos (min_turn) && cosine > std::cos (max_turn);
}

// Returns the border of one region.
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
      const std::uint32_t beside = places.nearestOf (place)[k];
      const std::int32_t other = regions.of_place[beside];
      if (other == static_cast<std::int32_t> (region))
        continue;
      border.links += 1.0;
      if (other == no_plane || members[other].size() < min_places)
        border.open += 1.0;
      if (other == no_plane || chosen.is_flat[beside] == 0 ||
          !isSmooth (regions.list[region].fit.plane,
                     regions.list[other].fit.plane,
                     places.position[beside] - places.position[place]))
        continue;
      border.bend_of_smooth += bend[other];
    }
  return border;
}

// \param[in] points number of points of the region
RegionEvidence
evidenceOf (double points,
            double all_points,
            double common_errors,
            double bend,
            const Border& border)
{
  RegionEvidence evidence;
  evidence.size = std::log10 (points + 1.0) - 0.5 * std::log10 (all_points + 1.0) -
                  place_constants.common_error_exponent * std::log10 (common_errors);
  evidence.bend = bend;
  if (border.links > 0.0) {
    evidence.smooth_border = border.bend_of_smooth / border.links;
    evidence.open_border = border.open / border.links;
  }
  return evidence;
}

} // namespace

double
RegionEvidence::sum() const
{
  constexpr double least_bend = 0.1; // keeps the logarithm finite
  return place_constants.evidence + place_constants.evidence_of_size * size +
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
  parallelFor (threads, members.size(), 1, [&] (std::size_t region, std::size_t) {
    bend[region] = bendOf (places, regions.list[region], members[region]);
  });
  std::vector<char> is_plane (members.size(), 0);
  parallelFor (threads, members.size(), 1, [&] (std::size_t region, std::size_t) {
    const auto points = static_cast<double> (members[region].size());
    const auto flat = std::count_if (
        members[region].begin(), members[region].end(), [&] (std::uint32_t place) {
          return chosen.is_flat[place] != 0;
        });
    if (points < min_points || flat < place_constants.min_flat_places)
      return;
    const RegionEvidence evidence =
        evidenceOf (points,
                    noise.cloud.points,
                    noise.cloud.common_errors,
                    bend[region],
                    borderOf (places, chosen, regions, members, bend, region));
    is_plane[region] = evidence.sum() > 0.0 ? 1 : 0;
  });
  return is_plane;
}

} // namespace pcl_ops::internal
