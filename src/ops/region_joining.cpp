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

// Regions with fewer points take no part in joins: one or two points tell no plane.
constexpr double min_points_of_join = 3.0;

// Whether the first region has more points; in case of a tie the one with the lower
// index is the larger one.
bool
isLarger (const Regions& regions, std::int32_t first, std::int32_t second)
{
  const double points = regions.list[first].moments.count;
  const double other_points = regions.list[second].moments.count;
  return points != other_points ? points > other_points : first < second;
}

// Joins each region into the region that it picks, if the picked region picks none
// itself; else the region waits for the next round.
// \param[in] pick for each region the index of the region that it picks, or no_plane
// \return whether any regions were joined
bool
joinPicked (const Labels& pick, Regions& regions)
{
  Labels joined_into (pick.size(), no_plane);
  bool has_joined = false;
  for (std::size_t r = 0; r < pick.size(); ++r)
    if (pick[r] != no_plane && pick[pick[r]] == no_plane) {
      joined_into[r] = pick[r];
      has_joined = true;
    }
  if (!has_joined)
    return false;
  std::vector<char> has_changed (pick.size(), 0);
  for (std::size_t r = 0; r < joined_into.size(); ++r)
    if (joined_into[r] != no_plane) {
      regions.list[joined_into[r]].take (regions.list[r]);
      has_changed[joined_into[r]] = 1;
    }
  for (std::size_t r = 0; r < joined_into.size(); ++r)
    if (has_changed[r] != 0)
      regions.list[r].refit();
  for (std::int32_t& region : regions.of_place)
    if (region != no_plane && joined_into[region] != no_plane)
      region = joined_into[region];
  return true;
}

// Returns how far the points of a region are from its plane because of noise [m]. The
// rms distance would not do: it includes the bend, so that a region that bends would
// take all adjacent pieces of its surface.
double
spreadOf (const Region& region)
{
  return std::max (region.scatter, region.noise);
}

/** \brief Where region own touches region other. */
struct Contact {
  std::int32_t own;   // index of the region in Regions::list
  std::int32_t other; // index of the other region
  /** \brief Number of places of region own that have a neighbor in region other and lie
   * on the plane of region other. */
  int fitting_places;
};

// Whether the first contact comes before the second one in Borders::contacts.
bool
isBefore (const Contact& first, const Contact& second)
{
  return first.own != second.own ? first.own < second.own : first.other < second.other;
}

// Adds the contacts of one place, one for each other region that its neighbors are in.
void
addContacts (const Places& places,
             const Regions& regions,
             std::size_t place,
             std::vector<Contact>& contacts)
{
  const std::int32_t own = regions.of_place[place];
  const auto first_of_place = static_cast<std::ptrdiff_t> (contacts.size());
  const auto isCounted = [&] (std::int32_t other) {
    return std::any_of (
        contacts.begin() + first_of_place,
        contacts.end(),
        [=] (const Contact& contact) { return contact.other == other; });
  };
  for (std::size_t k = 0; k < places.neighbors_per_place; ++k) {
    const std::int32_t other = regions.of_place[places.nearestOf (place)[k]];
    if (other == no_plane || other == own || isCounted (other))
      continue;
    const Region& other_region = regions.list[other];
    // Twice the noise that liesOn allows: at the border of bent regions, as the halves
    // of a cambered road, places are farther off the other plane than its points are on
    // average.
    const double noises_of_border = 2.0 * place_constants.noises_of_join;
    const double reach = noises_of_border * spreadOf (other_region) +
                         place_constants.bend_of_width * other_region.width();
    const double distance = other_region.fit.plane.distance (places.position[place]);
    contacts.push_back ({own, other, std::abs (distance) < reach ? 1 : 0});
  }
}

/** \brief Where regions touch each other. */
struct Borders {
  /** \brief Sorted by \ref isBefore. Two regions that touch have one or two contacts:
   * each of both may be Contact::own. */
  std::vector<Contact> contacts;
  /** \brief For each region how many of its places have a neighbor in another region.
   */
  std::vector<int> border_places;
};

// Sorts contacts and adds up those with the same own and other region.
std::vector<Contact>
summed (std::vector<Contact> contacts)
{
  std::sort (contacts.begin(), contacts.end(), isBefore);
  std::vector<Contact> sums;
  for (const Contact& contact : contacts)
    if (!sums.empty() && !isBefore (sums.back(), contact))
      sums.back().fitting_places += contact.fitting_places;
    else
      sums.push_back (contact);
  return sums;
}

