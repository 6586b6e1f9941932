// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/place_noise.h"

#include "base/parallel.h"
#include "ops/constants.h"
#include "ops/usual_noise.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_ops::internal {

namespace {

constexpr int no_level = -1;

bool
isExactSupport (const Support& support)
{
  return !(support.scatter > place_constants.max_exact * support.width);
}

// The largest support before the surface bends, if from some flat one on they do not
// thicken.
int
levelSupport (const Places& places, std::size_t place)
{
  int level = no_level;
  float first = 0.0F;
  for (std::size_t l = 1; l < places.supports.size(); ++l) {
    const Support& support = places.supports[l][place];
    if (level == no_level) {
      const float before = places.supports[l - 1][place].scatter + least_noise;
      if (!support.is_flat ||
          !(support.scatter < place_constants.max_thickening * before))
        continue;
      first = support.scatter;
    }
    else if (!(support.scatter < place_constants.max_thickening_of_all * first))
      break;
    level = static_cast<int> (l);
  }
  return level;
}

// By how much supports of each level grow until they are level: what a quarter of the
// places with level supports exceeds least. Places of one sensor grow alike; those of
// hills and woods do not, and most of the flat ones among them not at all.
std::vector<double>
growthOf (const Places& places, const std::vector<int>& level_support)
{
  const std::size_t levels = places.supports.size();
  std::vector<std::vector<float>> growth (levels);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const int level = level_support[i];
    if (level == no_level || isExactSupport (places.supports[level][i]))
      continue;
    for (std::size_t l = 0; l < levels; ++l)
      growth[l].push_back (static_cast<int> (l) < level
                               ? places.supports[level][i].scatter /
                                     (places.supports[l][i].scatter + least_noise)
                               : 1.0F);
  }
  // Few places decide little.
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

// Parts of n points of a flat patch scatter by 1 - 3 nu / n of what it does, if nu
// points err as one.
double
commonErrors (const Places& places, const std::vector<double>& growth)
{
  constexpr double least_share = 0.3;
  for (std::size_t l = 0; l < growth.size(); ++l) {
    const double share = 1.0 / (growth[l] * growth[l]);
    if (share > least_share)
      return std::max (1.0, (1.0 - share) * places.points_of_level[l] / 3.0);
  }
  return 1.0;
}

// The least that any support of a place speaks for: what bends scatters by too much.
std::vector<float>
leastScatter (const Places& places,
              const std::vector<int>& level_support,
              const PlaceNoise& noise,
              unsigned threads)
{
  std::vector<float> scatter (places.size());
  forEach (threads, places.size(), [&] (std::size_t i) {
    double least = places.supports[0][i].scatter * noise.growthOf (0);
    for (std::size_t l = 1; l < places.supports.size(); ++l)
      least = std::min (least, places.supports[l][i].scatter * noise.growthOf (l));
    if (level_support[i] != no_level)
      least = std::min<double> (least, places.supports[level_support[i]][i].scatter);
    scatter[i] = static_cast<float> (least);
  });
  return scatter;
}

// The geometric mean over a place and some of its neighbors.
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

// Whether the smallest support that is flat, of those of some levels, is not exact.
bool
tellsNoise (const Places& places, std::size_t place, std::size_t levels)
{
  for (std::size_t l = 0; l < levels; ++l)
    if (places.supports[l][place].is_flat)
      return !isExactSupport (places.supports[l][place]);
  return false;
}

// What is usual by density, of the places that tell.
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

// No place is far from what is usual where points are as dense: leaves and edges
// scatter by more, and some places by chance by less.
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

// The least sum of squares about the means of two groups of sorted values, over that
// about the mean of all.
double
restOfTwoGroups (const std::vector<double>& sorted)
{
  constexpr std::size_t least = 3; // values of a group
  const auto number = static_cast<double> (sorted.size());
  const double sum = std::accumulate (sorted.begin(), sorted.end(), 0.0);
  double between = 0.0;
  double first = 0.0;
  for (std::size_t k = 0; k + least < sorted.size(); ++k) {
    first += sorted[k];
    const auto in_first = static_cast<double> (k + 1);
    if (k + 1 < least)
      continue;
    const double apart = first / in_first - (sum - first) / (number - in_first);
    between =
        std::max (between, in_first * (number - in_first) / number * apart * apart);
  }
  double squares = -sum * sum / number;
  for (const double value : sorted)
    squares += value * value;
  return squares > 0.0 ? 1.0 - between / squares : 1.0;
}

// The flattest support of a place whose nearest points are in two layers: the sides of
// a wall that is thinner than points are apart scatter by far more than their noise,
// and only larger supports know where the wall goes. 0 if there are no layers.
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
  return restOfTwoGroups (offset) < place_constants.max_rest_of_layers ? flattest : 0;
}

} // namespace

PlaceNoise
noiseOfPlaces (const Places& places,
               const std::optional<CloudNoise>& whole,
               unsigned threads)
{
  std::vector<int> level_support (places.size());
  forEach (threads, places.size(), [&] (std::size_t i) {
    level_support[i] = levelSupport (places, i);
  });
  PlaceNoise noise;
  if (whole)
    noise.cloud = *whole;
  else {
    noise.cloud.points = static_cast<double> (places.size());
    noise.cloud.growth = growthOf (places, level_support);
    noise.cloud.common_errors = commonErrors (places, noise.cloud.growth);
  }
  noise.of_place =
      smoothed (places, leastScatter (places, level_support, noise, threads), threads);
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
