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

// Stands for the settled level of a place without a settled support.
constexpr int no_level = -1;

bool
isExactSupport (const Support& support)
{
  return !(support.scatter > place_constants.max_exact * support.width);
}

// Returns the level of the largest settled support of a place, or no_level. The first
// settled support is flat and scatters by little more than that of the level before.
// Larger ones are settled, too, until they scatter by much more than the first: there
// the surface bends.
int
settledLevelOf (const Places& places, std::size_t place)
{
  int settled = no_level;
  float scatter_of_first = 0.0F;
  for (std::size_t level = 1; level < places.supports.size(); ++level) {
    const Support& support = places.supports[level][place];
    if (settled == no_level) {
      const float before = places.supports[level - 1][place].scatter + least_noise;
      if (!support.is_flat ||
          !(support.scatter < place_constants.max_thickening * before))
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

// Returns for each level the factor from the scatter of a support to that of a settled
// one: the lower quartile over the places with settled supports. The factors of places
// from one sensor are alike. On hills and in woods they differ, and most flat places
// there have a factor of 1.
std::vector<double>
growthOf (const Places& places, const std::vector<int>& settled_level)
{
  const std::size_t levels = places.supports.size();
  std::vector<std::vector<float>> growth (levels);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const int settled = settled_level[i];
    if (settled == no_level || isExactSupport (places.supports[settled][i]))
      continue;
    for (std::size_t level = 0; level < levels; ++level)
      growth[level].push_back (
          static_cast<int> (level) < settled
              ? places.supports[settled][i].scatter /
                    (places.supports[level][i].scatter + least_noise)
              : 1.0F);
  }
  // The fewer places tell the growth, the closer to 1 (no growth) it is set.
  const double share =
      static_cast<double> (growth[0].size()) / static_cast<double> (places.size());
  const double weight = std::min (1.0, share / place_constants.share_of_level_places);
  std::vector<double> of_level;
  for (std::vector<float>& values : growth)
    of_level.push_back (std::pow (
        std::max<double> (1.0, quantileOf (values, place_constants.growth_quantile)),
        weight));
  return of_level;
}

// Returns nu, how many neighboring points err as one. The variance of n points of a
// flat patch about their own plane fit, with three parameters, is 1 - 3 nu / n times
// that of the patch. So nu follows from the growth of the smallest supports for which
// this factor is above least_share.
double
commonErrors (const Places& places, const std::vector<double>& growth)
{
  constexpr double parameters_of_plane = 3.0;
  constexpr double least_share = 0.3; // below, nearly all points err as one
  for (std::size_t level = 0; level < growth.size(); ++level) {
    const double share = 1.0 / (growth[level] * growth[level]);
    if (share > least_share)
      return std::max (
          1.0, (1.0 - share) * places.points_of_level[level] / parameters_of_plane);
  }
  return 1.0;
}

// Returns for each place the smallest noise [m] that its supports suggest: the scatter
// of a support times its growth up to settled supports. Takes the smallest, as large
// supports overestimate the noise of surfaces that bend.
std::vector<float>
leastScatter (const Places& places,
              const std::vector<int>& settled_level,
              const PlaceNoise& noise,
              unsigned threads)
{
  std::vector<float> scatter (places.size());
  forEach (threads, places.size(), [&] (std::size_t i) {
    double least = places.supports[0][i].scatter * noise.growthOf (0);
    for (std::size_t level = 1; level < places.supports.size(); ++level)
      least =
          std::min (least, places.supports[level][i].scatter * noise.growthOf (level));
    if (settled_level[i] != no_level)
      least = std::min<double> (least, places.supports[settled_level[i]][i].scatter);
    scatter[i] = static_cast<float> (least);
  });
  return scatter;
}

// Returns the geometric mean of the noise over each place and eight of its neighbors,
// near and far ones; if it has fewer than eight, some count twice.
std::vector<float>
smoothed (const Places& places, const std::vector<float>& noise, unsigned threads)
{
  constexpr std::size_t others = 8;
  std::vector<float> logarithm (noise.size());
  forEach (threads, noise.size(), [&] (std::size_t i) {
    logarithm[i] = std::log (noise[i] + least_noise);
  });
  std::vector<float> mean (noise.size());
  forEach (threads, noise.size(), [&] (std::size_t i) {
    double sum = logarithm[i];
    for (std::size_t k = 0; k < others; ++k)
      sum += logarithm[places.nearestOf (i)[k * places.neighbors / others]];
    mean[i] = static_cast<float> (std::exp (sum / (others + 1.0)));
  });
  return mean;
}

// Whether a place has a flat support on the first levels, and the smallest flat one is
// not exact.
// \param[in] levels how many levels to look at
bool
tellsNoise (const Places& places, std::size_t place, std::size_t levels)
{
  for (std::size_t level = 0; level < levels; ++level)
    if (places.supports[level][place].is_flat)
      return !isExactSupport (places.supports[level][place]);
  return false;
}

// Sets the usual noise by density from the places that tell their noise.
void
findUsual (const Places& places, const std::vector<float>& noise, CloudNoise& cloud)
{
  std::vector<float> density;
  std::vector<float> telling;
  const auto gather = [&] (std::size_t levels) {
    for (std::size_t i = 0; i < places.size(); ++i)
      if (tellsNoise (places, i, levels)) {
        density.push_back (places.density[i]);
        telling.push_back (noise[i]);
      }
  };
  gather (1);
  if (static_cast<double> (telling.size()) <
      place_constants.min_telling_share * static_cast<double> (places.size())) {
    density.clear();
    telling.clear();
    gather (places.supports.size());
  }
  setUsualNoise (density, telling, cloud);
}

// Limits the noise of each place to a range around the usual noise at its density:
// leaves and edges scatter by more, and some places scatter by less by chance.
void
limitByUsual (const Places& places,
              const CloudNoise& cloud,
              unsigned threads,
              std::vector<float>& noise)
{
  forEach (threads, places.size(), [&] (std::size_t i) {
    const double here = usualNoise (cloud, places.density[i]);
    noise[i] = static_cast<float> (
        std::min (std::max<double> (noise[i], place_constants.min_over_usual * here),
                  place_constants.max_over_usual * here));
  });
}

// Returns the level of the flattest support of a place if its nearest points are in two
// layers, else 0. If a wall is thinner than the distance between points, its two sides
// together scatter by far more than the noise: only larger supports have the normal of
// the wall.
std::size_t
flattestOfLayers (const Places& places, std::size_t place)
{
  std::size_t flattest = 0;
  double least = 1.0;
  for (std::size_t level = 0; level < places.supports.size(); ++level) {
    const Support& support = places.supports[level][place];
    if (support.is_flat && support.scatter < least * support.width) {
      least = support.scatter / support.width;
      flattest = level;
    }
  }
  if (flattest == 0)
    return 0;
  const Eigen::Vector3d normal = places.supports[flattest][place].normal.cast<double>();
  std::vector<double> offset{0.0};
  for (std::size_t k = 0; k < places.neighbors; ++k)
    offset.push_back (normal.dot (places.position[places.nearestOf (place)[k]] -
                                  places.position[place]));
  std::sort (offset.begin(), offset.end());
  constexpr std::size_t min_of_layer = 3;
  const double rest = 1.0 - bestTwoGroups (offset, min_of_layer).explained_share;
  return rest < place_constants.max_rest_of_layers ? flattest : 0;
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
    noise.cloud.growth = growthOf (places, settled_level);
    noise.cloud.common_errors = commonErrors (places, noise.cloud.growth);
  }
  noise.of_place =
      smoothed (places, leastScatter (places, settled_level, noise, threads), threads);
  if (!whole)
    findUsual (places, noise.of_place, noise.cloud);
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
    const double limit = std::max<double> (
        place_constants.max_noises_of_support * noise.of_place[i],
        place_constants.share_of_exact * place_constants.max_exact * support.width);
    return support.scatter * noise.growthOf (level) <= limit;
  };
  forEach (threads, places.size(), [&] (std::size_t i) {
    std::size_t level = places.supports.size() - 1;
    while (level > 0 && !isExplained (i, level))
      --level;
    if (level == 0 && !isExplained (i, 0))
      level = flattestOfLayers (places, i);
    const Support& support = places.supports[level][i];
    chosen.normal[i] = support.normal.cast<double>();
    chosen.scatter[i] = support.scatter;
    chosen.width[i] = support.width;
    chosen.is_flat[i] = support.is_flat ? 1 : 0;
  });
  return chosen;
}

} // namespace pcl_ops::internal
