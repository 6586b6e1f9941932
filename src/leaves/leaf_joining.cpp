// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/leaf_joining.h"

#include "leaves/leaf_noise.h"
#include "leaves/plane_contacts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_ops::internal {

namespace {

// Of two noises the larger counts at most as this many times the smaller: a bush
// explains no distance from a clean ground.
constexpr double max_unlike = 2.4;

double
squared (double number)
{
  return number * number;
}

double
commonNoise (double own, double other)
{
  return std::min (std::max (own, other), max_unlike * std::min (own, other));
}

/** \brief The planes of one pass, as they were when it began. */
struct JoiningPass {
  const LeafPlanes& planes;
  const PlaneContacts& contacts;
  const JoiningParameters& parameters;
  std::vector<Moments> moments;
  std::vector<double> rms = {};
  /** \brief Planes with points, the smallest first. */
  std::vector<std::int32_t> by_size = {};
  /** \brief The plane each goes into; itself: none. */
  Labels into = {};

  JoiningPass (const LeafCloud& cloud,
               const LeafPlanes& planes_of_pass,
               const PlaneContacts& contacts_of_pass,
               const JoiningParameters& joining)
  : planes (planes_of_pass)
  , contacts (contacts_of_pass)
  , parameters (joining)
  , moments (momentsOfPlanes (cloud, planes_of_pass))
  , rms (moments.size(), 0.0)
  , into (moments.size())
  {
    std::iota (into.begin(), into.end(), 0);
    for (std::size_t p = 0; p < moments.size(); ++p) {
      constexpr double min_points = 3.0;
      if (moments[p].count < min_points)
        continue;
      // Coordinates without noise are rounded.
      constexpr double squared_rounding = 1e-12;
      rms[p] =
          std::sqrt (std::max (meanSquaredDistance (moments[p], planes.planes[p]),
                               squared_rounding * moments[p].covariance().trace()));
      by_size.push_back (static_cast<std::int32_t> (p));
    }
    std::sort (by_size.begin(), by_size.end(), [this] (auto a, auto b) {
      return isSmaller (a, b);
    });
  }

  bool
  isSmaller (std::int32_t a, std::int32_t b) const
  {
    return moments[a].count < moments[b].count ||
           (moments[a].count == moments[b].count && a > b);
  }

  /** \brief Joins each plane, the smallest first, with the best of the larger ones.
   * \return whether any was */
  bool
  joinAll ()
  {
    std::vector<char> has_taken (moments.size(), 0);
    bool has_joined = false;
    for (std::size_t place = 0; place < by_size.size(); ++place) {
      const std::int32_t own = by_size[place];
      if (has_taken[own] != 0)
        continue;
      std::int32_t best = bestInContact (own);
      if (best == no_plane && parameters.joins_over_gaps)
        best = bestOverGaps (place);
      if (best == no_plane)
        continue;
      into[own] = best;
      has_taken[best] = 1;
      has_joined = true;
    }
    return has_joined;
  }

private:
  std::int32_t
  bestInContact (std::int32_t own) const
  {
    std::int32_t best = no_plane;
    double least = 1.0;
    for (const PlaneContact* contact = contacts.begin (own);
         contact != contacts.end (own);
         ++contact) {
      const std::int32_t to = contact->to;
      if (isSmaller (to, own) || into[to] != to)
        continue;
      const double misfit = misfitInContact (own, *contact);
      if (misfit < least) {
        least = misfit;
        best = to;
      }
    }
    return best;
  }

  // Squared distance of two planes that touch in units of what makes them one; 1 and
  // more: they are two.
  double
  misfitInContact (std::int32_t own, const PlaneContact& contact) const
  {
    // A step of so many times the scatter of the leaves beside it parts planes.
    constexpr double max_step = 6.0;
    constexpr double apart = 1.0;
    if (contact.squared_distance > squared (max_step) * contact.squared_grain)
      return apart;
    return std::min ({misfitOfCoplanar (own, contact),
                      misfitOfEnclosed (own, contact),
                      misfitOfBent (own, contact),
                      misfitOfClean (own, contact)});
  }

  double
  squaredDistance (std::int32_t own, const PlaneContact& contact) const
  {
    return meanSquaredDistance (moments[own], planes.planes[contact.to]);
  }

  static double
  noiseThere (const PlaneContact& contact)
  {
    return std::sqrt (contact.squared_noise / contact.links);
  }