/** \brief The places that touch other regions, and their contacts, found by one piece
 * of a parallel loop. */
struct BorderPart {
  Indices places;
  std::vector<Contact> contacts;
};

// Finds where regions touch. By a join a place can only cease to touch another region,
// so that each call looks only at the places that touched one in the call before.
// \param[in,out] border places that may touch other regions; reduced to those that do
Borders
bordersOf (const Places& places,
           const Regions& regions,
           unsigned threads,
           Indices& border)
{
  // Chosen by hand, changes only the time.
  constexpr std::size_t places_per_piece = 4096;
  const auto borderOfPiece = [&] (std::size_t begin, std::size_t end) {
    BorderPart part;
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t contacts_before = part.contacts.size();
      addContacts (places, regions, border[i], part.contacts);
      if (part.contacts.size() > contacts_before)
        part.places.push_back (border[i]);
    }
    part.contacts = summed (std::move (part.contacts));
    return part;
  };
  const std::vector<BorderPart> parts =
      parallelPieces (threads, border.size(), places_per_piece, borderOfPiece);
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

// Whether the points of region own lie on the plane of another region, by their rms
// distance.
bool
liesOn (const Region& own, const Region& other)
{
  const double noise = std::max (spreadOf (own), spreadOf (other));
  const double reach = place_constants.noises_of_join * noise +
                       place_constants.bend_of_width * own.width();
  return detail::meanSquaredDistance (own.moments, other.fit.plane) <= reach * reach;
}

// Whether two regions together bend little for their width, as the halves of a cambered
// road, which tilt against each other by more than their noise.
bool
areNearlyFlat (const Region& own, const Region& other)
{
  Moments both = other.moments;
  both.addAligned (own.moments);
  const std::optional<PlaneFit> fit = fitPlane (both);
  if (!fit)
    return false;
  const double width = std::sqrt (squared_width_of_variance * fit->variances[1]);
  const double noise = std::max (spreadOf (own), spreadOf (other));
  const double limit = std::min (place_constants.noises_of_bend * noise,
                                 place_constants.join_bend_of_width * width);
  return fit->variances[0] <= limit * limit;
}

// Whether region own is a piece of the plane of the larger region other.
bool
isPieceOf (const Region& own, const Region& other)
{
  // The normal of a region with fewer points depends much on their noise.
  constexpr double min_points_of_normal = 24.0; // chosen by hand
  if (own.moments.count < min_points_of_normal)
    return liesOn (own, other);
  const bool is_parallel =
      std::abs (own.fit.plane.normal.dot (other.fit.plane.normal)) >=
      std::cos (place_constants.join_angle);
  return is_parallel && (liesOn (own, other) || areNearlyFlat (own, other));
}

// Returns a contact plus the count of the opposite one. There may be none: a place is
// not always a neighbor of its neighbors.
// \param[in] sorted all contacts
Contact
fromBothSides (const Contact& contact, const std::vector<Contact>& sorted)
{
  const Contact opposite{contact.other, contact.own, 0};
  const auto found =
      std::lower_bound (sorted.begin(), sorted.end(), opposite, isBefore);
  if (found == sorted.end() || isBefore (opposite, *found))
    return contact;
  return {contact.own, contact.other, contact.fitting_places + found->fitting_places};
}

// Returns for each region the index of the region that it picks, or no_plane: of the
// larger regions whose plane it is a piece of, and on whose plane at least
// min_share_of_border of its border places lie that touch it, the one with most
// Contact::fitting_places, counted from both sides.
Labels
pickTouching (const Borders& borders, const Regions& regions)
{
  Labels pick (regions.list.size(), no_plane);
  std::vector<int> most_fitting_places (regions.list.size(), 0);
  for (const Contact& contact : borders.contacts) {
    const std::int32_t own = contact.own;
    const std::int32_t other = contact.other;
    if (!isLarger (regions, other, own) ||
        regions.list[own].moments.count < min_points_of_join)
      continue;
    const Contact both = fromBothSides (contact, borders.contacts);
    const bool is_much_of_border =
        contact.fitting_places >=
        place_constants.min_share_of_border * borders.border_places[own];
    if (is_much_of_border && both.fitting_places > most_fitting_places[own] &&
        isPieceOf (regions.list[own], regions.list[other])) {
      most_fitting_places[own] = both.fitting_places;
      pick[own] = other;
    }
  }
  return pick;
}

