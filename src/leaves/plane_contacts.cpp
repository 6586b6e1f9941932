// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/plane_contacts.h"

#include "base/parallel.h"
#include "geometry/principal_axes.h"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

namespace pcl_ops::internal {

namespace {

constexpr double unknown_grain = -1.0;

// Mean squared distance of the leaves of a plane around a leaf to the plane through
// them.
double
squaredGrain (const LeafCloud& cloud, const LeafPlanes& planes, std::uint32_t leaf)
{
  Moments around;
  for (const std::uint32_t k : cloud.neighbors[leaf])
    if (planes.plane_of_leaf[k] == planes.plane_of_leaf[leaf])
      around.addAligned (cloud.moments[k]);
  const double least = cloud.min_noise[leaf] * cloud.min_noise[leaf];
  if (around.count <= 3.0)
    return least;
  const double variance = principalAxes (around.covariance()).values[0];
  return std::max (least, variance * around.count / (around.count - 3.0));
}

bool
precedes (const PlaneContact& a, const PlaneContact& b)
{
  return std::make_pair (a.from, a.to) < std::make_pair (b.from, b.to);
}

/** \brief Contacts by their planes, in the order in which they are asked for. */
class ContactsByPlanes {
public:
  explicit ContactsByPlanes (std::vector<PlaneContact>& contacts) : contacts_ (contacts)
  {}

  PlaneContact&
  operator() (std::int32_t from, std::int32_t to)
  {
    // Links that follow each other are mostly of the same planes.
    if (last_ < contacts_.size() && contacts_[last_].from == from &&
        contacts_[last_].to == to)
      return contacts_[last_];
    const std::uint64_t key =
        static_cast<std::uint64_t> (from) << 32 | static_cast<std::uint32_t> (to);
    const auto [place, is_new] = place_.try_emplace (key, contacts_.size());
    if (is_new)
      contacts_.push_back ({from, to});
    last_ = place->second;
    return contacts_[last_];
  }

private:
  std::vector<PlaneContact>& contacts_;
  std::unordered_map<std::uint64_t, std::size_t> place_ = {};
  std::size_t last_ = std::numeric_limits<std::size_t>::max();
};

} // namespace

PlaneContacts::PlaneContacts (const LeafCloud& cloud,
                              const LeafPlanes& planes,
                              unsigned threads,
                              ContactSums sums)
: threads_ (threads), sums_ (sums), squared_grain_ (cloud.size(), unknown_grain)
{
  for (std::uint32_t leaf = 0; leaf < cloud.size(); ++leaf) {
    const std::int32_t plane = planes.plane_of_leaf[leaf];
    if (plane == no_plane)
      continue;
    for (const std::uint32_t k : cloud.neighbors[leaf])
      if (planes.plane_of_leaf[k] != plane)
        links_.push_back ({leaf, k});
  }
  update (cloud, planes, std::vector<char> (planes.planes.size(), 1));
}

void
PlaneContacts::update (const LeafCloud& cloud,
                       const LeafPlanes& planes,
                       const std::vector<char>& changed)
{
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (planes.plane_of_leaf[i] != no_plane && changed[planes.plane_of_leaf[i]] != 0)
      squared_grain_[i] = unknown_grain;
  dropInnerLinks (planes);
  contacts_.erase (std::remove_if (contacts_.begin(),
                                   contacts_.end(),
                                   [&] (const PlaneContact& contact) {
                                     return changed[contact.from] != 0 ||
                                            changed[contact.to] != 0;
                                   }),
                   contacts_.end());
  addLinks (cloud, planes, changed);
  first_.assign (planes.planes.size() + 1, 0);
  for (const PlaneContact& contact : contacts_)
    ++first_[contact.from + 1];
  for (std::size_t p = 0; p < planes.planes.size(); ++p)
    first_[p + 1] += first_[p];
}

void
PlaneContacts::dropInnerLinks (const LeafPlanes& planes)
{
  constexpr double weight_of_open = 0.5;
  border_.assign (planes.planes.size(), 0.0);
  std::size_t kept = 0;
  for (const Link& link : links_) {
    const std::int32_t from = planes.plane_of_leaf[link.leaf];
    const std::int32_t to = planes.plane_of_leaf[link.neighbor];
    if (from == to)
      continue;
    border_[from] += to == no_plane ? weight_of_open : 1.0;
    links_[kept] = link;
    ++kept;
  }
  links_.resize (kept);
}

void
PlaneContacts::measureGrain (const LeafCloud& cloud,
                             const LeafPlanes& planes,
                             const std::vector<Link>& links)
{
  Indices leaves;
  for (const auto& [leaf, neighbor] : links)
    for (const std::uint32_t i : {leaf, neighbor})
      if (squared_grain_[i] < 0.0) {
        squared_grain_[i] = 0.0;
        leaves.push_back (i);
      }
  forEach (threads_, leaves.size(), [&] (std::size_t i) {
    squared_grain_[leaves[i]] = squaredGrain (cloud, planes, leaves[i]);
  });
}

std::vector<PlaneContact>
PlaneContacts::measured (const LeafCloud& cloud,
                         const LeafPlanes& planes,
                         const std::vector<Link>& links)
{
  std::vector<PlaneContact> contacts (links.size());
  if (sums_ == ContactSums::All)
    measureGrain (cloud, planes, links);
  forEach (threads_, links.size(), [&] (std::size_t i) {
    const auto& [leaf, neighbor] = links[i];
    PlaneContact& contact = contacts[i];
    contact.from = planes.plane_of_leaf[leaf];
    contact.to = planes.plane_of_leaf[neighbor];
    contact.links = 1.0;
    if (sums_ == ContactSums::Links)
      return;
    contact.squared_noise = planes.noise[neighbor] * planes.noise[neighbor];
    contact.squared_distance =
        0.5 *
        (meanSquaredDistance (cloud.moments[neighbor], planes.planes[contact.from]) +
         meanSquaredDistance (cloud.moments[leaf], planes.planes[contact.to]));
    contact.squared_grain = 0.5 * (squared_grain_[leaf] + squared_grain_[neighbor]);
  });
  return contacts;
}

void
PlaneContacts::addLinks (const LeafCloud& cloud,
                         const LeafPlanes& planes,
                         const std::vector<char>& changed)
{
  std::vector<Link> links;
  for (const Link& link : links_) {
    const std::int32_t from = planes.plane_of_leaf[link.leaf];
    const std::int32_t to = planes.plane_of_leaf[link.neighbor];
    if (to != no_plane && (changed[from] != 0 || changed[to] != 0))
      links.push_back (link);
  }
  std::vector<PlaneContact> added;
  ContactsByPlanes contactOf (added);
  // Sums of a pair are taken in the order of the leaves.
  for (const PlaneContact& of_link : measured (cloud, planes, links)) {
    PlaneContact& sum = contactOf (of_link.from, of_link.to);
    sum.links += of_link.links;
    sum.squared_noise += of_link.squared_noise;
    sum.squared_distance += of_link.squared_distance;
    sum.squared_grain += of_link.squared_grain;
  }
  contacts_.insert (contacts_.end(), added.begin(), added.end());
  std::sort (contacts_.begin(), contacts_.end(), precedes);
}

} // namespace pcl_ops::internal
