// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/regions.h"

#include "ops/constants.h"
#include "ops/usual_noise.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl_ops::internal {

namespace {

// A region with fewer points keeps the plane that it has: any three points lie on a
// plane, so the fit to a few more says little. As min_places, chosen by hand.
constexpr double min_points_of_fit = 6.0;

/** \brief A flat place with its thickness, the scatter over the width. */
struct Seed {
  float thickness;
  std::uint32_t place;
};

// Returns the flat places, the flattest first.
std::vector<Seed>
seedsOf (const ChosenSupports& chosen)
{
  std::vector<Seed> seeds;
  for (std::size_t i = 0; i < chosen.is_flat.size(); ++i)
    if (chosen.is_flat[i] != 0)
      seeds.push_back (
          {chosen.scatter[i] / chosen.width[i], static_cast<std::uint32_t> (i)});
  std::sort (seeds.begin(), seeds.end(), [] (const Seed& first, const Seed& second) {
    return std::tie (first.thickness, first.place) <
           std::tie (second.thickness, second.place);
  });
  return seeds;
}

/** \brief Grows one region after the other, and reuses its memory. */
class RegionGrower {
public:
  RegionGrower (const Places& places,
                const PlaceNoise& noise,
                const ChosenSupports& chosen,
                std::optional<double> distance_threshold)
  : places_ (places)
  , noise_ (noise)
  , chosen_ (chosen)
  , distance_threshold_ (distance_threshold)
  {}

  /** \brief Grows a region from a seed over neighbors that are in no region yet.
   * \param[in] seed a place that is in no region yet
   * \param[in] region index of the new region
   * \param[in,out] region_of_place receives the index for each place of the region */
  Region
  grow (std::uint32_t seed, std::int32_t region, Labels& region_of_place)
  {
    start (seed);
    region_of_place[seed] = region;
    // members_ grows during the loop.
    for (std::size_t next = 0; next < members_.size(); ++next) {
      const std::uint32_t* nearest = places_.nearestOf (members_[next]);
      for (std::size_t k = 0; k < places_.neighbors_per_place; ++k)
        if (region_of_place[nearest[k]] == no_plane && fits (nearest[k])) {
          region_of_place[nearest[k]] = region;
          addAndRefit (nearest[k]);
        }
    }
    return finished();
  }

private:
  void
  start (std::uint32_t seed)
  {
    region_ = Region();
    region_.fit.plane = planeThrough (places_.position[seed], chosen_.normal[seed]);
    members_.clear();
    scatter_of_members_.clear();
    sum_of_log_noise_ = 0.0;
    rms_ = 0.0;
    width_ = chosen_.width[seed];
    points_at_last_try_ = min_points_of_refit;
    add (seed);
    region_.noise = noise_.of_place[seed];
  }

  // Whether a place may belong to the region, by its normal and its distance.
  bool
  fits (std::uint32_t place) const
  {
    const Plane& plane = region_.fit.plane;
    return std::abs (chosen_.normal[place].dot (plane.normal)) >= min_cosine_ &&
           std::abs (plane.distance (places_.position[place])) <= reach (place);
  }

  // Returns how far a place may be from the plane [m]. The rms of the region is limited
  // in units of the noise: else a region that bends would grow farther and bend more.
  double
  reach (std::uint32_t place) const
  {
    if (distance_threshold_)
      return *distance_threshold_;
    const double noise = std::min<double> (
        noise_.of_place[place], place_constants.max_noise_over_region * region_.noise);
    const double thickness =
        std::min (std::max (noise, rms_), place_constants.max_rms_over_noise * noise);
    return place_constants.noises_of_region * thickness +
           place_constants.bend_of_width * width_;
  }