// Returns the attraction of region own by the larger region other over a gap: the
// points of other over the squared distance of the centroids [1/m^2]; 0 if own is no
// piece of the plane of other, or the centroids are farther apart than max_gap allows.
// \param[in] min_cosine of the angle between the normals
// \param[in] max_noises largest distance to the plane of other, in units of the noise
double
attractionOverGap (const Region& own,
                   const Region& other,
                   double min_cosine,
                   double max_noises)
{
  // The larger noise of the two regions counts, but at most this many times the smaller
  // one, so that a noisy region is not joined to a plane far from it. Chosen by hand.
  constexpr double max_noise_ratio = 1.5;
  if (std::abs (own.fit.plane.normal.dot (other.fit.plane.normal)) < min_cosine)
    return 0.0;
  // Regions of exact points have no noise.
  const double allowed_share_of_width =
      place_constants.share_of_exact * place_constants.max_exact_thickness;
  const double reach =
      max_noises * std::min (std::max (own.noise, other.noise),
                             max_noise_ratio * std::min (own.noise, other.noise)) +
      allowed_share_of_width * own.width();
  if (std::abs (other.fit.plane.distance (own.fit.centroid)) > reach)
    return 0.0;
  const double centroid_distance = (own.fit.centroid - other.fit.centroid).norm();
  const double mean_length = 0.5 * (own.length() + other.length());
  if (centroid_distance > place_constants.max_gap * mean_length)
    return 0.0;
  // How much more variance the points of region own have about the plane of region
  // other than about their own plane.
  const double added_variance =
      detail::meanSquaredDistance (own.moments, other.fit.plane) - own.fit.variances[0];
  if (added_variance > reach * reach)
    return 0.0;
  return other.moments.count / (centroid_distance * centroid_distance);
}

// Returns for each region the index of the region that it picks: the larger region with
// the largest attraction, or no_plane if none has an attraction above 0.
// \param[in] large indices of the regions to compare, the largest first
Labels
pickOverGaps (const std::vector<std::int32_t>& large,
              const MergingParameters& merging,
              const Regions& regions)
{
  const double min_cosine = std::cos (merging.angle_threshold);
  const double max_noises =
      merging.noise_factor.value_or (place_constants.noises_of_join);
  Labels pick (regions.list.size(), no_plane);
  for (std::size_t own_rank = 1; own_rank < large.size(); ++own_rank) {
    const std::int32_t own = large[own_rank];
    double largest_attraction = 0.0;
    for (std::size_t rank = 0; rank < own_rank; ++rank) {
      const std::int32_t other = large[rank];
      const double attraction = attractionOverGap (
          regions.list[own], regions.list[other], min_cosine, max_noises);
      if (attraction > largest_attraction) {
        largest_attraction = attraction;
        pick[own] = other;
      }
    }
  }
  return pick;
}

// Returns the indices of the 5000 largest regions, by descending number of points.
// Regions that are too small for a join are left out.
std::vector<std::int32_t>
largeRegions (const Regions& regions)
{
  // Limits the time to compare all pairs; chosen by hand.
  constexpr std::size_t max_regions = 5000;
  std::vector<std::int32_t> large;
  for (std::size_t r = 0; r < regions.list.size(); ++r)
    if (regions.list[r].moments.count >= min_points_of_join)
      large.push_back (static_cast<std::int32_t> (r));
  std::sort (large.begin(), large.end(), [&] (std::int32_t a, std::int32_t b) {
    return isLarger (regions, a, b);
  });
  large.resize (std::min (large.size(), max_regions));
  return large;
}

} // namespace

void
joinTouching (const Places& places, unsigned threads, Regions& regions)
{
  Indices border; // at first all places in a region
  for (std::size_t i = 0; i < places.size(); ++i)
    if (regions.of_place[i] != no_plane)
      border.push_back (static_cast<std::uint32_t> (i));
  bool has_joined = true;
  while (has_joined) {
    const Borders borders = bordersOf (places, regions, threads, border);
    has_joined = joinPicked (pickTouching (borders, regions), regions);
  }
}

void
joinOverGaps (const MergingParameters& merging, Regions& regions)
{
  bool has_joined = true;
  while (has_joined)
    has_joined =
        joinPicked (pickOverGaps (largeRegions (regions), merging, regions), regions);
}

} // namespace pcl_ops::internal
