// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/region_joining.h"

#include "base/parallel.h"
#include "ops/constants.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl_ops::internal {

namespace {

// Fewer have no plane.
constexpr double least_points_of_join = 3.0;

bool
isLarger (const Regions& regions, std::int32_t first, std::int32_t second)
{
  const double points = regions.list[first].moments.count;
  const double other_points = regions.list[second].moments.count;
  return points != other_points ? points > other_points : first < second;
}

// Those whose pick picks nobody go into it. Returns whether any does.
bool
unite (const Labels& pick, Regions& regions)
{
  Labels into (pick.size(), no_plane);
  bool any = false;
  for (std::size_t r = 0; r < pick.size(); ++r)
    if (pick[r] != no_plane && pick[pick[r]] == no_plane) {
      into[r] = pick[r];
      any = true;
    }
  if (!any)
    return false;
  std::vector<char> has_changed (pick.size(), 0);
  for (std::size_t r = 0; r < into.size(); ++r)
    if (into[r] != no_plane) {
      regions.list[into[r]].take (regions.list[r]);
      has_changed[into[r]] = 1;
    }
  for (std::size_t r = 0; r < into.size(); ++r)
    if (has_changed[r] != 0)
      regions.list[r].refit();
  for (std::int32_t& region : regions.of_place)
    if (region != no_plane && into[region] != no_plane)
      region = into[region];
  return true;
}

// By its noise, and not by its rms: what bends would take all that goes on beside it.
double
thicknessOf (const Region& region)
{
  return std::max (region.scatter, region.noise);
}

/** \brief Places of a region beside another one. */
struct Contact {
  std::int32_t own;
  std::int32_t other;
  int places;
  /** \brief How many of them lie on the plane of the other one, too. */
  int fitting;
};

bool
isBefore (const Contact& first, const Contact& second)
{
  return first.own != second.own ? first.own < second.own : first.other < second.other;
}

// Adds a contact for each region beside a place.
void
addContacts (const Places& places,
             const Regions& regions,
             std::size_t place,
             std::vector<Contact>& contacts)
{
  const std::int32_t own = regions.of_place[place];
  const std::size_t first = contacts.size();
  for (std::size_t k = 0; k < places.neighbors; ++k) {
    const std::int32_t other = regions.of_place[places.nearestOf (place)[k]];
    const auto isOther = [=] (const Contact& contact) {
      return contact.other == other;
    };
    if (other == no_plane || other == own ||
        std::any_of (contacts.begin() + static_cast<std::ptrdiff_t> (first),
                     contacts.end(),
                     isOther))
      continue;
    const Region& region = regions.list[other];
    // The halves of a cambered road bend, too, and so lie off each other's borders.
    const double reach = 2.0 * place_constants.noises_of_join * thicknessOf (region) +
                         place_constants.bend_of_width * region.width();
    const double distance = region.fit.plane.distance (places.position[place]);
    contacts.push_back ({own, other, 1, std::abs (distance) < reach ? 1 : 0});
  }
}

/** \brief The contacts of each pair, and how many border places each region has. */
struct Borders {
  std::vector<Contact> contacts;
  std::vector<int> border_places;
};

// One contact for each pair of regions.
std::vector<Contact>
summed (std::vector<Contact> contacts)
{
  std::sort (contacts.begin(), contacts.end(), isBefore);
  std::vector<Contact> sums;
  for (const Contact& contact : contacts)
    if (!sums.empty() && !isBefore (sums.back(), contact)) {
      sums.back().places += contact.places;
      sums.back().fitting += contact.fitting;
    }
    else
      sums.push_back (contact);
  return sums;
}

/** \brief Some places that touch other regions. */
struct BorderPart {
  Indices places;
  std::vector<Contact> contacts;
};

// Of the places that touched other regions before; keeps those that still do.
Borders
bordersOf (const Places& places,
           const Regions& regions,
           unsigned threads,
           Indices& border)
{
  constexpr std::size_t at_once = 4096;
  const std::vector<BorderPart> parts = parallelChunks (
      threads, border.size(), at_once, [&] (std::size_t begin, std::size_t end) {
        BorderPart part;
        for (std::size_t i = begin; i < end; ++i) {
          const std::size_t before = part.contacts.size();
          addContacts (places, regions, border[i], part.contacts);
          if (part.contacts.size() > before)
            part.places.push_back (border[i]);
        }
        part.contacts = summed (std::move (part.contacts));
        return part;
      });
  Borders borders;
  border.clear();
  for (const BorderPart& part : parts) {
    border.insert (border.end(), part.places.begin(), part.places.end());
    borders.contacts.insert (
        borders.contacts.end(), part.contacts.begin(), part.contacts.end());
  }
  borders.contacts = summed (std::move (borders.contacts));
  borders.border_places.assign (regions.list.size(), 0);
  for (const std::uint32_t place : border)
    ++borders.border_places[regions.of_place[place]];
  return borders;
}

// Whether the points of a region lie on the plane of another one.
bool
liesOn (const Region& own, const Region& other)
{
  const double noise = std::max (thicknessOf (own), thicknessOf (other));
  const double reach = place_constants.noises_of_join * noise +
                       place_constants.bend_of_width * own.width();
  return detail::meanSquaredDistance (own.moments, other.fit.plane) <= reach * reach;
}

// Whether two regions bend little for their width, as a cambered road does: its halves
// lean away from each other by more than their noise.
bool
areNearlyFlat (const Region& own, const Region& other)
{
  Moments both = other.moments;
  both.addAligned (own.moments);
  const std::optional<PlaneFit> fit = fitPlane (both);
  if (!fit)
    return false;
  const double width = std::sqrt (squared_width_of_variance * fit->variances[1]);
  const double noise = std::max (thicknessOf (own), thicknessOf (other));
  const double limit = std::min (place_constants.noises_of_bend * noise,
                                 place_constants.join_bend_of_width * width);
  return fit->variances[0] <= limit * limit;
}

bool
areOnePlane (const Region& own, const Region& other)
{
  constexpr double points_of_normal = 24.0;
  if (own.moments.count < points_of_normal)
    return liesOn (own, other);
  const bool is_parallel =
      std::abs (own.fit.plane.normal.dot (other.fit.plane.normal)) >=
      std::cos (place_constants.join_angle);
  return is_parallel && (liesOn (own, other) || areNearlyFlat (own, other));
}

// What each region goes into, if anything.
Labels
pickTouching (const Borders& borders, const Regions& regions)
{
  Labels pick (regions.list.size(), no_plane);
  std::vector<int> best (regions.list.size(), 0);
  for (const Contact& contact : borders.contacts) {
    const auto& [own, other, border, fitting] = contact;
    if (!isLarger (regions, other, own) ||
        regions.list[own].moments.count < least_points_of_join)
      continue;
    const auto back = std::lower_bound (borders.contacts.begin(),
                                        borders.contacts.end(),
                                        Contact{other, own, 0, 0},
                                        isBefore);
    const bool is_mutual =
        back != borders.contacts.end() && back->own == other && back->other == own;
    const int fits = fitting + (is_mutual ? back->fitting : 0);
    const int all = border + (is_mutual ? back->places : 0);
    if (fits < place_constants.min_fitting_border * all ||
        fitting < place_constants.min_share_of_border * borders.border_places[own] ||
        fits <= best[own] || !areOnePlane (regions.list[own], regions.list[other]))
      continue;
    best[own] = fits;
    pick[own] = other;
  }
  return pick;
}

// How near a region is to being a piece of another one, over a gap: its points over the
// squared distance; 0 if it is none.
double
nearnessOverGap (const Region& own,
                 const Region& other,
                 double min_cosine,
                 double noises)
{
  constexpr double like = 1.5; // the noise of both
  if (std::abs (own.fit.plane.normal.dot (other.fit.plane.normal)) < min_cosine)
    return 0.0;
  // What is exact has no noise.
  const double exact = place_constants.share_of_exact * place_constants.max_exact;
  const double reach = noises * std::min (std::max (own.noise, other.noise),
                                          like * std::min (own.noise, other.noise)) +
                       exact * own.width();
  if (std::abs (other.fit.plane.distance (own.fit.centroid)) > reach)
    return 0.0;
  const double gap = (own.fit.centroid - other.fit.centroid).norm();
  if (gap > place_constants.max_gap * 0.5 * (own.length() + other.length()))
    return 0.0;
  const double apart =
      detail::meanSquaredDistance (own.moments, other.fit.plane) - own.fit.variances[0];
  return apart > reach * reach ? 0.0 : other.moments.count / (gap * gap);
}

Labels
pickOverGaps (const std::vector<std::int32_t>& large,
              const MergingParameters& merging,
              const Regions& regions)
{
  const double min_cosine = std::cos (merging.angle_threshold);
  const double noises = merging.noise_factor.value_or (place_constants.noises_of_join);
  Labels pick (regions.list.size(), no_plane);
  for (std::size_t a = 1; a < large.size(); ++a) {
    double best = 0.0;
    for (std::size_t b = 0; b < a; ++b) {
      const double nearness = nearnessOverGap (
          regions.list[large[a]], regions.list[large[b]], min_cosine, noises);
      if (nearness > best) {
        best = nearness;
        pick[large[a]] = large[b];
      }
    }
  }
  return pick;
}

// The largest first.
std::vector<std::int32_t>
largeRegions (const Regions& regions)
{
  // All pairs are looked at.
  constexpr std::size_t most = 5000;
  std::vector<std::int32_t> large;
  for (std::size_t r = 0; r < regions.list.size(); ++r)
    if (regions.list[r].moments.count >= least_points_of_join)
      large.push_back (static_cast<std::int32_t> (r));
  std::sort (large.begin(), large.end(), [&] (std::int32_t a, std::int32_t b) {
    return isLarger (regions, a, b);
  });
  large.resize (std::min (large.size(), most));
  return large;
}

} // namespace

void
joinTouching (const Places& places, unsigned threads, Regions& regions)
{
  Indices border;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (regions.of_place[i] != no_plane)
      border.push_back (static_cast<std::uint32_t> (i));
  for (int round = 0; round < place_constants.join_rounds; ++round)
    if (!unite (pickTouching (bordersOf (places, regions, threads, border), regions),
                regions))
      return;
}

void
joinOverGaps (const MergingParameters& merging, Regions& regions)
{
  for (int round = 0; round < place_constants.join_rounds; ++round)
    if (!unite (pickOverGaps (largeRegions (regions), merging, regions), regions))
      return;
}

} // namespace pcl_ops::internal