  // Adds a place to the region. Tries to refit the plane if the region has grown enough
  // since the last try.
  void
  addAndRefit (std::uint32_t place)
  {
    // The middle variance must be more than this many times the smallest one. Else it
    // is not clear enough along which axis the region is thin. 4: twice as wide as
    // thick.
    constexpr double min_ratio_of_variances = 4.0;
    add (place);
    const double points = region_.moments.count;
    if (points < min_points_of_refit ||
        points <= place_constants.refit_growth * points_at_last_try_)
      return;
    points_at_last_try_ = points;
    region_.noise = meanNoise();
    const std::optional<PlaneFit> fit = fitPlane (region_.moments);
    if (!fit || fit->variances[1] <= min_ratio_of_variances * fit->variances[0])
      return;
    region_.fit = *fit;
    width_ = region_.width();
    rms_ = std::sqrt (fit->variances[0] * points / (points - parameters_of_plane));
  }

  void
  add (std::uint32_t place)
  {
    const Eigen::Vector3d& position = places_.position[place];
    region_.moments.add (position.x(), position.y(), position.z());
    members_.push_back (place);
    scatter_of_members_.push_back (chosen_.scatter[place]);
    sum_of_log_noise_ += std::log (noise_.of_place[place] + least_noise);
  }

  double
  meanNoise () const
  {
    return std::exp (sum_of_log_noise_ / static_cast<double> (members_.size()));
  }

  Region
  finished ()
  {
    constexpr double half = 0.5;
    region_.noise = meanNoise();
    region_.scatter = quantileOf (scatter_of_members_, half);
    // If the points are too few for refit(), or on a line, the region keeps this fit:
    // the plane and the width of the seed or of the last refit, and length 0. Its
    // variances do not ascend, unlike those of other fits.
    region_.fit.centroid = region_.moments.centroid();
    region_.fit.variances = {0.0, width_ * width_ / squared_width_of_variance, 0.0};
    region_.refit();
    return region_;
  }

  // The plane of fewer points would tilt because of their noise. points_at_last_try_
  // starts with this number, so that refit_growth allows the first refit at 13 points.
  static constexpr double min_points_of_refit = 12.0; // chosen by hand
  const double min_cosine_ = std::cos (place_constants.max_angle);
  const Places& places_;
  const PlaceNoise& noise_;
  const ChosenSupports& chosen_;
  std::optional<double> distance_threshold_;
  Region region_;
  Indices members_;
  std::vector<float> scatter_of_members_;
  double sum_of_log_noise_ = 0.0; // natural logarithms
  double rms_ = 0.0;              // of the last fit [m]; 0 before the first one
  double width_ = 0.0; // of the last fit, before the first one of the seed [m]
  double points_at_last_try_ = 0.0; // number of points at the last try to refit
};

} // namespace

double
Region::width() const
{
  return std::sqrt (squared_width_of_variance * fit.variances[1]);
}

double
Region::length() const
{
  return std::sqrt (squared_width_of_variance * fit.variances[2]);
}

void
Region::refit()
{
  if (moments.count < min_points_of_fit)
    return;
  if (const std::optional<PlaneFit> fitted = fitPlane (moments))
    fit = *fitted;
}

void
Region::take (Region& other)
{
  const double own_points = moments.count;
  const double taken_points = other.moments.count;
  has_parts =
      has_parts || taken_points > place_constants.min_share_of_part * own_points;
  const double share = taken_points / (own_points + taken_points);
  scatter = std::sqrt ((1.0 - share) * scatter * scatter +
                       share * other.scatter * other.scatter);
  noise = (1.0 - share) * noise + share * other.noise;
  moments.addAligned (other.moments);
  other.moments = Moments();
}

Regions
growRegions (const Places& places,
             const PlaceNoise& noise,
             const ChosenSupports& chosen,
             std::optional<double> distance_threshold)
{
  Regions regions;
  regions.of_place.assign (places.size(), no_plane);
  RegionGrower grower (places, noise, chosen, distance_threshold);
  for (const Seed& seed : seedsOf (chosen))
    if (regions.of_place[seed.place] == no_plane) {
      const auto region = static_cast<std::int32_t> (regions.list.size());
      regions.list.push_back (grower.grow (seed.place, region, regions.of_place));
    }
  return regions;
}

} // namespace pcl_ops::internal