  bool
  areWithin (std::int32_t own, std::int32_t to, double angle) const
  {
    return cosineBetween (planes.planes[own], planes.planes[to]) > std::cos (angle);
  }

  // Noise divided them.
  double
  misfitOfCoplanar (std::int32_t own, const PlaneContact& contact) const
  {
    constexpr double max_angle = 6.0 * M_PI / 180.0;
    if (!areWithin (own, contact.to, max_angle))
      return 1.0;
    const double noise = commonNoise (rms[own], noiseThere (contact));
    return squaredDistance (own, contact) / squared (parameters.max_distance * noise);
  }

  // Most of the smaller one's border is with the other.
  double
  misfitOfEnclosed (std::int32_t own, const PlaneContact& contact) const
  {
    constexpr double min_share = 0.68;
    constexpr double max_size = 0.2;
    constexpr double max_distance = 3.9;
    if (contact.links <= min_share * contacts.border (own) ||
        moments[own].count >= max_size * moments[contact.to].count)
      return 1.0;
    const double noise = commonNoise (rms[own], noiseThere (contact));
    return squaredDistance (own, contact) / squared (max_distance * noise);
  }

  // Pieces of one bent surface meet at a common border.
  double
  misfitOfBent (std::int32_t own, const PlaneContact& contact) const
  {
    constexpr double max_angle = 6.6 * M_PI / 180.0;
    constexpr double min_links = 6.0;
    constexpr double max_distance = 2.0;
    if (contact.links < min_links || !areWithin (own, contact.to, max_angle))
      return 1.0;
    const double there = noiseThere (contact);
    const double noise = std::max (there, std::min (rms[own], max_unlike * there));
    return contact.squared_distance / contact.links / squared (max_distance * noise);
  }

  // Near the other plane, and not much noisier than it, at any angle.
  double
  misfitOfClean (std::int32_t own, const PlaneContact& contact) const
  {
    constexpr double max_noisier = 2.0;
    constexpr double max_distance = 1.5;
    const double there = noiseThere (contact);
    if (rms[own] > max_noisier * there)
      return 1.0;
    return squaredDistance (own, contact) /
           squared (max_distance * std::max (rms[own], there));
  }

  // Of planes that do not touch, the nearest of the larger ones.
  std::int32_t
  bestOverGaps (std::size_t place) const
  {
    const std::int32_t own = by_size[place];
    std::int32_t best = no_plane;
    double least = 1.0;
    for (std::size_t other = by_size.size() - 1; other > place; --other) {
      const std::int32_t to = by_size[other];
      if (into[to] != to || !areWithin (own, to, parameters.max_angle_over_gaps))
        continue;
      const double noise = commonNoise (rms[own], rms[to]);
      const double misfit = meanSquaredDistance (moments[own], planes.planes[to]) /
                            squared (parameters.max_distance_over_gaps * noise);
      if (misfit < least) {
        least = misfit;
        best = to;
      }
    }
    return best;
  }
};

// Gives leaves the plane that theirs went into; returns the planes that changed.
std::vector<char>
applyJoins (const Labels& into, LeafPlanes& planes)
{
  std::vector<char> changed (into.size(), 0);
  Labels last (into.size());
  for (std::size_t p = 0; p < into.size(); ++p) {
    std::int32_t to = static_cast<std::int32_t> (p);
    while (into[to] != to)
      to = into[to];
    last[p] = to;
    if (to != static_cast<std::int32_t> (p)) {
      changed[p] = 1;
      changed[to] = 1;
    }
  }
  for (std::int32_t& plane : planes.plane_of_leaf)
    if (plane != no_plane)
      plane = last[plane];
  return changed;
}

} // namespace

void
joinPlanes (const LeafCloud& cloud,
            const JoiningParameters& parameters,
            unsigned threads,
            LeafPlanes& planes)
{
  constexpr int max_passes = 6;
  PlaneContacts contacts (cloud, planes, threads);
  for (int pass = 0; pass < max_passes; ++pass) {
    JoiningPass joining (cloud, planes, contacts, parameters);
    if (!joining.joinAll())
      return;
    const std::vector<char> changed = applyJoins (joining.into, planes);
    refitPlanes (cloud, planes);
    measureNoise (cloud, threads, planes, &changed);
    contacts.update (cloud, planes, changed);
  }
}

} // namespace pcl_ops::internal
