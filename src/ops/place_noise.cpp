// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/place_noise.h"

#include "base/parallel.h"
#include "geometry/two_groups.h"
#include "ops/constants.h"
#include "ops/usual_noise.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// The settled level of a place without a settled support.
constexpr int no_level = -1;

// Whether the points of a support lie on its plane without noise, as in CAD models.
bool
isExactSupport (const Support& support)
{
  return !(support.scatter > place_constants.max_exact_thickness * support.width);
}

// Returns the level of the largest settled support of a place, or no_level. The first
// settled support is flat, and its scatter is little more than that of the level
// before. Larger supports are settled, too, until their scatter is much more than that
// of the first settled one: there the surface bends.
int
settledLevelOf (const Places& places, std::size_t place)
{
  int settled = no_level;
  float scatter_of_first = 0.0F;
  for (std::size_t level = 1; level < places.supports.size(); ++level) {
    const Support& support = places.supports[level][place];
    if (settled == no_level) {
      const float scatter_before =
          places.supports[level - 1][place].scatter + least_noise;
      if (!support.is_flat ||
          !(support.scatter < place_constants.max_thickening * scatter_before))
        continue;
      scatter_of_first = support.scatter;
    }
    else if (!(support.scatter <
               place_constants.max_thickening_of_all * scatter_of_first))
      break;
    settled = static_cast<int> (level);
  }
  return settled;
}

// Returns the growth of each level (PlaceConstants::growth_quantile): the scatter of
// settled supports over that of supports of the level. It is the lower quartile over
// the places whose largest settled support is not exact. The growths of places from one
// sensor are alike. On hills and in woods they differ, but most flat places there have
// a growth of 1, and so has the quartile.
std::vector<double>
growthsOf (const Places& places, const std::vector<int>& settled_level)
{
  const std::size_t levels = places.supports.size();
  std::vector<std::vector<float>> growths_of_level (levels);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const int settled = settled_level[i];
    if (settled == no_level || isExactSupport (places.supports[settled][i]))
      continue;
    for (std::size_t level = 0; level < levels; ++level)
      growths_of_level[level].push_back (
          static_cast<int> (level) < settled
              ? places.supports[settled][i].scatter /
                    (places.supports[level][i].scatter + least_noise)
              : 1.0F);
  }
  // The fewer places have such a support, the closer to 1 (no growth) are the results.
  const std::size_t settled_places = growths_of_level[0].size();
  const double share_of_settled =
      static_cast<double> (settled_places) / static_cast<double> (places.size());
  const double weight =
      std::min (1.0, share_of_settled / place_constants.full_share_of_settled);
  std::vector<double> growth;
  for (std::vector<float>& of_places : growths_of_level)
    growth.push_back (std::pow (
        std::max<double> (1.0, quantileOf (of_places, place_constants.growth_quantile)),
        weight));
  return growth;
}

// Returns nu, how many neighboring points share one error. A support of n points has a
// variance about its fitted plane of s = 1 - 3 nu / n times the squared noise, as the
// fit has three parameters. The growth of a level is 1 / sqrt (s), so that nu is
// (1 - s) n / 3. The lowest level with s above min_variance_share gives nu. This
// neglects that Support::scatter is already corrected for nu = 1.
double
commonErrorsOf (const Places& places, const std::vector<double>& growth)
{
  // Below this value of s, chosen by hand, nearly all points of a support share one
  // error.
  constexpr double min_variance_share = 0.3;
  for (std::size_t level = 0; level < growth.size(); ++level) {
    const double variance_share = 1.0 / (growth[level] * growth[level]); // s
    if (variance_share > min_variance_share)
      return std::max (1.0,
                       (1.0 - variance_share) * places.points_of_level[level] /
                           parameters_of_plane);
  }
  return 1.0;
}

// Returns for each place the smallest noise [m] that its supports suggest. A support
// suggests its scatter times the growth of its level, the largest settled one its
// scatter alone. Large supports suggest too much where the surface bends.
std::vector<float>
smallestNoises (const Places& places,
                const std::vector<int>& settled_level,
                const PlaceNoise& noise,
                unsigned threads)
{
  std::vector<float> noises (places.size());
  forEach (threads, places.size(), [&] (std::size_t i) {
    double smallest = places.supports[0][i].scatter * noise.growthOf (0);
    for (std::size_t level = 1; level < places.supports.size(); ++level)
      smallest = std::min (smallest,
                           places.supports[level][i].scatter * noise.growthOf (level));
    if (settled_level[i] != no_level)
      smallest =
          std::min<double> (smallest, places.supports[settled_level[i]][i].scatter);
    noises[i] = static_cast<float> (smallest);
  });
  return noises;
}

// Returns for each place the geometric mean of its own noise and that of eight of its
// neighbors, near and far ones. If a place has fewer than eight neighbors, some count
// twice.
// \param[in] noise of each place [m]
std::vector<float>
smoothed (const Places& places, const std::vector<float>& noise, unsigned threads)
{
  constexpr std::size_t neighbors = 8; // in even steps from the nearest; chosen by hand
  std::vector<float> logarithm (noise.size());
  forEach (threads, noise.size(), [&] (std::size_t i) {
    logarithm[i] = std::log (noise[i] + least_noise);
  });
  std::vector<float> mean (noise.size());
  forEach (threads, noise.size(), [&] (std::size_t i) {
    double sum = logarithm[i];
    for (std::size_t k = 0; k < neighbors; ++k)
      sum +=
          logarithm[places.nearestOf (i)[k * places.neighbors_per_place / neighbors]];
    mean[i] = static_cast<float> (std::exp (sum / (neighbors + 1.0)));
  });
  return mean;
}

// Whether the noise of a place counts for the usual noise: it has a flat support on a
// level below end_level, and its smallest flat support is not exact.
bool
tellsNoise (const Places& places, std::size_t place, std::size_t end_level)
{
  for (std::size_t level = 0; level < end_level; ++level)
    if (places.supports[level][place].is_flat)
      return !isExactSupport (places.supports[level][place]);
  return false;
}

// Sets CloudNoise::usual and usual_of_octave from the places that tell their noise.
// \param[in] noise of each place [m]
void
measureUsualNoise (const Places& places,
                   const std::vector<float>& noise,
                   CloudNoise& cloud)
{
  std::vector<float> telling_density; // of the places that tell their noise [1/m^2]
  std::vector<float> telling_noise;   // of the same places [m]
  const auto gatherTelling = [&] (std::size_t end_level) {
    telling_density.clear();
    telling_noise.clear();
    for (std::size_t i = 0; i < places.size(); ++i)
      if (tellsNoise (places, i, end_level)) {
        telling_density.push_back (places.density[i]);
        telling_noise.push_back (noise[i]);
      }
  };
  constexpr std::size_t end_of_smallest_level = 1; // the smallest supports alone
  gatherTelling (end_of_smallest_level);
  const bool are_few =
      static_cast<double> (telling_noise.size()) <
      place_constants.min_telling_share * static_cast<double> (places.size());
  if (are_few)
    gatherTelling (places.supports.size());
  setUsualNoise (telling_density, telling_noise, cloud);
}

// Limits the noise of each place to a range around the usual noise at its density. The
// scatter of supports is larger than the noise at leaves and edges, and at some places
// it is smaller by chance.
// \param[in,out] noise of each place [m]
void
limitByUsual (const Places& places,
              const CloudNoise& cloud,
              unsigned threads,
              std::vector<float>& noise)
{
  forEach (threads, places.size(), [&] (std::size_t i) {
    const double usual = usualNoise (cloud, places.density[i]);
    noise[i] = static_cast<float> (
        std::min (std::max<double> (noise[i], place_constants.min_over_usual * usual),
                  place_constants.max_over_usual * usual));
  });
}

// Returns the level of the flattest support of a place if its nearest points are in two
// layers, else 0. If a wall is thinner than the distance between neighboring points,
// the points of its two sides together scatter far more than the noise: only larger
// supports have the normal of the wall.
std::size_t
levelForTwoLayers (const Places& places, std::size_t place)
{
  std::size_t flattest = 0;
  double least_thickness = 1.0; // scatter over width; flat supports have less
  for (std::size_t level = 0; level < places.supports.size(); ++level) {
    const Support& support = places.supports[level][place];
    if (support.is_flat && support.scatter < least_thickness * support.width) {
      least_thickness = support.scatter / support.width;
      flattest = level;
    }
  }
  if (flattest == 0)
    return 0;
  const Eigen::Vector3d normal = places.supports[flattest][place].normal.cast<double>();
  // Offsets along the normal from the place to itself and to its neighbors [m].
  std::vector<double> offsets{0.0};
  for (std::size_t k = 0; k < places.neighbors_per_place; ++k)
    offsets.push_back (normal.dot (places.position[places.nearestOf (place)[k]] -
                                   places.position[place]));
  std::sort (offsets.begin(), offsets.end());
  // One or two points may be apart from the others by chance.
  constexpr std::size_t min_points_of_layer = 3;
  const double unexplained_by_layers =
      1.0 - bestTwoGroups (offsets, min_points_of_layer).explained_share;
  return unexplained_by_layers < place_constants.max_unexplained_by_layers ? flattest
                                                                           : 0;
}

} // namespace

PlaceNoise
noiseOfPlaces (const Places& places,
               const std::optional<CloudNoise>& whole,
               unsigned threads)
{
  std::vector<int> settled_level (places.size());
  forEach (threads, places.size(), [&] (std::size_t i) {
    settled_level[i] = settledLevelOf (places, i);
  });
  PlaceNoise noise;
  if (whole)
    noise.cloud = *whole;
  else {
    noise.cloud.points = static_cast<double> (places.size());
    noise.cloud.growth = growthsOf (places, settled_level);
    noise.cloud.common_errors = commonErrorsOf (places, noise.cloud.growth);
  }
  noise.of_place = smoothed (
      places, smallestNoises (places, settled_level, noise, threads), threads);
  if (!whole)
    measureUsualNoise (places, noise.of_place, noise.cloud);
  limitByUsual (places, noise.cloud, threads, noise.of_place);
  return noise;
}

ChosenSupports
chooseSupports (const Places& places, const PlaceNoise& noise, unsigned threads)
{
  ChosenSupports chosen;
  chosen.normal.resize (places.size());
  chosen.scatter.resize (places.size());
  chosen.width.resize (places.size());
  chosen.is_flat.resize (places.size());
  // Whether the noise explains the scatter of a support.
  const auto isExplained = [&] (std::size_t i, std::size_t level) {
    const Support& support = places.supports[level][i];
    const double limit =
        std::max<double> (place_constants.max_noises_of_support * noise.of_place[i],
                          place_constants.share_of_exact *
                              place_constants.max_exact_thickness * support.width);
    return support.scatter * noise.growthOf (level) <= limit;
  };
  forEach (threads, places.size(), [&] (std::size_t i) {
    std::size_t level = places.supports.size() - 1;
    while (level > 0 && !isExplained (i, level))
      --level;
    if (level == 0 && !isExplained (i, 0))
      level = levelForTwoLayers (places, i);
    const Support& support = places.supports[level][i];
    chosen.normal[i] = support.normal.cast<double>();
    chosen.scatter[i] = support.scatter;
    chosen.width[i] = support.width;
    chosen.is_flat[i] = support.is_flat ? 1 : 0;
  });
  return chosen;
}

} // namespace pcl_ops::internal
